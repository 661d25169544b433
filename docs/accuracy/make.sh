#!/bin/sh
# Makes the figures and tables of the study anew, with the rayscope that is on the path or in $RAYSCOPE.
# Let the machine do nothing else meanwhile: it takes about ten minutes.
set -eu
cd "$(dirname "$0")"
rayscope=${RAYSCOPE:-rayscope}

for scene in \
    hard/far_torus csg/rocket primitives/superellipsoid sampling/antialiasing lens/focus spectrum/prism \
    hard/mirror_room textures/marble textures/filters textures/bumps
do
    name=$(echo "$scene" | tr / _)
    "$rayscope" accuracy "$scene" --budget 30s --single --plot "figures/$name.svg" -o "figures/$name.txt"
done

"$rayscope" accuracy lens/focus --budget 60s --plot figures/lens_focus_combined.svg -o figures/lens_focus_combined.txt
"$rayscope" accuracy hard/far_torus --pixel 130,95 -o figures/far_torus_ray.txt
"$rayscope" accuracy hard/far_torus --map digits --accuracy f32.json -o figures/far_torus_digits.svg
"$rayscope" stability --shape torus --plot distance -o figures/torus_distance.svg
