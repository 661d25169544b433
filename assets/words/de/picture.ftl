# Das Bild.

picture-without = ohne { $effects }
picture-rendering = wird berechnet, { $percent }
