# Bildpunkte danach finden, was ihren Strahlen geschehen ist, und Karten.

menu-search = Suche

search-field = Bildpunkte finden
search-hint = Bildpunkte finden, etwa tir, oder hit & depth>=2
search-find = Bildpunkte finden…
search-find-about = Bildpunkte danach finden, was ihren Strahlen geschehen ist.
search-next = Nächster Fund
search-next-about = Den nächsten gefundenen Bildpunkt aufzeichnen und das Ereignis auswählen, dessentwegen er gefunden wurde.
search-previous = Voriger Fund
search-previous-about = Den vorigen gefundenen Bildpunkt aufzeichnen und das Ereignis auswählen, dessentwegen er gefunden wurde.
search-clear = Suche vergessen
search-clear-about = Das Feld, die Liste und die Zeichen auf dem Bild löschen.
search-presets = Beispiele
search-results = Funde
search-words = Wörter
search-maps = Karten
search-count = { $count } von { $all } Bildpunkten
search-at = { $at } von { $count }
search-running = sucht: { $percent }
search-invitation = Eingeben, was gefunden werden soll: ein Wort wie tir, shadowed oder csg.early_out, oder ein Vergleich wie kind=refracted. & heißt und, | heißt oder, ! heißt nicht. Jeder Bildpunkt, in dessen Geschichte ein solches Ereignis vorkommt, wird im Bild schraffiert und hier aufgezählt.
search-language = Eine Frage fragt nach einem Ereignis; ein Bildpunkt wird gefunden, wenn eines seiner Ereignisse so ist. & heißt und, | heißt oder, ! heißt nicht, has(…) sieht alles an, was unter einem Ereignis liegt. In Namen steht * für Beliebiges. Was auf einen Treffer folgt, hat das Objekt dieses Treffers, und jedes Ereignis hat Art und Tiefe seines Strahls.
search-words-plain = Wörter
search-words-names = Felder mit Namen: = oder !=
search-words-numbers = Felder mit Zahlen: = != < <= > >=
search-words-group = Mit einer Frage in Klammern

map-none = Keine Karte
map-none-about = Das Bild ohne Karte zeigen.
map-rays = Strahlen
map-rays-about = Eine Karte davon, wie viele Strahlen jeder Bildpunkt aussendet.
map-tests = Tests
map-tests-about = Eine Karte davon, wie viele Tests gegen Grundkörper und Hüllen jeder Bildpunkt kostet.
map-depth = Tiefe
map-depth-about = Eine Karte davon, wie weit der tiefste Strahl jedes Bildpunkts vom Auge entfernt ist.
map-time = Zeit
map-time-about = Eine Karte davon, wie lange jeder Bildpunkt auf einem Thread braucht, mehrmals gemessen.
map-error = Fehler von t
map-error-about = Eine Karte der Schranke für den Fehler der ersten Trefferzeit.
map-object = Objekte
map-object-about = Eine Karte der Objekte, die zu sehen sind, mit Namen und Nummern.
map-normal = Normalen
map-normal-about = Eine Karte der Normalen der Flächen, die zu sehen sind.
map-digits = Verlorene Stellen
map-digits-about = Eine Karte davon, was die Arithmetik von der ersten Trefferzeit verliert.
map-invitation = Auswählen, was auf die Karte soll. Die Karte liegt über dem Bild, und ihre Legende steht hier.
map-opacity = Über dem Bild
map-running = kartiert: { $percent }
map-name = Karte: { $map }

# Fragen mit Namen
asked-tir = Eine Totalreflexion
asked-deep = Ein Strahl ab Tiefe 3
asked-early-out = Ein früher Abbruch im booleschen Baum
asked-rejected = Ein verworfener Treffer
asked-undecidable = Eine Entscheidung, die die eigenen Zahlen des Strahls nicht erlauben
asked-fallback = Eine Entscheidung, die feinere Arithmetik brauchte
asked-shadowed = Ein verdecktes Licht
asked-limit = Ein Strahl, den eine Grenze aufhält
asked-extent = Eine Hülle, die die Arbeit dahinter spart
asked-spawned = Ein gespiegelter oder gebrochener Strahl
asked-background = Ein Strahl, der nichts trifft
asked-grazing = Licht, das eine Fläche streift
