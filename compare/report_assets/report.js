// Without this script the page is complete; it adds sorting by column, and unfolds everything for printing.
// It avoids the two characters that XML would want escaped, so that the page stays well-formed XML.
(function () {
  "use strict";
  function key(row, column) {
    var cell = row.children[column];
    var order = cell.getAttribute("data-order");
    return order === null ? cell.textContent.trim() : parseFloat(order);
  }
  // Absent numbers ("–") stay at the end in both directions.
  function compare(a, b, direction) {
    var absent = a === "–" ? 1 : 0, other = b === "–" ? 1 : 0;
    if (absent !== other) return absent - other;
    if (typeof a === "number") return typeof b === "number" ? direction * (a - b) : 0;
    return direction * a.localeCompare(b, "en", { numeric: true });
  }
  function sort(table, head, column) {
    var direction = head.getAttribute("aria-sort") === "descending" ? 1 : -1;
    var body = table.tBodies[0];
    Array.from(body.rows)
      .sort(function (a, b) { return compare(key(a, column), key(b, column), direction); })
      .forEach(function (row) { body.appendChild(row); });
    Array.from(head.parentNode.children).forEach(function (other) { other.removeAttribute("aria-sort"); });
    head.setAttribute("aria-sort", direction === 1 ? "ascending" : "descending");
  }
  document.querySelectorAll("table.sortable").forEach(function (table) {
    Array.from(table.tHead.rows[0].cells).forEach(function (head, column) {
      var button = document.createElement("button");
      button.type = "button";
      button.className = "sort";
      while (head.firstChild) button.appendChild(head.firstChild);
      head.appendChild(button);
      button.addEventListener("click", function () { sort(table, head, column); });
    });
  });
  window.addEventListener("beforeprint", function () {
    document.querySelectorAll("details").forEach(function (part) { part.open = true; });
  });
})();
