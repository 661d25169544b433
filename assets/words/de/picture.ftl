# Das Bild.

picture-without = ohne { $effects }
picture-rendering = wird berechnet, { $percent }

picture-name = Berechnetes Bild
picture-recorded = Bildpunkt ({ $x }, { $y }). Ein Klick oder die Pfeiltasten wählen einen anderen.
picture-none = Ein Klick auf einen Bildpunkt zeichnet auf, was sein Strahl tut.
