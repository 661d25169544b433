// Says what is wrong and what to do about it, and looks whether the browser can run the program at all. Not a module, and
// written so that old browsers understand it.
var rayscopeProblem = (function () {
  "use strict";
  var say = rayscopeWords.say;

  function element(id) {
    return document.getElementById(id);
  }

  function put(id, text) {
    element(id).textContent = text || "";
    element(id).hidden = !text;
  }

  /** Shows a problem instead of the page: its kind (see words.js), and what was said where it happened. */
  function show(kind, detail) {
    // The first problem is the cause; what it leads to would only cover it.
    if (document.documentElement.hasAttribute("data-problem")) {
      return;
    }
    document.documentElement.setAttribute("data-problem", kind);
    put("problem-title", say(kind + "-title"));
    put("problem-what", say(kind + "-what"));
    put("problem-help", say(kind + "-help"));
    put("problem-detail", detail);
    put("problem-kept", kind === "failed" || kind === "context" ? say("kept") : "");
    put("problem-reload", say("reload"));
    put("problem-afresh", kind === "failed" ? say("afresh") : "");
    element("loading").hidden = true;
    element("problem").hidden = false;
    element("problem-title").focus();
  }

  element("problem-reload").onclick = function () {
    location.reload();
  };
  element("problem-afresh").onclick = function () {
    history.replaceState(null, "", location.pathname + location.search);
    location.reload();
  };

  // Elements that cannot be loaded say so only while the event goes down to them.
  addEventListener("error", function (event) {
    var failed = event.target && (event.target.src || event.target.href);
    var isNeeded = failed && (event.target.tagName === "SCRIPT" || event.target.rel === "stylesheet");
    if (isNeeded) {
      show("load", failed);
    }
  }, true);

  function hasWebgl() {
    var canvas = document.createElement("canvas");
    var gl = canvas.getContext("webgl2") || canvas.getContext("webgl");
    // Browsers allow a page only a few of them at once.
    var loser = gl && gl.getExtension("WEBGL_lose_context");
    if (loser) {
      loser.loseContext();
    }
    return !!gl;
  }

  if (location.protocol === "file:") {
    show("file");
  } else if (!("noModule" in document.createElement("script")) || typeof Promise === "undefined") {
    show("old");
  } else if (typeof WebAssembly !== "object" || !WebAssembly) {
    show("wasm");
  } else if (typeof WebAssembly.compileStreaming !== "function" || typeof BigInt === "undefined") {
    show("old");
  } else if (!hasWebgl()) {
    show("webgl");
  }
  return show;
})();
