# Lessons: the course, steps, questions.

menu-lesson = Lesson
pane-lesson = Lesson
pane-lesson-about = The course, and the lesson that is open, step by step.
preset-lesson = Lesson
preset-lesson-about = A lesson, and beside it what it is about.
palette-lesson = Lesson: { $title }

lesson-open = Open a lesson…
lesson-open-about = Show the course, to choose a lesson from.
lesson-next = Next step
lesson-next-about = Go on to the next step.
lesson-previous = Previous step
lesson-previous-about = Go back to the step before.
lesson-skip = Skip step
lesson-skip-about = Go on without an answer. You can come back at any time.
lesson-finish = Finish lesson
lesson-finish-about = End the lesson and go back to the course.
lesson-restage = Back to this step’s ray
lesson-restage-about = Open the scene of this step again, with its ray and its event.
lesson-retry-about = Look at this step’s ray again, in the scene as you changed it.
lesson-again = Start again
lesson-again-about = Give up your changes, and open the scene as this step found it.
lesson-check = Check
lesson-check-about = Have the answer judged.
lesson-hint = Hint
lesson-hint-about = Show a hint. The first ones say little.
lesson-reveal = Show the answer
lesson-reveal-about = Put the right answer in and explain it.
lesson-export = Export progress…
lesson-export-about = Write what you have done in lessons to a JSON file. It is kept nowhere else but on this machine.
lesson-import = Import progress…
lesson-import-about = Read what was done in lessons from such a file, in place of what is here.
lesson-reset = Reset progress…
lesson-reset-about = Forget everything that was done in lessons.
lesson-reset-sure = Everything that was done in lessons will be forgotten.
lesson-reset-yes = Forget it
lesson-reset-no = Keep it
lesson-exported = Your progress lies in { $path }.
lesson-imported = The progress was read in.

lesson-reading = The course is being read …
lesson-none = There are no lessons.
lesson-done-of = { $done } of { $of } lessons done
lesson-as-list = List
lesson-as-map = Map
lesson-header = § { $section } · { $minutes ->
    [one] { $minutes } minute
   *[other] { $minutes } minutes
}
lesson-needs = needs { $lessons }
lesson-stand-not = not begun
lesson-stand-begun = begun
lesson-stand-done = done
lesson-ended = “{ $lesson }” is done.
lesson-onward = Next:

lesson-list = Course
lesson-list-about = Leave the lesson; it opens again where you left it.
lesson-step = Step { $step } of { $of }
lesson-setting-up = The step is being set up …
lesson-findings = { $count ->
    [one] Something is wrong with this lesson
   *[other] { $count } things are wrong with this lesson
}
lesson-slip = A slip in the chapter
lesson-slip-printed = What is printed:
lesson-slip-right = What is right:
lesson-value = { $value } ({ $from })
lesson-value-about = { $from } · click to select its event
lesson-link-about = Open the lesson { $lesson }
lesson-source-about = A file of the program’s source. Click to copy its name.
lesson-veil = The rest is told with the answers. Show it now
lesson-marked = marked by the lesson
lesson-accuracy = accuracy of the lesson

lesson-question = Question { $number } of { $of }
lesson-of-question = { $what }, question { $number }
lesson-solved = answered
lesson-solved-before = ✓ You have answered this.
lesson-was-revealed = answer shown
lesson-revealed = This is the answer.
lesson-right = Right.
lesson-wrong = Not right.
lesson-hint-title = Hint { $number }
lesson-number = Answer to question { $number }
lesson-no-number = This is no number: { $why }
lesson-up = Move up: { $item }
lesson-down = Move down: { $item }
lesson-drag = Drag to another place
lesson-arm = Answer with a click
lesson-arm-about = The next click there is your answer.
lesson-disarm = Do not click
lesson-disarm-about = Let clicks do again what they always do.
lesson-click-picture = Click in the picture.
lesson-click-side = Click in the side view.
lesson-take-pixel = Take the recorded pixel
lesson-take-pixel-about = Answer with the pixel that the arrow keys have chosen in the picture.
lesson-take-event = Take the selected hit
lesson-take-event-about = Answer with the place of the hit that is selected in the story.
lesson-no-place = The selected event is no hit, so it has no place.
lesson-show-about = Bring this panel to the front.
lesson-show-signs = Show d(t)
lesson-show-signs-about = Bring the sign plot to the front, on which t is dragged.
lesson-show-editor = Scene file
lesson-show-editor-about = Change the text of the scene.
lesson-show-properties = Properties
lesson-show-properties-about = Change the scene with sliders and numbers.
lesson-t = Your answer:
lesson-no-t = Drag t on the sign plot.
lesson-judging = The changed scene is being looked at …
lesson-scene-flawed = The scene file has errors. Mend them first.
lesson-not-judged = The changed scene cannot be judged: { $why }
