# Editing: the text of the scene, properties, moving, saving, recovery.

menu-edit = Edit
edit-undo = Undo
edit-undo-about = Take the last change of the scene back.
edit-redo = Redo
edit-redo-about = Make the change again that was taken back. Ctrl+Y does so too.
edit-undo-named = Undo: { $change }
edit-redo-named = Redo: { $change }
edit-save = Save
edit-save-about = Write the scene to its file. A scene that comes with rayscope becomes a copy.
edit-save-as = Save as…
edit-save-as-about = Write the scene to another file, together with the pictures that it needs.
edit-new-ball = New scene: a ball
edit-new-ball-about = Begin a scene with a ball on a floor under a lamp.
edit-new-carved = New scene: a carved solid
edit-new-carved-about = Begin a scene with a cube that a sphere is cut out of.
edit-new-glass = New scene: glass
edit-new-glass-about = Begin a scene with a glass ball before a chequered wall.
edit-revert = Revert to saved
edit-revert-about = Go back to the text as it was saved. That can be undone, too.
edit-find-words = Find…
edit-find-words-about = Find words in the text of the scene.
edit-complete = Complete
edit-complete-about = Show what can be written at the cursor.
edit-next-error = Next error
edit-next-error-about = Go to the next thing that is wrong with the text.
edit-move = Move
edit-move-about = Drag objects and lights in the picture; with Shift along one axis. With the picture in focus: arrows, Page Up and Page Down.

edit-text = Text of the scene
edit-typing = Typing
edit-completion = What can be written here
edit-required = required
edit-find = Find:
edit-find-next = Next match
edit-find-previous = Previous match
edit-close-find = Close find
edit-found = { $count ->
    [0] not found
    [one] { $count } match
   *[other] { $count } matches
}
edit-errors = { $count ->
    [one] { $count } error
   *[other] { $count } errors
}
edit-error-at = Line { $line }, column { $column }: { $message }
edit-saved = saved
edit-unsaved = • not saved
edit-changed = changed
edit-stale = stale: of an older text
edit-stale-about = Picture and story are of the text before the error.
edit-no-journal = cannot be kept in case of a crash: { $why }
edit-untitled = untitled

edit-thing = Edit:
edit-none = nothing
edit-nothing-chosen = Choose something above, click an object in the picture, or put the cursor into it in the text.
edit-unreadable = The thing that is edited cannot be found in the text, which has errors. Mend the text, or choose something above.
edit-camera = Camera
edit-image = Image size
edit-sampling = Sampling
edit-limits = Limits
edit-light = Light
edit-material = Material
edit-object = Object
edit-part = Part
edit-solid = Solid
edit-add = Add…
edit-remove = Remove
edit-light-point = point light
edit-light-directional = directional light
edit-remove-step = Remove step
edit-add-step = Add a step:
edit-drag-about = Drag to change it, click to type.
edit-picker = colour picker
edit-red = red
edit-green = green
edit-blue = blue
edit-cause-set = Change { $property } of { $thing }
edit-cause-move = Move { $thing }
edit-cause-add = Add { $thing }
edit-cause-remove = Remove { $thing }
edit-cause-recover = Recovered edit

edit-guard = Save the changes to { $name }?
edit-guard-about = They are lost otherwise.
edit-guard-save = Save changes
edit-guard-discard = Don’t save
edit-guard-cancel = Cancel
edit-recover = Recover the edit of { $name } from { $time }?
edit-recover-about = rayscope ended before it was saved. These lines are different:
edit-recover-yes = Recover
edit-recover-no = Discard
edit-recover-later = Later
edit-ago = { $minutes ->
    [0] less than a minute ago
    [one] { $minutes } minute ago
   *[other] { $minutes } minutes ago
}
edit-lines-same = { $count ->
    [one] … { $count } line that is the same
   *[other] … { $count } lines that are the same
}
edit-changed-on-disk = Another program has changed the file since it was opened, so it was not overwritten. Save under another name, or open the file again.
edit-not-saved = The file cannot be written: { $why }.
property-inherited = as of the whole
