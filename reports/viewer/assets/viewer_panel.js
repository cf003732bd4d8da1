// The buttons and sliders of a case in the viewer.

const LAYOUTS = [["one", "One"], ["split", "Split"], ["side", "Side by side"]];
const TONES = {
  radiance: [["srgb", "sRGB, clamped"], ["reinhard", "Reinhard"], ["log", "Luminance, logarithmic"]],
  density: [["linear", "Linear"], ["log", "Logarithmic"]],
};
const MOST_STOPS = 10;

function make(tag, attributes, ...children) {
  const element = document.createElement(tag);
  Object.entries(attributes).forEach(([name, value]) => element.setAttribute(name, value));
  element.append(...children);
  return element;
}

function choice(label, name, options) {
  const select = make("select", { class: name });
  options.forEach(([value, text]) => select.append(make("option", { value }, text)));
  return [make("label", {}, label + " ", select), select];
}

function slider(label, name, low, high, step) {
  const input = make("input", { type: "range", class: name, min: low, max: high, step });
  const output = make("output", {});
  return [make("label", {}, label + " ", input, output), input, output];
}

// The digit key of a layer as a mark before its name; the tenth and later ones have none.
function keyMark(i) {
  return i < 9 ? [make("kbd", {}, String(i + 1)), " "] : [];
}

// The buttons of the layers: pictures, the choice whose error maps follow, and the maps.
function fillLayers(viewer) {
  const parts = viewer.parts, pictures = viewer.item.pictures.length;
  parts.layers = viewer.layers.map((layer, i) => {
    const button = make("button", { type: "button", title: i < 9 ? "key " + (i + 1) : layer.title }, ...keyMark(i), layer.name);
    button.addEventListener("click", () => viewer.show(i));
    return button;
  });
  parts.layerBar.replaceChildren(...parts.layers.slice(0, pictures), ...parts.comparedChoice, ...parts.layers.slice(pictures));
  parts.behind.replaceChildren(...viewer.layers.map((layer, i) => make("option", { value: i }, layer.title)));
}

function buildPanel(viewer) {
  const parts = (viewer.parts = {}), compared = viewer.item.compared;
  let layout, behind, tone, link, exposure, split, maps;
  [maps, parts.compared] = choice("Errors of", "compared", compared.map((of) => [of, of]));
  parts.comparedChoice = compared.length > 1 ? [maps] : [];
  parts.layerBar = make("div", { class: "layers", role: "group", "aria-label": "Layer" });
  [layout, parts.layout] = choice("Layout", "layout", LAYOUTS);
  [behind, parts.behind] = choice("Right of the split", "behind", []);
  [split, parts.split] = slider("Split", "split", 0, 1, 0.01);
  [exposure, parts.exposure, parts.exposureText] = slider("Exposure", "exposure", -MOST_STOPS, MOST_STOPS, 0.25);
  [tone, parts.tone] = choice(viewer.item.kind === "density" ? "Scale" : "Tones", "tone", TONES[viewer.item.kind]);
  parts.link = make("input", { type: "checkbox", class: "link" });
  link = make("label", {}, parts.link, " same view in all cases");
  parts.whole = make("button", { type: "button", class: "whole" }, "Whole picture");
  parts.splitControls = [behind, split];

  viewer.canvas = make("canvas", { tabindex: 0, role: "img", "aria-label": viewer.item.title + ": arrow keys choose a pixel" });
  parts.legend = make("p", { class: "legend" });
  viewer.readout = make("div", { class: "readout" });
  const help = "Keys: 1 … 9 layer, " + (compared.length > 1 ? "m errors of the next prediction, " : "") +
    "arrows pixel (Shift: 10), + − 0 zoom, [ ] split, e E exposure, l next tones or scale. Mouse: drag, wheel (after a click), double click.";
  viewer.place.append(
    parts.layerBar,
    make("div", { class: "controls" }, layout, behind, split, exposure, tone, parts.whole, link),
    viewer.canvas, parts.legend, viewer.readout, make("p", { class: "help" }, help));
  fillLayers(viewer);
  wirePanel(viewer);
  updatePanel(viewer);
  updateReadout(viewer);
}

function wirePanel(viewer) {
  const parts = viewer.parts;
  const set = (part, event, change) => part.addEventListener(event, () => { change(viewer.state()); viewer.changed(); });
  set(parts.layout, "change", (state) => { state.layout.mode = parts.layout.value; });
  set(parts.split, "input", (state) => { state.layout.split = Number(parts.split.value); });
  set(parts.exposure, "input", (state) => { state.display.stops = Number(parts.exposure.value); });
  set(parts.tone, "change", (state) => { state.display.tone = parts.tone.value; });
  set(parts.whole, "click", (state) => { Object.assign(state.viewpoint, wholePicture()); });
  parts.compared.addEventListener("change", () => viewer.showMapsOf(parts.compared.value));
  set(parts.behind, "change", () => { viewer.behind = Number(parts.behind.value); });
  parts.link.addEventListener("change", () => {
    const { viewpoint, display, layout } = viewer.state();
    viewer.own = { viewpoint: { ...viewpoint }, display: { ...display }, layout: { ...layout } };
    viewer.linked = parts.link.checked;
    viewer.changed();
  });
}

// Shows the viewer's state on its buttons.
function updatePanel(viewer) {
  const parts = viewer.parts, { display, layout } = viewer.state();
  parts.layers.forEach((button, i) => button.setAttribute("aria-pressed", String(i === viewer.active)));
  parts.layout.value = layout.mode;
  parts.compared.value = viewer.compared;
  parts.behind.value = String(viewer.behind);
  parts.split.value = String(layout.split);
  parts.exposure.value = String(display.stops);
  parts.exposureText.textContent = (display.stops > 0 ? "+" : "") + String(display.stops).replace("-", "−") + " stops";
  parts.tone.value = display.tone;
  parts.link.checked = viewer.linked;
  parts.splitControls.forEach((part) => { part.hidden = layout.mode !== "split"; });
  const picture = viewer.layers[0];
  viewer.canvas.style.aspectRatio = String(viewer.shown().length * picture.width / picture.height);
  parts.legend.replaceChildren(...legendOf(viewer.layers[viewer.active], display, viewer.colours));
}

// A bar of the layer's colours with the values at its ends; nothing for a picture in its own colours.
function legendOf(layer, display, colours) {
  const picture = layer.scale === "radiance" || layer.scale === "density", logarithmic = picture && display.tone === "log";
  if (layer.scale === "radiance" && !logarithmic) return [];
  const table = layer.scale === "signed" ? colours.diverging : colours.sequential;
  const stops = [];
  for (let i = 0; i < 256; i += 17) stops.push("rgb(" + table.slice(3 * i, 3 * i + 3).join(",") + ")");
  const bar = make("span", { class: "bar", style: "background: linear-gradient(to right, " + stops.join(", ") + ")" });
  const brightest = (layer.scale === "density" ? layer.end : 1) * 2 ** -display.stops;  // what has the lightest colour
  const end = Number(mapEnd(layer, display).toPrecision(4));
  const ends = logarithmic ? ["≤ " + (brightest * 10 ** -LOG_DECADES[layer.scale]).toPrecision(3), brightest.toPrecision(3)] :
    picture ? ["0", brightest.toPrecision(3)] :
    layer.scale === "signed" ? ["−" + end, "+" + end] :
    layer.scale === "similarity" ? ["1", "≤ " + Number((1 - end).toPrecision(4))] : ["0", "≥ " + end];
  const scale = logarithmic ? (layer.scale === "radiance" ? ", luminance (logarithmic)" : ", logarithmic") : picture ? ", linear" : "";
  return [layer.title + scale + ": ", ends[0], " ", bar, " ", ends[1]];
}
