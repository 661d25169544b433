# Comparing stories, pictures, and another ray tracer's story.

menu-compare = Compare
compare-pin = Pin this story
compare-pin-about = Keep the story that is shown as it is now, to compare others with it: another pixel, another scene, other settings, before and after an edit.
compare-unpin = Take the pin away
compare-unpin-about = Forget the pinned story that is compared with.
compare-next = Next difference
compare-next-about = Go on to the next event that differs from the pinned story.
compare-previous = Previous difference
compare-previous-about = Go back to the event before that differs from the pinned story.
compare-open = Compare with my ray tracer…
compare-open-about = Open the lines that a ray tracer of your own has printed (JSON lines), and see where it departs from this one, and why.
compare-files = Lines of a ray tracer

compare-with = compared with
compare-name = Name of the pin
compare-page-stories = Stories
compare-page-pictures = Pictures
compare-page-foreign = Another ray tracer
compare-nothing = Pin a story, then record another pixel, open another scene or change a setting: this panel shows what differs.
compare-working = Comparing…
compare-no-difference = No difference in { $events } events.
compare-counts = { $same } the same (=), { $changed } changed (~), { $left } only here (−), { $right } only in the pin (+)
compare-first = First difference: { $event }
compare-parting = First that goes another way: { $event }
compare-go-here = Go there
compare-go-there = Go there in the pin
compare-all-rows = Show all rows, not only those that differ

compare-same = same
compare-changed = changed
compare-only-here = only here
compare-only-there = only in the pin

compare-rendering = Rendering both pictures…
compare-two-sizes = The pictures are of two sizes, and cannot be laid over each other.
compare-figures = Largest difference of a channel { $largest }, root mean square { $rmse }, { $pixels } pixels differ
compare-amplified = Show the difference, amplified so that the largest is white
compare-slider = Between the two pictures
compare-picture = The two pictures
compare-left-side = this scene
compare-right-side = the pin

compare-foreign-about = Open what a ray tracer of your own has printed.
compare-foreign-same = { $name }: no difference in { $stories } stories, { $checks } things compared.
compare-foreign-departs = { $name }: { $departing } of { $stories } stories depart, { $checks } things compared.
compare-unreadable = { $name } cannot be read
compare-line = line { $line }
compare-go-ours = Show our story there
compare-ours = ours: { $value }
compare-theirs = theirs: { $value }
compare-no-cause = No known mistake explains it.
compare-cause = Likely cause: { $cause }
compare-other-cause = Or: { $cause }
