// Tables as the theme draws them; wide ones scroll in a frame of their own.
for (const table of document.querySelectorAll(".rst-content table")) {
  const frame = Object.assign(document.createElement("div"), { className: "wy-table-responsive" });
  table.classList.add("docutils");
  table.replaceWith(frame);
  frame.append(table);
}
