# Help for everyone: the palette of commands, the keys, the tour.

menu-help = Help
close = Close
help-palette = Find a command…
help-palette-about = Find any command or scene by a few letters.
help-keys = Keys
help-keys-about = Show every key.
help-tour = Take the tour
help-tour-about = Six stops through the workbench.

palette-title = Type a few letters of a command or a scene
palette-nothing = Nothing goes with that. Fewer letters may help.
palette-scene = Open scene: { $name }

keys-within = Within panels
keys-arrows = Arrow keys
keys-picture-arrows = In the picture: record the pixel beside this one.
keys-shift-arrows = Shift + arrow keys
keys-picture-shift-arrows = In the picture: go ten pixels at once.
keys-up-down = Up, Down
keys-story-up-down = In the story: go to the row above or below.
keys-left-right = Left, Right
keys-story-left-right = In the story: fold and open, or go out and into.
keys-tab = Tab
keys-everywhere-tab = Go on to the next control; with Shift, back to the one before.
keys-escape = Esc
keys-everywhere-escape = Close what lies over the panels.

tour-place = Stop { $at } of { $count }
tour-next = Next
tour-back = Back
tour-skip = Skip the tour
tour-end = Begin
tour-picture = The picture
tour-picture-about = Click any pixel. Its ray is traced once more, by the same code, and everything that it does is recorded. Arrow keys go to the pixels beside it.
tour-story = The ray’s story
tour-story-about = What happened, in order. Step through it with N and B, look into an event with I, out again with O. Rows that are folded hold the working.
tour-detail = One event in full
tour-detail-about = Each number with its formula, the ray’s own numbers put in, and the line of source code that computed it.
tour-side = The scene cut open
tour-side-about = The scene along the ray, drawn up to the event at which you stand. Click a mark to go to its event; drag and zoom freely.
tour-along = What can be drawn of it
tour-along-about = Interval lists of CSG nodes, the sign of d(t), Snell’s angles, texels and more, whatever belongs to the selected event.
tour-more = There is more
tour-more-about = The buttons at the top right change the layout, the View menu has more panels, Ctrl+K finds every command and scene, and F1 shows the keys.

# Keys as they stand on keyboards
key-control = Ctrl
key-shift = Shift
key-space = Space
key-enter = Enter
key-escape = Esc
key-tab = Tab
key-backspace = Backspace
key-delete = Delete
key-home = Home
key-end = End
key-page-up = Page up
key-page-down = Page down
key-up = ↑
key-down = ↓
key-left = ←
key-right = →
key-period = .
key-comma = ,
key-slash = /
key-plus = Plus
key-minus = Minus
key-equals = Equals
