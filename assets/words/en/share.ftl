# Sharing: links, copies, files.

menu-share = Share

share-copy-link = Copy link
share-copy-link-about = A link that opens this scene, pixel, event and layout again, here or for somebody else.
share-open-link = Open a link…
share-open-link-about = Paste a link to see what somebody else saw.
share-copy-text = Copy as text
share-copy-text-about = The whole story of this ray, with all numbers, as text.
share-copy-markdown = Copy as worked example
share-copy-markdown-about = The story at this level as Markdown, with its formulas and tables.
share-copy-image = Copy drawing as image
share-copy-image-about = The drawing of the panel that you use, to be pasted elsewhere.
share-save-svg = Save drawing as SVG…
share-save-svg-about = The drawing of the panel that you use as lines and texts.
share-save-png = Save drawing as PNG…
share-save-png-about = The drawing of the panel that you use as pixels.
share-save-pdf = Save drawing as PDF…
share-save-pdf-about = The drawing of the panel that you use as a page with text that can be searched.
share-save-text = Save trace as text…
share-save-text-about = The whole story of this ray, with all numbers, as text.
share-save-json = Save trace as JSON…
share-save-json-about = Everything that was recorded, as data for other programs.
share-save-markdown = Save worked example…
share-save-markdown-about = The story at this level as Markdown, with its drawings beside it.
share-save-slides = Save slides…
share-save-slides-about = A slide for each step, as one page for any browser.
share-save-slides-pdf = Save slides as PDF…
share-save-slides-pdf-about = A slide for each step, one to a page.
share-save-gif = Save steps as GIF…
share-save-gif-about = The steps as a moving picture that is shown everywhere, in 256 colours.
share-save-apng = Save steps as animated PNG…
share-save-apng-about = The steps as a moving picture in all colours.

share-view = Save
share-view-about = Save or copy this drawing.
share-title = Share
share-working = Making it…
share-cancel = Cancel
share-close = Close
share-saved = Saved as { $path }
share-text-copied = { $lines ->
    [one] One line is on the clipboard.
   *[other] { $lines } lines are on the clipboard.
}
share-image-copied = The drawing is on the clipboard.
share-link-copied = The link is on the clipboard: { $link }
share-link-help = Paste what “Copy link” made: it begins with rayscope: or is a web address with the scene behind its #.
share-link-field = Link
share-link-follow = Open
share-link-unknown = The link asks for “{ $name }”, which this rayscope does not have; the rest is shown.
share-link-outside = The link’s pixel ({ $x }, { $y }) lies outside the picture, which has changed since.
share-link-flawed = The text of the scene has errors, so that nobody could open the link; correct them first.
