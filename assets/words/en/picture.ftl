# The picture.

picture-without = without { $effects }
picture-rendering = rendering, { $percent }

picture-name = Rendered image
picture-recorded = Pixel ({ $x }, { $y }). Click another, or use the arrow keys.
picture-none = Click a pixel to record what its ray does.
