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
