#!/bin/sh
# Prints a digest of the picture and of a few recorded pixels of every embedded scene, so that two machines, or two builds,
# can be compared with `diff`: equal lines mean equal bits, for a record holds every number in its shortest round-trip form.
#
#     tests/portable/digests.sh target/release/rayscope > here.txt
#
# A second argument is the width of the pictures, 120 if there is none.
set -eu
rayscope=${1:?the program to ask}
width=${2:-120}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

"$rayscope" scenes --format json | sed -n 's/^ *"name": "\(.*\)",$/\1/p' | while read -r scene; do
    "$rayscope" render "$scene" --width "$width" -o "$folder/picture.png" 2> /dev/null
    echo "$(sha256sum < "$folder/picture.png" | cut -c1-16) $scene"
    for pixel in 100,100 320,200 333,290; do
        # A scene whose picture does not reach as far has no such pixel.
        if "$rayscope" trace "$scene" --pixel "$pixel" --format json > "$folder/trace.json" 2> /dev/null; then
            echo "$(sha256sum < "$folder/trace.json" | cut -c1-16) $scene at $pixel"
        fi
    done
done
