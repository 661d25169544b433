"use strict";
const slides = [...document.querySelectorAll(".slide")];
if (slides.length > 0) {
  const root = document.documentElement;
  const progress = document.createElement("progress");
  progress.className = "steps";
  progress.max = slides.length;
  progress.setAttribute("aria-label", "Slides so far");
  const bar = document.createElement("nav");
  bar.className = "steps";
  bar.setAttribute("aria-label", "Slides");
  const button = (sign, name, act) => {
    const made = document.createElement("button");
    made.type = "button";
    made.textContent = sign;
    made.title = name;
    made.setAttribute("aria-label", name);
    made.addEventListener("click", act);
    bar.append(made);
  };
  let place = 0;
  const show = (wanted) => {
    place = Math.max(0, Math.min(slides.length - 1, wanted));
    slides.forEach((slide, i) => { slide.hidden = i !== place; });
    progress.value = place + 1;
    progress.textContent = `${place + 1} / ${slides.length}`;
    history.replaceState(null, "", `#${place + 1}`);
    window.scrollTo(0, 0);
  };
  const from = () => (parseInt(location.hash.slice(1), 10) || 1) - 1;
  const turn = () => {
    const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
    root.dataset.theme = dark ? "light" : "dark";
  };
  button("←", "Previous slide (left arrow)", () => show(place - 1));
  button("→", "Next slide (right arrow or space)", () => show(place + 1));
  button("◐", "Light or dark (D)", turn);
  addEventListener("keydown", (event) => {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const onButton = event.target instanceof HTMLButtonElement;
    if (event.key === "ArrowRight" || event.key === "PageDown" || (event.key === " " && !onButton && !event.shiftKey)) show(place + 1);
    else if (event.key === "ArrowLeft" || event.key === "PageUp" || (event.key === " " && !onButton)) show(place - 1);
    else if (event.key === "Home") show(0);
    else if (event.key === "End") show(slides.length - 1);
    else if (event.key === "d" || event.key === "D") turn();
    else return;
    event.preventDefault();
  });
  addEventListener("hashchange", () => show(from()));
  root.classList.add("shown-one");
  document.body.append(bar, progress);
  show(from());
}
