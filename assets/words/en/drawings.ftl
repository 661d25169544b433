# The drawings that go with the selected event.

drawings-fit = Fit
drawings-overview-fit-about = Show the whole scene again. Drag to turn, with Shift to move; turn the wheel to zoom.
drawings-camera = Camera
drawings-camera-about = Look through the scene’s own camera.
drawings-parallel = Parallel
drawings-parallel-about = Look along parallel lines: equal lengths stay equal.
drawings-section = Section
drawings-section-about = Cut through the shape along the ray.
drawings-space = Space
drawings-space-about = The whole shape in space.
drawings-all-rows = All rows
drawings-all-rows-about = Fill in the whole table. Click a row, or press the arrow keys, to fill it in up to there.
drawings-t = t on the ray
drawings-clear-t = Clear t
drawings-clear-t-about = Mark no time on the ray. Drag in the plot, or press the arrow keys, to mark one.
drawings-no-generic = No primitive was asked here. Select a primitive or a hit to see the ray in its own space.
drawings-no-intervals = No object was asked here. Select an object or a hit to see its intervals.
drawings-no-signs = Select a primitive or a hit to see d(t) along the ray.
drawings-no-snell = No light is refracted here. Select a hit on something transparent.
drawings-no-shading = No colour comes back here. Select a hit, or the colour of a ray.
drawings-no-planes = No plane table was filled in here. Select a cube, a polyhedron, or another shape with flat sides.
