// Starts what the page has. Without the script the page is complete: tables in reading order, pictures as stills.

document.querySelectorAll("table.sortable").forEach(makeSortable);
document.querySelectorAll("table.filterable").forEach(makeFilterable);

const payload = readPayload();
if (payload) {
  document.querySelectorAll(".viewer").forEach((holder) => {
    const item = payload.cases[Number(holder.dataset.case)];
    if (!item) return;
    new Viewer(holder, item, payload.colours);
    holder.parentNode.classList.add("has-viewer");
  });
  document.addEventListener("keydown", onKey);
}

window.addEventListener("beforeprint", () => {
  document.querySelectorAll("details").forEach((part) => { part.open = true; });
});
