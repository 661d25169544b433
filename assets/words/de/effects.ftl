# Was jeder Effekt kostet.

effects-effect = Effekt
effects-rays = Strahlen
effects-ns = ns je Bildpunkt
effects-share = Anteil
effects-without = ohne ihn
effects-difference = Unterschied
effects-measured = Gemessen bei { $size }, { $ns } ns je Bildpunkt auf einem Thread; jeder Preis ist der Median von { $pairs } Paaren, mit und ohne.
effects-measuring = Misst, was jeder Effekt kostet: { $percent } %
effects-no-thread = Was die Effekte kosten, lässt sich nicht messen: Es ließ sich kein Thread starten.
effects-rays-about = { $rays } Strahlen, die es ohne ihn nicht gäbe; sein Code wurde { $calls }-mal betreten.
effects-picture-without = Das Bild ohne ihn
effects-difference-about = Wie weit jeder Bildpunkt abweicht; der hellste um { $largest } von 255
effects-unclear = Innerhalb der eigenen Streuung: nicht von nichts zu unterscheiden.
effects-idle = Nicht verlangt: Nichts von ihrem Code läuft, und sie kosten nichts.
