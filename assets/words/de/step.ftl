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
