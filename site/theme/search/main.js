// Search in the page itself: a worker, as MkDocs uses, may not be started from a file.
(function () {
  "use strict";

  function element(name, text, attributes) {
    const made = Object.assign(document.createElement(name), attributes);
    made.textContent = text;
    return made;
  }

  // The part of a text about the first word that was asked for.
  function excerpt(text, words) {
    const lower = text.toLowerCase();
    const places = words.map((word) => lower.indexOf(word)).filter((place) => place >= 0);
    const from = Math.max(0, (places.length ? Math.min(...places) : 0) - 80);
    return (from > 0 ? "… " : "") + text.slice(from, from + 240) + (from + 240 < text.length ? " …" : "");
  }

  function show(place, query, index, documents) {
    place.replaceChildren();
    const words = query.toLowerCase().split(/\s+/).filter(Boolean);
    const found = words.length ? index.query((q) => {
      for (const word of words) {
        q.term(lunr.tokenizer(word), { boost: 10 });
        q.term(lunr.tokenizer(word), { wildcard: lunr.Query.wildcard.TRAILING });
      }
    }) : [];
    for (const { ref } of found.slice(0, 40)) {
      const entry = document.createElement("article");
      const heading = document.createElement("h3");
      heading.append(element("a", documents.get(ref).title, { href: base_url.replace(/\/?$/, "/") + ref }));
      entry.append(heading, element("p", excerpt(documents.get(ref).text, words)));
      place.append(entry);
    }
    if (!found.length) place.append(element("p", place.dataset.noResultsText || "No results found"));
  }

  function start() {
    const input = document.getElementById("mkdocs-search-query");
    const place = document.getElementById("mkdocs-search-results");
    if (!input || !place) return;
    const documents = new Map(window.search_index.map((entry) => [entry.location, entry]));
    const index = lunr(function () {
      this.ref("location");
      this.field("title", { boost: 10 });
      this.field("text");
      window.search_index.forEach((entry) => this.add(entry));
    });
    const search = () => show(place, input.value, index, documents);
    input.addEventListener("input", search);
    input.value = new URLSearchParams(window.location.search).get("q") || input.value;
    search();
  }

  start();
})();
