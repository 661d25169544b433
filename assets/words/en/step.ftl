# Moving through the story.

step-first = First
step-first-about = Go to the beginning of the story.
step-back = Back
step-back-about = Go back to the event before this one.
step-next = Next
step-next-about = Go on to the next event.
step-into = Into
step-into-about = Look inside this event: go to its first part.
step-over = Over
step-over-about = Step over this event: go on to the next one that is not a part of it.
step-out = Out
step-out-about = Step out: go to the event that this one is a part of.
step-last = Last
step-last-about = Go to the end of the story.
step-previous-same = Previous of this kind
step-previous-same-about = Go back to the event before of the same kind as this one.
step-next-same = Next of this kind
step-next-same-about = Go on to the next event of the same kind as this one.
step-previous-stop = Back to the previous stop
step-previous-stop-about = Go back to the event before at which a breakpoint stops.
step-next-stop = On to the next stop
step-next-stop-about = Go on to the next event at which a breakpoint stops.
step-kind = To a kind
step-kind-about = Go on to the next event of a kind.

step-play = Play
step-play-about = Play the story step by step, or pause it. It stops at breakpoints.
step-pause = Pause
step-faster = Play faster
step-faster-about = More steps a second.
step-slower = Play slower
step-slower-about = Fewer steps a second.
decimal-sign = .
step-speed = { $speed } a second
step-speed-about = How many steps are played in a second.

step-jump = Go to step…
step-jump-about = Go to a step by its number.
step-jump-label = Go to step
step-jump-go = Go
step-jump-none = There is no step of that number.
step-place = step { $step } of { $steps }
step-place-between = after step { $step } of { $steps }
step-event = event { $event } of { $events }
step-by = by { $method }
step-recording = recording pixel…

step-level-story = Story
step-level-story-about = Tell the rays, what they hit, the lights, the colours, and whatever cut something off.
step-level-working = Working
step-level-working-about = Tell objects, primitives, CSG nodes, Snell’s law and the terms of the shading too.
step-level-everything = Everything
step-level-everything-about = Tell all that was recorded.

step-filter = Filter
step-filter-about = Look for events by their ray, their object, their kind, or their words.
step-filter-clear = Clear the filter
step-filter-clear-about = Show all rows again.
step-filter-text = Words
step-filter-hint = words of the row
step-filter-rays = Rays
step-filter-objects = Objects
step-filter-kinds = Kinds
step-filter-working = looking…
step-filter-hidden = { $count ->
    [one] { $count } row hidden by the filter
   *[other] { $count } rows hidden by the filter
}
step-filter-found = { $count ->
    [0] nothing found
    [one] { $count } found
   *[other] { $count } found
}
step-filter-deeper = { $count ->
    [one] { $count } more at a finer level
   *[other] { $count } more at a finer level
}

step-breakpoints = Breakpoints
step-breakpoints-about = Where stepping stops: questions that are asked of every event.
step-breakpoint-hits = { $count ->
    [0] nowhere here
    [one] { $count } time here
   *[other] { $count } times here
}
step-breakpoint-new = New breakpoint
step-breakpoint-hint = a question, such as object=lens & csg.early_out
step-breakpoint-add = Add
step-breakpoint-remove = Remove { $name }
step-until = Find the next pixel that stops
step-until-about = Go through the pixels after this one to the first in whose story a breakpoint stops.
step-until-searching = { $count ->
    [one] { $count } pixel searched
   *[other] { $count } pixels searched
}
step-until-cancel = Stop searching
step-until-none = No pixel of the picture stops at a breakpoint that is on.
step-until-nothing-on = Switch on a breakpoint first.

step-left-out = Left out
step-left-out-about = List what was skipped, cut off or rejected, each with its reason.
step-left-out-nothing = Nothing was left out.
step-left-out-effects = Switched off for the whole picture: { $effects }
step-cut-limited = { $count } stopped by a limit
step-cut-undecidable = { $count } undecidable
step-cut-early-out = { $count } ended early
step-cut-missed = { $count } missed
step-cut-rejected = { $count } rejected
step-cut-passed = { $count } passed

step-open-all = Unfold all rows
step-open-all-about = Show all rows of this level.
step-close-all = Fold all rows
step-close-all-about = Show the first rows alone.

step-story-empty = Click a pixel in the picture, and the story of its ray is told here.
step-tree = The ray's story
step-row-inside = { $count ->
    [one] { $count } more inside
   *[other] { $count } more inside
}
step-row-skips = { $count ->
    [one] { $count } of them left out
   *[other] { $count } of them left out
}
step-row-stop = breakpoint
step-row-guest = shown because it is selected
step-timeline = Timeline
step-timeline-about = All events in the order in which they happened. Click or drag to go there.
step-note-close = Close the message

detail-none = No event is selected.
detail-source = Computed in { $source }
