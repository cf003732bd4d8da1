// Tables: sorting by column, and filters by text and by state. Without the script every row is there, in its reading order.

function sortKey(row, column) {
  const cell = row.children[column];
  const order = cell.getAttribute("data-order");
  return order === null ? cell.textContent.trim() : parseFloat(order);
}

// Absent numbers ("–") stay at the end in both directions.
function compareKeys(a, b, direction) {
  const absent = a === "–" ? 1 : 0, other = b === "–" ? 1 : 0;
  if (absent !== other) return absent - other;
  if (typeof a === "number") return typeof b === "number" ? direction * (a - b) : 0;
  return direction * a.localeCompare(b, "en", { numeric: true });
}

function sortTable(table, head, column) {
  const direction = head.getAttribute("aria-sort") === "descending" ? 1 : -1;
  const body = table.tBodies[0];
  Array.from(body.rows)
    .sort((a, b) => compareKeys(sortKey(a, column), sortKey(b, column), direction))
    .forEach((row) => body.appendChild(row));
  Array.from(head.parentNode.children).forEach((other) => other.removeAttribute("aria-sort"));
  head.setAttribute("aria-sort", direction === 1 ? "ascending" : "descending");
}

function makeSortable(table) {
  Array.from(table.tHead.rows[0].cells).forEach((head, column) => {
    const button = make("button", { type: "button", class: "sort" });
    while (head.firstChild) button.appendChild(head.firstChild);
    head.appendChild(button);
    button.addEventListener("click", () => sortTable(table, head, column));
  });
}

function makeFilterable(table) {
  const rows = Array.from(table.tBodies[0].rows);
  if (rows.length < 5) return;
  const states = Array.from(new Set(rows.map((row) => row.dataset.status).filter(Boolean)));
  const text = make("input", { type: "search", class: "filter-text", placeholder: "text", autocomplete: "off" });
  const state = make("select", { class: "filter-status" }, make("option", { value: "" }, "all"));
  states.forEach((name) => state.append(make("option", { value: name }, name + " (" + rows.filter((r) => r.dataset.status === name).length + ")")));
  const count = make("output", {});

  function apply() {
    const words = text.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    rows.forEach((row) => {
      const content = row.textContent.toLowerCase();
      const fits = words.every((word) => content.includes(word)) && (!state.value || row.dataset.status === state.value);
      row.hidden = !fits;
      if (fits) ++shown;
    });
    count.textContent = shown === rows.length ? rows.length + " rows" : shown + " of " + rows.length + " rows";
  }
  text.addEventListener("input", apply);
  state.addEventListener("change", apply);
  const bar = make("div", { class: "filters", role: "search" }, make("label", {}, "Filter ", text));
  if (states.length > 1) bar.append(make("label", {}, "Status ", state));
  bar.append(count);
  table.closest(".scroll").before(bar);
  apply();
}
