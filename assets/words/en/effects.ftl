# What each effect costs.

effects-effect = effect
effects-rays = rays
effects-ns = ns per pixel
effects-share = share
effects-without = without it
effects-difference = difference
effects-measured = Measured at { $size }, { $ns } ns per pixel on one thread; each price is the median of { $pairs } pairs, with and without.
effects-measuring = Measuring what each effect costs: { $percent } %
effects-no-thread = What the effects cost cannot be measured: no thread could be started.
effects-rays-about = { $rays } rays that there would not be without it; its code was entered { $calls } times.
effects-picture-without = The picture without it
effects-difference-about = How far each pixel differs; the brightest differs by { $largest } of 255
effects-unclear = Within its own spread: it cannot be told from nothing.
effects-idle = Not called for: none of their code runs, and they cost nothing.
