# Finding pixels by what happened to their rays, and maps.

menu-search = Search

search-field = Find pixels
search-hint = Find pixels, such as tir, or hit & depth>=2
search-find = Find pixels…
search-find-about = Find pixels by what happened to their rays.
search-next = Next result
search-next-about = Record the next pixel that was found, and select the event for which it was.
search-previous = Previous result
search-previous-about = Record the pixel that was found before, and select the event for which it was.
search-clear = Forget the search
search-clear-about = Clear the field, the list and the marks on the picture.
search-presets = Examples
search-results = Results
search-words = Words
search-maps = Maps
search-count = { $count } of { $all } pixels
search-at = { $at } of { $count }
search-running = searching: { $percent }
search-invitation = Type what is to be found: a word such as tir, shadowed or csg.early_out, or a comparison such as kind=refracted. & is and, | is or, ! is not. Every pixel in whose story such an event happened is hatched in the picture and listed here.
search-language = A question asks for an event; a pixel is found if one of its events is such. & is and, | is or, ! is not, has(…) looks at everything below an event. In names * stands for anything. What follows a hit has the object of that hit, and every event has the kind and depth of its ray.
search-words-plain = Words
search-words-names = Fields with names: = or !=
search-words-numbers = Fields with numbers: = != < <= > >=
search-words-group = With a question in parentheses

map-none = No map
map-none-about = Show the picture without a map.
map-rays = Rays
map-rays-about = A map of how many rays each pixel sends.
map-tests = Tests
map-tests-about = A map of how many tests against primitives and extents each pixel takes.
map-depth = Depth
map-depth-about = A map of how far the deepest ray of each pixel is from the eye.
map-time = Time
map-time-about = A map of how long each pixel takes on one thread, measured repeatedly.
map-error = Error of t
map-error-about = A map of the bound on the error of the first hit’s time.
map-object = Objects
map-object-about = A map of the objects that are seen, with names and numbers.
map-normal = Normals
map-normal-about = A map of the normals of the surfaces that are seen.
map-digits = Digits lost
map-digits-about = A map of what the arithmetic loses of the first hit’s time.
map-invitation = Choose what is to be mapped. The map lies over the picture, and its legend is shown here.
map-opacity = Over the picture
map-running = mapping: { $percent }
map-name = Map: { $map }

# Questions with names
asked-tir = A total internal reflection
asked-deep = A ray at depth 3 or more
asked-early-out = An early out in a Boolean tree
asked-rejected = A hit that is rejected
asked-undecidable = A decision that the ray's own numbers do not allow
asked-fallback = A decision that needed finer arithmetic
asked-shadowed = A light that is hidden
asked-limit = A ray that a limit stops
asked-extent = An extent that spares the work behind it
asked-spawned = A reflected or refracted ray
asked-background = A ray that hits nothing
asked-grazing = Light that grazes a surface
