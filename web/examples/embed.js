// Talks with the frames: the buttons step, and the frames say where they are. Without this script the frames work as well.
"use strict";

for (const figure of document.querySelectorAll(".step")) {
  const frame = figure.querySelector("iframe");
  const caption = figure.querySelector("figcaption");
  const button = (text, command) => {
    const made = document.createElement("button");
    made.type = "button";
    made.textContent = text;
    made.addEventListener("click", () => frame.contentWindow.postMessage(command, new URL(frame.src).origin));
    return made;
  };

  addEventListener("message", (event) => {
    if (event.source !== frame.contentWindow || event.data?.source !== "rayscope") return;
    if (event.data.type === "ready" && !caption.querySelector("button")) {
      caption.append(button("Back", { do: "back" }), button("Next", { do: "next" }));
    }
    if (event.data.type === "step") figure.dataset.event = event.data.event;
  });
}
