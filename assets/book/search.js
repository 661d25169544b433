// Finds pages by their words: every word has to begin a word of the title or of the text. Titles count for more.
"use strict";
(() => {
  const input = document.getElementById("query");
  const list = document.getElementById("results");
  const found = document.getElementById("found");
  const most = 40;
  const wordsOf = (text) => text.toLowerCase().split(/[^\p{L}\p{N}]+/u).filter(Boolean);
  const pages = INDEX.map(([title, path, words]) => ({ title, path, heads: wordsOf(title), words: words.split(" ") }));

  const score = (page, wanted) => {
    let sum = 0;
    for (const word of wanted) {
      if (page.heads.includes(word)) sum += 8;
      else if (page.heads.some((head) => head.startsWith(word))) sum += 5;
      else if (page.words.includes(word)) sum += 2;
      else if (page.words.some((other) => other.startsWith(word))) sum += 1;
      else return 0;
    }
    return sum;
  };

  const show = () => {
    const wanted = wordsOf(input.value);
    const hits = wanted.length === 0 ? [] : pages
      .map((page, place) => ({ page, place, score: score(page, wanted) }))
      .filter((hit) => hit.score > 0)
      .sort((a, b) => b.score - a.score || a.place - b.place);
    list.replaceChildren(...hits.slice(0, most).map(({ page }) => {
      const item = document.createElement("li");
      const link = document.createElement("a");
      link.href = page.path;
      link.textContent = page.title;
      item.append(link);
      return item;
    }));
    const more = hits.length > most ? `, the first ${most} are shown` : "";
    found.textContent = wanted.length === 0 ? "" : `${hits.length === 0 ? "Nothing" : hits.length} found${more}.`;
  };

  input.value = new URLSearchParams(location.search).get("q") ?? "";
  input.addEventListener("input", show);
  input.form.addEventListener("submit", (event) => { event.preventDefault(); show(); });
  show();
  input.focus();
})();
