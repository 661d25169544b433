# Hilfe für alle: die Befehlssuche, die Tasten, der Rundgang.

menu-help = Hilfe
close = Schließen
help-palette = Befehl suchen…
help-palette-about = Jeden Befehl und jede Szene mit ein paar Buchstaben finden.
help-keys = Tasten
help-keys-about = Alle Tasten zeigen.
help-tour = Rundgang
help-tour-about = Sechs Stationen durch die Werkbank.

palette-title = Ein paar Buchstaben eines Befehls oder einer Szene
palette-nothing = Dazu passt nichts. Weniger Buchstaben helfen vielleicht.
palette-scene = Szene öffnen: { $name }

keys-within = In den Feldern
keys-arrows = Pfeiltasten
keys-picture-arrows = Im Bild: den Bildpunkt daneben aufzeichnen.
keys-shift-arrows = Umschalt + Pfeiltasten
keys-picture-shift-arrows = Im Bild: zehn Bildpunkte auf einmal gehen.
keys-up-down = Auf, Ab
keys-story-up-down = In der Geschichte: zur Zeile darüber oder darunter.
keys-left-right = Links, Rechts
keys-story-left-right = In der Geschichte: zu- und aufklappen oder hinaus- und hineingehen.
keys-tab = Tab
keys-everywhere-tab = Zum nächsten Bedienelement; mit Umschalt zum vorigen.
keys-escape = Esc
keys-everywhere-escape = Schließen, was über den Feldern liegt.

tour-place = Station { $at } von { $count }
tour-next = Weiter
tour-back = Zurück
tour-skip = Ohne Rundgang
tour-end = Los geht’s
tour-picture = Das Bild
tour-picture-about = Ein Klick auf einen Bildpunkt verfolgt seinen Strahl noch einmal, mit demselben Programm, und zeichnet alles auf. Die Pfeiltasten gehen zu den Nachbarn.
tour-story = Die Geschichte des Strahls
tour-story-about = Was geschah, der Reihe nach. Mit N und B schrittweise, mit I in ein Ereignis hinein, mit O wieder hinaus. Zugeklappte Zeilen enthalten die Rechnung.
tour-detail = Ein Ereignis im Ganzen
tour-detail-about = Jede Zahl mit ihrer Formel, den eingesetzten Zahlen dieses Strahls und der Zeile des Programms, die sie berechnet hat.
tour-side = Die Szene, aufgeschnitten
tour-side-about = Die Szene entlang des Strahls, gezeichnet bis zum gewählten Ereignis. Ein Klick auf ein Zeichen führt zu seinem Ereignis; Ziehen und Rollen verschiebt und vergrößert.
tour-along = Was sich davon zeichnen lässt
tour-along-about = Intervalllisten der CSG-Knoten, das Vorzeichen von d(t), die Winkel von Snellius, Texel und mehr, was eben zum Ereignis gehört.
tour-more = Und noch mehr
tour-more-about = Die Knöpfe oben rechts wechseln die Anordnung, das Menü Ansicht hat weitere Felder, Strg+K findet jeden Befehl und jede Szene, und F1 zeigt die Tasten.

# Tasten, wie sie auf Tastaturen stehen
key-control = Strg
key-shift = Umschalt
key-space = Leertaste
key-enter = Eingabe
key-escape = Esc
key-tab = Tab
key-backspace = Rücktaste
key-delete = Entf
key-home = Pos1
key-end = Ende
key-page-up = Bild ↑
key-page-down = Bild ↓
key-up = ↑
key-down = ↓
key-left = ←
key-right = →
key-period = .
key-comma = ,
key-slash = /
key-plus = Plus
key-minus = Minus
key-equals = Gleich
