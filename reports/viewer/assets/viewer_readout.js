// The numbers under the cursor, of every layer of the case.

const HALF_PRECISION = "16-bit floats: rounded by at most 0.05 %";

// Where the middle of the pixel lies from the middle of the picture, x to the right and y up; "" for pictures without angles.
function placeText(item, layer, pixel) {
  if (!item.pixelArcmin) return "";
  const side = item.pixelArcmin * item.factor, sign = (value) => (value < 0 ? "−" : "+") + Math.abs(value).toFixed(2);
  const x = (pixel.x + 0.5 - layer.width / 2) * side, y = (layer.height / 2 - pixel.y - 0.5) * side;
  return " at (" + sign(x) + ", " + sign(y) + ") arcmin";
}

function numberText(value) {
  if (Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "beyond 65504" : "below −65504";
  return value.toPrecision(4).replace("-", "−");
}

function updateReadout(viewer) {
  const pixel = viewer.pixel, item = viewer.item, factor = item.factor;
  const blocks = factor > 1 ? ", means of " + factor + " × " + factor + " pixels" : "";
  const caption = pixel ? "Pixel (" + pixel.x * factor + ", " + pixel.y * factor + ")" + placeText(item, viewer.layers[0], pixel) + blocks : "Pixel: none chosen" + blocks;
  const channels = item.kind === "density" ? [0] : [0, 1, 2];
  const rows = viewer.layers.map((layer, i) => {
    const values = pixel ? layer.at(pixel.x, pixel.y) : [];
    const cells = channels.map((c) =>
      c < values.length ? make("td", { "data-value": values[c] }, numberText(values[c])) : make("td", {}, pixel ? "" : "–"));
    return make("tr", { "data-layer": layer.key }, make("th", { scope: "row" }, ...keyMark(i), layer.title), ...cells);
  });
  const heads = (item.kind === "density" ? ["Layer", "Value"] : ["Layer", "R, or value", "G", "B"]).map((text) => make("th", { scope: "col" }, text));
  viewer.readout.replaceChildren(
    make("table", {}, make("caption", {}, caption + " · " + item.quantity + " · " + HALF_PRECISION),
      make("thead", {}, make("tr", {}, ...heads)), make("tbody", {}, ...rows)));
}
