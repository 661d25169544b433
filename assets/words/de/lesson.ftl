# Lektionen: der Kurs, Schritte, Fragen.

menu-lesson = Lektion
pane-lesson = Lektion
pane-lesson-about = Der Kurs und die offene Lektion, Schritt für Schritt.
preset-lesson = Lektion
preset-lesson-about = Eine Lektion, und daneben, wovon sie handelt.
palette-lesson = Lektion: { $title }

lesson-open = Lektion öffnen…
lesson-open-about = Den Kurs zeigen, um eine Lektion zu wählen.
lesson-next = Nächster Schritt
lesson-next-about = Zum nächsten Schritt gehen.
lesson-previous = Schritt zurück
lesson-previous-about = Zum Schritt davor gehen.
lesson-skip = Schritt auslassen
lesson-skip-about = Ohne Antwort weitergehen. Du kannst jederzeit zurückkommen.
lesson-finish = Lektion beenden
lesson-finish-about = Die Lektion beenden und zum Kurs zurückkehren.
lesson-restage = Zurück zum Strahl des Schritts
lesson-restage-about = Die Szene dieses Schritts mit ihrem Strahl und ihrem Ereignis wieder öffnen.
lesson-retry-about = Den Strahl dieses Schritts wieder ansehen, in der Szene, wie du sie geändert hast.
lesson-again = Von vorn
lesson-again-about = Deine Änderungen aufgeben und die Szene öffnen, wie dieser Schritt sie vorfand.
lesson-check = Prüfen
lesson-check-about = Die Antwort beurteilen lassen.
lesson-hint = Hinweis
lesson-hint-about = Einen Hinweis zeigen. Die ersten sagen wenig.
lesson-reveal = Antwort zeigen
lesson-reveal-about = Die richtige Antwort einsetzen und erklären.
lesson-export = Fortschritt ausgeben…
lesson-export-about = In eine JSON-Datei schreiben, was du in Lektionen getan hast. Es liegt sonst nur auf diesem Rechner.
lesson-import = Fortschritt einlesen…
lesson-import-about = Aus einer solchen Datei lesen, was in Lektionen getan wurde, an Stelle dessen, was hier ist.
lesson-reset = Fortschritt vergessen…
lesson-reset-about = Alles vergessen, was in Lektionen getan wurde.
lesson-reset-sure = Alles, was in Lektionen getan wurde, wird vergessen.
lesson-reset-yes = Vergessen
lesson-reset-no = Behalten
lesson-exported = Dein Fortschritt liegt in { $path }.
lesson-imported = Der Fortschritt wurde eingelesen.

lesson-reading = Der Kurs wird gelesen…
lesson-none = Es gibt keine Lektionen.
lesson-done-of = { $done } von { $of } Lektionen fertig
lesson-as-list = Liste
lesson-as-map = Karte
lesson-header = § { $section } · { $minutes ->
    [one] { $minutes } Minute
   *[other] { $minutes } Minuten
}
lesson-needs = braucht { $lessons }
lesson-stand-not = nicht begonnen
lesson-stand-begun = begonnen
lesson-stand-done = fertig
lesson-ended = „{ $lesson }“ ist fertig.
lesson-onward = Weiter mit:

lesson-list = Kurs
lesson-list-about = Die Lektion verlassen; sie öffnet sich wieder, wo du aufgehört hast.
lesson-step = Schritt { $step } von { $of }
lesson-setting-up = Der Schritt wird vorbereitet…
lesson-findings = { $count ->
    [one] Etwas stimmt mit dieser Lektion nicht
   *[other] { $count } Dinge stimmen mit dieser Lektion nicht
}
lesson-slip = Ein Versehen im Kapitel
lesson-slip-printed = Gedruckt steht:
lesson-slip-right = Richtig ist:
lesson-value = { $value } ({ $from })
lesson-value-about = { $from } · ein Klick wählt das Ereignis
lesson-link-about = Die Lektion { $lesson } öffnen
lesson-source-about = Eine Datei aus dem Quelltext des Programms. Ein Klick kopiert ihren Namen.
lesson-veil = Der Rest wird mit den Antworten erzählt. Jetzt zeigen
lesson-marked = von der Lektion hervorgehoben
lesson-accuracy = Genauigkeit der Lektion

lesson-question = Frage { $number } von { $of }
lesson-of-question = { $what }, Frage { $number }
lesson-solved = beantwortet
lesson-solved-before = ✓ Das hast du beantwortet.
lesson-was-revealed = Antwort gezeigt
lesson-revealed = Das ist die Antwort.
lesson-right = Richtig.
lesson-wrong = Nicht richtig.
lesson-hint-title = Hinweis { $number }
lesson-number = Antwort auf Frage { $number }
lesson-no-number = Das ist keine Zahl: { $why }
lesson-up = Nach oben: { $item }
lesson-down = Nach unten: { $item }
lesson-drag = An eine andere Stelle ziehen
lesson-arm = Mit einem Klick antworten
lesson-arm-about = Der nächste Klick dort ist deine Antwort.
lesson-disarm = Nicht klicken
lesson-disarm-about = Klicks tun wieder, was sie immer tun.
lesson-click-picture = Klicke ins Bild.
lesson-click-side = Klicke in die Seitenansicht.
lesson-take-pixel = Aufgezeichneten Bildpunkt nehmen
lesson-take-pixel-about = Mit dem Bildpunkt antworten, den die Pfeiltasten im Bild gewählt haben.
lesson-take-event = Gewählten Treffer nehmen
lesson-take-event-about = Mit dem Ort des Treffers antworten, der in der Geschichte gewählt ist.
lesson-no-place = Das gewählte Ereignis ist kein Treffer und hat keinen Ort.
lesson-show-about = Dieses Feld nach vorn holen.
lesson-show-signs = d(t) zeigen
lesson-show-signs-about = Das Vorzeichenbild nach vorn holen, auf dem t gezogen wird.
lesson-show-editor = Szenendatei
lesson-show-editor-about = Den Text der Szene ändern.
lesson-show-properties = Eigenschaften
lesson-show-properties-about = Die Szene mit Reglern und Zahlen ändern.
lesson-t = Deine Antwort:
lesson-no-t = Ziehe t auf dem Vorzeichenbild.
lesson-judging = Die geänderte Szene wird angesehen…
lesson-scene-flawed = Die Szenendatei hat Fehler. Behebe sie zuerst.
lesson-not-judged = Die geänderte Szene lässt sich nicht beurteilen: { $why }
