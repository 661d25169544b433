# The picture.

picture-without = without { $effects }
picture-rendering = rendering, { $percent }
