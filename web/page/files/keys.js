// Keys that would otherwise leave the workbench, or never let one leave it.

/** Keys that mean something in the workbench, and for which browsers would open something of their own. */
const OWN = new Set(["F1", "F3", "F6", "F7", "Control+b", "Control+d", "Control+f", "Control+g", "Control+k"]);

/** The key that goes from the workbench to the story as text and back: within the workbench Tab is the program's. */
const CROSSING = "F9";

export function startKeys(canvas) {
  const story = document.getElementById("story");
  addEventListener("keydown", (event) => {
    const isInStory = story.contains(document.activeElement);
    if (event.key === CROSSING || (event.key === "Escape" && isInStory)) {
      event.preventDefault();
      event.stopPropagation();
      if (isInStory) canvas.focus({ preventScroll: true });
      else (story.querySelector('[aria-selected="true"]') ?? story.querySelector("h1")).focus();
    } else if (!isInStory && OWN.has(named(event))) {
      event.preventDefault();
    }
  }, { capture: true });
}

function named(event) {
  const isCommand = event.ctrlKey || event.metaKey;
  return isCommand && !event.altKey ? `Control+${event.key.toLowerCase()}` : event.key;
}
