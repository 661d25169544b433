# Geschichten, Bilder und die Geschichte eines anderen Raytracers vergleichen.

menu-compare = Vergleichen
compare-pin = Diese Geschichte anheften
compare-pin-about = Behält die gezeigte Geschichte, wie sie jetzt ist, um andere mit ihr zu vergleichen: ein anderer Bildpunkt, eine andere Szene, andere Einstellungen, vor und nach einer Änderung.
compare-unpin = Angeheftete entfernen
compare-unpin-about = Vergisst die angeheftete Geschichte, mit der verglichen wird.
compare-next = Nächster Unterschied
compare-next-about = Geht weiter zum nächsten Ereignis, das von der angehefteten Geschichte abweicht.
compare-previous = Voriger Unterschied
compare-previous-about = Geht zurück zum vorigen Ereignis, das von der angehefteten Geschichte abweicht.
compare-open = Mit meinem Raytracer vergleichen…
compare-open-about = Öffnet die Zeilen, die ein eigener Raytracer ausgegeben hat (JSON-Zeilen), und zeigt, wo er von diesem abweicht und warum.
compare-files = Zeilen eines Raytracers

compare-with = verglichen mit
compare-name = Name
compare-page-stories = Geschichten
compare-page-pictures = Bilder
compare-page-foreign = Anderer Raytracer
compare-nothing = Hefte eine Geschichte an; dann nimm einen anderen Bildpunkt auf, öffne eine andere Szene oder ändere eine Einstellung: hier steht, was sich unterscheidet.
compare-working = Vergleiche…
compare-no-difference = Kein Unterschied in { $events } Ereignissen.
compare-counts = { $same } gleich (=), { $changed } geändert (~), { $left } nur hier (−), { $right } nur angeheftet (+)
compare-first = Erster Unterschied: { $event }
compare-parting = Geht zuerst einen anderen Weg: { $event }
compare-go-here = Dorthin
compare-go-there = Dorthin in der angehefteten
compare-all-rows = Alle Zeilen zeigen, nicht nur die verschiedenen

compare-same = gleich
compare-changed = geändert
compare-only-here = nur hier
compare-only-there = nur angeheftet

compare-rendering = Beide Bilder werden berechnet…
compare-two-sizes = Die Bilder sind verschieden groß und lassen sich nicht übereinanderlegen.
compare-figures = Größter Unterschied eines Kanals { $largest }, quadratisches Mittel { $rmse }, { $pixels } Bildpunkte verschieden
compare-amplified = Den Unterschied zeigen, so verstärkt, dass der größte weiß ist
compare-slider = Zwischen den beiden Bildern
compare-picture = Die beiden Bilder
compare-left-side = diese Szene
compare-right-side = angeheftet

compare-foreign-about = Öffne, was ein eigener Raytracer ausgegeben hat.
compare-foreign-same = { $name }: kein Unterschied in { $stories } Geschichten, { $checks } Dinge verglichen.
compare-foreign-departs = { $name }: { $departing } von { $stories } Geschichten weichen ab, { $checks } Dinge verglichen.
compare-unreadable = { $name } lässt sich nicht lesen
compare-line = Zeile { $line }
compare-go-ours = Unsere Geschichte dort zeigen
compare-ours = hier: { $value }
compare-theirs = dort: { $value }
compare-no-cause = Kein bekannter Fehler erklärt es.
compare-cause = Wahrscheinliche Ursache: { $cause }
compare-other-cause = Oder: { $cause }
