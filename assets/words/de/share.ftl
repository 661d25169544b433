# Teilen: Links, Kopien, Dateien.

menu-share = Teilen

share-copy-link = Link kopieren
share-copy-link-about = Ein Link, der diese Szene, diesen Bildpunkt, dieses Ereignis und diese Anordnung wieder öffnet, hier oder bei anderen.
share-open-link = Link öffnen…
share-open-link-about = Einen Link einfügen und sehen, was jemand anders sah.
share-copy-text = Als Text kopieren
share-copy-text-about = Die ganze Geschichte dieses Strahls mit allen Zahlen als Text.
share-copy-markdown = Als durchgerechnetes Beispiel kopieren
share-copy-markdown-about = Die Geschichte auf dieser Stufe als Markdown, mit Formeln und Tabellen.
share-copy-image = Zeichnung als Bild kopieren
share-copy-image-about = Die Zeichnung der benutzten Ansicht, um sie anderswo einzufügen.
share-save-svg = Zeichnung als SVG sichern…
share-save-svg-about = Die Zeichnung der benutzten Ansicht als Linien und Texte.
share-save-png = Zeichnung als PNG sichern…
share-save-png-about = Die Zeichnung der benutzten Ansicht als Pixel.
share-save-pdf = Zeichnung als PDF sichern…
share-save-pdf-about = Die Zeichnung der benutzten Ansicht als Seite mit durchsuchbarem Text.
share-save-text = Aufzeichnung als Text sichern…
share-save-text-about = Die ganze Geschichte dieses Strahls mit allen Zahlen als Text.
share-save-json = Aufzeichnung als JSON sichern…
share-save-json-about = Alles, was aufgezeichnet wurde, als Daten für andere Programme.
share-save-markdown = Durchgerechnetes Beispiel sichern…
share-save-markdown-about = Die Geschichte auf dieser Stufe als Markdown, die Zeichnungen daneben.
share-save-slides = Folien sichern…
share-save-slides-about = Eine Folie je Schritt, als eine Seite für jeden Browser.
share-save-slides-pdf = Folien als PDF sichern…
share-save-slides-pdf-about = Eine Folie je Schritt, eine auf jeder Seite.
share-save-gif = Schritte als GIF sichern…
share-save-gif-about = Die Schritte als bewegtes Bild, das überall läuft, in 256 Farben.
share-save-apng = Schritte als animiertes PNG sichern…
share-save-apng-about = Die Schritte als bewegtes Bild in allen Farben.

share-view = Sichern
share-view-about = Diese Zeichnung sichern oder kopieren.
share-title = Teilen
share-working = In Arbeit…
share-cancel = Abbrechen
share-close = Schließen
share-saved = Gesichert als { $path }
share-text-copied = { $lines ->
    [one] Eine Zeile ist in der Zwischenablage.
   *[other] { $lines } Zeilen sind in der Zwischenablage.
}
share-image-copied = Die Zeichnung ist in der Zwischenablage.
share-link-copied = Der Link ist in der Zwischenablage: { $link }
share-link-help = Füge ein, was „Link kopieren“ gemacht hat: Es beginnt mit rayscope: oder ist eine Webadresse mit der Szene hinter dem #.
share-link-field = Link
share-link-follow = Öffnen
share-link-unknown = Der Link verlangt „{ $name }“, was dieses rayscope nicht hat; alles Übrige wird gezeigt.
share-link-outside = Der Bildpunkt ({ $x }, { $y }) des Links liegt außerhalb des Bildes, das sich seither geändert hat.
share-link-flawed = Der Text der Szene hat Fehler, so dass niemand den Link öffnen könnte; behebe sie zuerst.
