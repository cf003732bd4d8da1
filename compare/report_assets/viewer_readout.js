// The numbers under the cursor, of every layer of the case.

const HALF_PRECISION = "16-bit floats: rounded by at most 0.05 %";

function numberText(value) {
  if (Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "beyond 65504" : "below −65504";
  return value.toPrecision(4).replace("-", "−");
}

function updateReadout(viewer) {
  const pixel = viewer.pixel, factor = viewer.item.factor;
  const blocks = factor > 1 ? ", means of " + factor + " × " + factor + " pixels" : "";
  const caption = pixel ? "Pixel (" + pixel.x * factor + ", " + pixel.y * factor + ")" + blocks : "Pixel: none chosen" + blocks;
  const rows = viewer.layers.map((layer, i) => {
    const values = pixel ? layer.at(pixel.x, pixel.y) : [];
    const cells = [0, 1, 2].map((c) =>
      c < values.length ? make("td", { "data-value": values[c] }, numberText(values[c])) : make("td", {}, pixel ? "" : "–"));
    return make("tr", { "data-layer": layer.key }, make("th", { scope: "row" }, make("kbd", {}, String(i + 1)), " " + layer.title), ...cells);
  });
  const heads = ["Layer", "R, or value", "G", "B"].map((text) => make("th", { scope: "col" }, text));
  viewer.readout.replaceChildren(
    make("table", {}, make("caption", {}, caption + " · pictures in linear Rec. 709 radiance, maps at exposure 0 · " + HALF_PRECISION),
      make("thead", {}, make("tr", {}, ...heads)), make("tbody", {}, ...rows)));
}
