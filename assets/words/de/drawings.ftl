# Die Zeichnungen zum gewählten Ereignis.

drawings-fit = Einpassen
drawings-overview-fit-about = Wieder die ganze Szene zeigen. Ziehen dreht, mit Umschalt verschiebt es; das Mausrad vergrößert.
drawings-camera = Kamera
drawings-camera-about = Durch die Kamera der Szene blicken.
drawings-parallel = Parallel
drawings-parallel-about = Entlang paralleler Linien blicken: Gleiche Längen bleiben gleich.
drawings-section = Schnitt
drawings-section-about = Die Form entlang des Strahls aufschneiden.
drawings-space = Raum
drawings-space-about = Die ganze Form im Raum.
drawings-all-rows = Alle Zeilen
drawings-all-rows-about = Die ganze Tabelle ausfüllen. Ein Klick auf eine Zeile oder die Pfeiltasten füllen sie bis dorthin aus.
drawings-t = t auf dem Strahl
drawings-clear-t = t löschen
drawings-clear-t-about = Keine Zeit auf dem Strahl markieren. Ziehen in der Zeichnung oder die Pfeiltasten markieren eine.
drawings-no-generic = Hier wurde kein Grundkörper gefragt. Wähle einen Grundkörper oder einen Treffer, um den Strahl in dessen Raum zu sehen.
drawings-no-intervals = Hier wurde kein Objekt gefragt. Wähle ein Objekt oder einen Treffer, um seine Intervalle zu sehen.
drawings-no-signs = Wähle einen Grundkörper oder einen Treffer, um d(t) entlang des Strahls zu sehen.
drawings-no-snell = Hier wird kein Licht gebrochen. Wähle einen Treffer auf etwas Durchsichtigem.
drawings-no-shading = Hier kommt keine Farbe zurück. Wähle einen Treffer oder die Farbe eines Strahls.
drawings-no-planes = Hier wurde keine Ebenentabelle ausgefüllt. Wähle einen Würfel, ein Polyeder oder eine andere Form mit ebenen Seiten.
