# Bearbeiten: der Text der Szene, Eigenschaften, Bewegen, Sichern, Wiederherstellen.

menu-edit = Bearbeiten
edit-undo = Rückgängig
edit-undo-about = Die letzte Änderung der Szene zurücknehmen.
edit-redo = Wiederholen
edit-redo-about = Die zurückgenommene Änderung wieder vornehmen. Strg+Y tut das auch.
edit-undo-named = Rückgängig: { $change }
edit-redo-named = Wiederholen: { $change }
edit-save = Sichern
edit-save-about = Die Szene in ihre Datei schreiben. Von einer Szene, die mit rayscope kommt, entsteht eine Kopie.
edit-save-as = Sichern unter…
edit-save-as-about = Die Szene in eine andere Datei schreiben, mit den Bildern, die sie braucht.
edit-new-ball = Neue Szene: eine Kugel
edit-new-ball-about = Eine Szene mit einer Kugel auf einem Boden unter einer Lampe beginnen.
edit-new-carved = Neue Szene: ein ausgehöhlter Körper
edit-new-carved-about = Eine Szene mit einem Würfel beginnen, aus dem eine Kugel geschnitten ist.
edit-new-glass = Neue Szene: Glas
edit-new-glass-about = Eine Szene mit einer Glaskugel vor einer karierten Wand beginnen.
edit-revert = Zurück zum Gesicherten
edit-revert-about = Zum Text zurückkehren, wie er gesichert wurde. Auch das lässt sich rückgängig machen.
edit-find-words = Suchen…
edit-find-words-about = Wörter im Text der Szene suchen.
edit-complete = Vervollständigen
edit-complete-about = Zeigen, was sich an der Schreibmarke schreiben lässt.
edit-next-error = Nächster Fehler
edit-next-error-about = Zur nächsten Stelle gehen, an der am Text etwas falsch ist.
edit-move = Bewegen
edit-move-about = Objekte und Lichter im Bild ziehen; mit Umschalt entlang einer Achse. Ist das Bild im Fokus: Pfeile, Bild auf und Bild ab.

edit-text = Text der Szene
edit-typing = Tippen
edit-completion = Was sich hier schreiben lässt
edit-required = nötig
edit-find = Suchen:
edit-find-next = Nächster Treffer
edit-find-previous = Voriger Treffer
edit-close-find = Suche schließen
edit-found = { $count ->
    [0] nicht gefunden
    [one] { $count } Treffer
   *[other] { $count } Treffer
}
edit-errors = { $count ->
    [one] { $count } Fehler
   *[other] { $count } Fehler
}
edit-error-at = Zeile { $line }, Spalte { $column }: { $message }
edit-saved = gesichert
edit-unsaved = • nicht gesichert
edit-changed = geändert
edit-stale = veraltet: von einem älteren Text
edit-stale-about = Bild und Geschichte sind vom Text vor dem Fehler.
edit-no-journal = wird für einen Absturz nicht aufbewahrt: { $why }
edit-untitled = ohne Namen

edit-thing = Bearbeiten:
edit-none = nichts
edit-nothing-chosen = Oben etwas wählen, im Bild auf ein Objekt klicken oder im Text die Schreibmarke hineinsetzen.
edit-unreadable = Was bearbeitet wird, ist im Text nicht zu finden, der Fehler hat. Den Text verbessern oder oben etwas wählen.
edit-camera = Kamera
edit-image = Bildgröße
edit-sampling = Abtastung
edit-limits = Grenzen
edit-light = Licht
edit-material = Material
edit-object = Objekt
edit-part = Teil
edit-solid = Körper
edit-add = Hinzufügen…
edit-remove = Entfernen
edit-light-point = Punktlicht
edit-light-directional = gerichtetes Licht
edit-remove-step = Schritt entfernen
edit-add-step = Schritt hinzufügen:
edit-drag-about = Ziehen ändert den Wert, ein Klick lässt ihn tippen.
edit-picker = Farbwähler
edit-red = Rot
edit-green = Grün
edit-blue = Blau
edit-cause-set = { $property } von { $thing } ändern
edit-cause-move = { $thing } bewegen
edit-cause-add = { $thing } hinzufügen
edit-cause-remove = { $thing } entfernen
edit-cause-recover = Wiederhergestellte Bearbeitung

edit-guard = Die Änderungen an { $name } sichern?
edit-guard-about = Sonst gehen sie verloren.
edit-guard-save = Änderungen sichern
edit-guard-discard = Nicht sichern
edit-guard-cancel = Abbrechen
edit-recover = Die Bearbeitung von { $name } ({ $time }) wiederherstellen?
edit-recover-about = rayscope endete, bevor sie gesichert war. Diese Zeilen sind verschieden:
edit-recover-yes = Wiederherstellen
edit-recover-no = Verwerfen
edit-recover-later = Später
edit-ago = { $minutes ->
    [0] vor weniger als einer Minute
    [one] vor { $minutes } Minute
   *[other] vor { $minutes } Minuten
}
edit-lines-same = { $count ->
    [one] … { $count } Zeile, die gleich ist
   *[other] … { $count } Zeilen, die gleich sind
}
edit-changed-on-disk = Ein anderes Programm hat die Datei geändert, seit sie geöffnet wurde; sie wurde nicht überschrieben. Unter anderem Namen sichern oder die Datei neu öffnen.
edit-not-saved = Die Datei lässt sich nicht schreiben: { $why }.
property-inherited = wie das Ganze
