# Sich durch die Geschichte bewegen.

step-first = Anfang
step-first-about = An den Anfang der Geschichte gehen.
step-back = Zurück
step-back-about = Zum Ereignis davor gehen.
step-next = Weiter
step-next-about = Zum nächsten Ereignis gehen.
step-into = Hinein
step-into-about = In dieses Ereignis hineinsehen: zu seinem ersten Teil gehen.
step-over = Darüber
step-over-about = Über dieses Ereignis hinweggehen: zum nächsten, das kein Teil von ihm ist.
step-out = Hinaus
step-out-about = Hinausgehen: zum Ereignis, dessen Teil dieses ist.
step-last = Ende
step-last-about = Ans Ende der Geschichte gehen.
step-previous-same = Voriges dieser Art
step-previous-same-about = Zum vorigen Ereignis derselben Art zurückgehen.
step-next-same = Nächstes dieser Art
step-next-same-about = Zum nächsten Ereignis derselben Art gehen.
step-previous-stop = Zurück zum vorigen Halt
step-previous-stop-about = Zum vorigen Ereignis zurückgehen, an dem ein Haltepunkt anhält.
step-next-stop = Weiter zum nächsten Halt
step-next-stop-about = Zum nächsten Ereignis gehen, an dem ein Haltepunkt anhält.
step-kind = Zu einer Art
step-kind-about = Zum nächsten Ereignis einer Art gehen.

step-play = Abspielen
step-play-about = Die Geschichte Schritt für Schritt abspielen oder anhalten. An Haltepunkten hält sie an.
step-pause = Anhalten
step-faster = Schneller abspielen
step-faster-about = Mehr Schritte in der Sekunde.
step-slower = Langsamer abspielen
step-slower-about = Weniger Schritte in der Sekunde.
decimal-sign = ,
step-speed = { $speed } je Sekunde
step-speed-about = Wie viele Schritte in einer Sekunde abgespielt werden.

step-jump = Gehe zu Schritt…
step-jump-about = Zu einem Schritt gehen, dessen Nummer man eingibt.
step-jump-label = Gehe zu Schritt
step-jump-go = Los
step-jump-none = Einen Schritt mit dieser Nummer gibt es nicht.
step-place = Schritt { $step } von { $steps }
step-place-between = nach Schritt { $step } von { $steps }
step-event = Ereignis { $event } von { $events }
step-by = nach { $method }
step-recording = Bildpunkt wird aufgezeichnet…

step-level-story = Geschichte
step-level-story-about = Die Strahlen, was sie treffen, die Lichter, die Farben, und was immer etwas abgeschnitten hat.
step-level-working = Rechenweg
step-level-working-about = Auch Objekte, Körper, CSG-Knoten, das Brechungsgesetz und die Anteile der Beleuchtung.
step-level-everything = Alles
step-level-everything-about = Alles, was aufgezeichnet wurde.

step-filter = Filter
step-filter-about = Ereignisse suchen: nach ihrem Strahl, ihrem Objekt, ihrer Art oder ihren Wörtern.
step-filter-clear = Filter aufheben
step-filter-clear-about = Wieder alle Zeilen zeigen.
step-filter-text = Wörter
step-filter-hint = Wörter der Zeile
step-filter-rays = Strahlen
step-filter-objects = Objekte
step-filter-kinds = Arten
step-filter-working = wird gesucht…
step-filter-hidden = { $count ->
    [one] { $count } Zeile vom Filter verborgen
   *[other] { $count } Zeilen vom Filter verborgen
}
step-filter-found = { $count ->
    [0] nichts gefunden
    [one] { $count } gefunden
   *[other] { $count } gefunden
}
step-filter-deeper = { $count ->
    [one] { $count } weiteres auf einer feineren Stufe
   *[other] { $count } weitere auf einer feineren Stufe
}

step-breakpoints = Haltepunkte
step-breakpoints-about = Wo Schritte anhalten: Fragen, die jedem Ereignis gestellt werden.
step-breakpoint-hits = { $count ->
    [0] hier nirgends
    [one] hier { $count }-mal
   *[other] hier { $count }-mal
}
step-breakpoint-new = Neuer Haltepunkt
step-breakpoint-hint = eine Frage, etwa object=lens & csg.early_out
step-breakpoint-add = Hinzufügen
step-breakpoint-remove = { $name } entfernen
step-until = Nächsten Bildpunkt mit einem Halt finden
step-until-about = Die Bildpunkte nach diesem durchgehen bis zum ersten, in dessen Geschichte ein Haltepunkt anhält.
step-until-searching = { $count ->
    [one] { $count } Bildpunkt durchsucht
   *[other] { $count } Bildpunkte durchsucht
}
step-until-cancel = Suche beenden
step-until-none = Kein Bildpunkt des Bildes hält an einem eingeschalteten Haltepunkt.
step-until-nothing-on = Zuerst einen Haltepunkt einschalten.

step-left-out = Ausgelassen
step-left-out-about = Auflisten, was übersprungen, abgeschnitten oder verworfen wurde, jeweils mit dem Grund.
step-left-out-nothing = Nichts wurde ausgelassen.
step-left-out-effects = Für das ganze Bild ausgeschaltet: { $effects }
step-cut-limited = { $count } an einer Grenze gestoppt
step-cut-undecidable = { $count } unentscheidbar
step-cut-early-out = { $count } früh beendet
step-cut-missed = { $count } verfehlt
step-cut-rejected = { $count } verworfen
step-cut-passed = { $count } übergangen

step-open-all = Alle Zeilen aufklappen
step-open-all-about = Alle Zeilen dieser Stufe zeigen.
step-close-all = Alle Zeilen zuklappen
step-close-all-about = Nur die ersten Zeilen zeigen.

step-story-empty = Ein Klick auf einen Bildpunkt im Bild, und hier wird die Geschichte seines Strahls erzählt.
step-tree = Die Geschichte des Strahls
step-row-inside = { $count ->
    [one] { $count } weiteres darin
   *[other] { $count } weitere darin
}
step-row-skips = { $count ->
    [one] { $count } davon ausgelassen
   *[other] { $count } davon ausgelassen
}
step-row-stop = Haltepunkt
step-row-guest = gezeigt, weil es gewählt ist
step-timeline = Zeitleiste
step-timeline-about = Alle Ereignisse in der Reihenfolge, in der sie geschahen. Klicken oder ziehen, um dorthin zu gehen.
step-note-close = Meldung schließen

detail-none = Es ist kein Ereignis gewählt.
detail-source = Berechnet in { $source }
