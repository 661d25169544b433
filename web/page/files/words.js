// All words of the page around the program, in the languages of the program. Not a module, and written so that old browsers
// understand it: it says among other things that a browser is too old.
var rayscopeWords = (function () {
  "use strict";
  var words = {
    en: {
      tagline: "Click a pixel, and read everything that its ray did.",
      bowl: "A blue bowl, ray traced: a ball, hollowed by a smaller ball and opened at the top by a cone.",
      canvas: "The workbench. F9 goes to the ray’s story as text.",
      loading: "Loading",
      "loading-bytes": "Loading: {done} of {all} MB",
      starting: "Starting",
      reload: "Load again",
      afresh: "Begin at the first scene",
      kept: "Your settings, your progress and what you edited are kept in this browser.",
      "file-title": "A web server is needed",
      "file-what": "This page was opened straight from a folder. Browsers do not let such pages load programs.",
      "file-help": "Serve the folder instead: “python3 -m http.server” in it, then open http://localhost:8000. Any other server of static files does as well.",
      "old-title": "This browser is too old",
      "old-what": "The workbench needs a browser that knows JavaScript modules and WebAssembly: Chrome or Edge 102, Firefox 114, Safari 16.4, or a newer one.",
      "old-help": "Update this browser, or open the page in another one. The command line of rayscope tells the same stories without any.",
      "wasm-title": "WebAssembly is switched off",
      "wasm-what": "The workbench is a program that browsers run as WebAssembly, which this one does not do.",
      "wasm-help": "A setting, a lockdown mode or a rule of whoever manages this machine may have switched it off. Allow it for this page, or open the page in another browser.",
      "webgl-title": "WebGL is missing",
      "webgl-what": "The workbench is drawn with WebGL, which this browser does not offer here.",
      "webgl-help": "Switch hardware acceleration on in the browser’s settings and start it again, or open the page in another browser. On a remote desktop, software WebGL is enough.",
      "load-title": "A part of the page did not arrive",
      "load-what": "The connection broke off, or the files on the server are not all of the same version.",
      "load-help": "Load the page again. If that does not help, tell whoever put it on the server which file is missing:",
      "context-title": "The graphics card was taken away",
      "context-what": "The browser took WebGL back from this page, as it does when the card is reset or too many pages use it.",
      "context-help": "Load the page again; close other pages with 3D graphics if it happens often.",
      "failed-title": "The workbench had to stop",
      "failed-what": "It ran into something that it was not made for. That is a mistake in the program, not yours.",
      "failed-help": "Load it again. If it stops at the same place, begin at the first scene, and send us what it says here:"
    },
    de: {
      tagline: "Ein Pixel anklicken und alles lesen, was sein Strahl getan hat.",
      bowl: "Eine blaue Schale als Raytracing-Bild: eine Kugel, von einer kleineren ausgehöhlt und oben von einem Kegel geöffnet.",
      canvas: "Die Werkbank. F9 führt zur Geschichte des Strahls als Text.",
      loading: "Wird geladen",
      "loading-bytes": "Wird geladen: {done} von {all} MB",
      starting: "Wird gestartet",
      reload: "Neu laden",
      afresh: "Bei der ersten Szene beginnen",
      kept: "Einstellungen, Fortschritt und alles Bearbeitete sind in diesem Browser aufgehoben.",
      "file-title": "Ein Webserver wird gebraucht",
      "file-what": "Diese Seite wurde unmittelbar aus einem Ordner geöffnet. Solche Seiten dürfen in Browsern keine Programme laden.",
      "file-help": "Den Ordner stattdessen ausliefern: darin „python3 -m http.server“ aufrufen, dann http://localhost:8000 öffnen. Jeder andere Server für statische Dateien geht auch.",
      "old-title": "Dieser Browser ist zu alt",
      "old-what": "Die Werkbank braucht einen Browser, der JavaScript-Module und WebAssembly kennt: Chrome oder Edge 102, Firefox 114, Safari 16.4 oder neuer.",
      "old-help": "Diesen Browser aktualisieren oder die Seite in einem anderen öffnen. Die Kommandozeile von rayscope erzählt dieselben Geschichten ganz ohne.",
      "wasm-title": "WebAssembly ist abgeschaltet",
      "wasm-what": "Die Werkbank ist ein Programm, das Browser als WebAssembly ausführen; dieser tut es nicht.",
      "wasm-help": "Eine Einstellung, ein Sperrmodus oder eine Vorgabe der Verwaltung dieses Rechners kann es abgeschaltet haben. Für diese Seite erlauben oder die Seite in einem anderen Browser öffnen.",
      "webgl-title": "WebGL fehlt",
      "webgl-what": "Die Werkbank wird mit WebGL gezeichnet, das dieser Browser hier nicht anbietet.",
      "webgl-help": "Die Hardwarebeschleunigung in den Einstellungen des Browsers einschalten und ihn neu starten oder die Seite in einem anderen Browser öffnen. Auf entfernten Rechnern genügt WebGL in Software.",
      "load-title": "Ein Teil der Seite ist nicht angekommen",
      "load-what": "Die Verbindung brach ab, oder die Dateien auf dem Server gehören nicht alle zur selben Fassung.",
      "load-help": "Die Seite neu laden. Hilft das nicht, bitte denen, die sie auf den Server gelegt haben, sagen, welche Datei fehlt:",
      "context-title": "Die Grafikkarte wurde weggenommen",
      "context-what": "Der Browser hat dieser Seite WebGL entzogen, wie er es tut, wenn die Karte zurückgesetzt wird oder zu viele Seiten sie benutzen.",
      "context-help": "Die Seite neu laden; andere Seiten mit 3D-Grafik schließen, wenn es oft vorkommt.",
      "failed-title": "Die Werkbank musste anhalten",
      "failed-what": "Sie ist auf etwas gestoßen, wofür sie nicht gemacht ist. Das ist ein Fehler im Programm, nicht Ihrer.",
      "failed-help": "Neu laden. Hält sie an derselben Stelle an, bei der ersten Szene beginnen und uns schicken, was hier steht:"
    }
  };

  var wanted = navigator.languages && navigator.languages.length ? navigator.languages : [navigator.language || "en"];
  var language = "en";
  for (var i = 0; i < wanted.length; i++) {
    var short = wanted[i].slice(0, 2).toLowerCase();
    if (words[short]) {
      language = short;
      break;
    }
  }

  function say(name, values) {
    return words[language][name].replace(/\{(\w+)\}/g, function (_, value) {
      return values[value];
    });
  }

  // What stands in the page already, for those who read it without scripts, is said in the reader's language.
  function fill(attribute, put) {
    var elements = document.querySelectorAll("[" + attribute + "]");
    for (var i = 0; i < elements.length; i++) {
      put(elements[i], say(elements[i].getAttribute(attribute)));
    }
  }
  document.documentElement.lang = language;
  fill("data-words", function (element, text) { element.textContent = text; });
  fill("data-words-alt", function (element, text) { element.setAttribute("alt", text); });
  fill("data-words-label", function (element, text) { element.setAttribute("aria-label", text); });

  return { all: words, language: language, say: say };
})();
