// Mouse, pen, touch and keys over the viewer.

const ZOOM_STEP = 1.25;
const SPLIT_STEP = 0.02;
const EXPOSURE_STEP = 0.5;
const SPLIT_REACH = 8;  // CSS pixels around the split line that take hold of it

let current = null;  // the case under the pointer or with the focus: keys go there

function place(viewer, event) {
  const frame = viewer.canvas.getBoundingClientRect();
  return { x: event.clientX - frame.left, y: event.clientY - frame.top };
}

function listen(viewer) {
  const canvas = viewer.canvas;
  let drag = null;
  viewer.place.addEventListener("pointerenter", () => { current = viewer; });
  viewer.place.addEventListener("focusin", () => { current = viewer; });
  canvas.addEventListener("pointerdown", (event) => {
    const at = place(viewer, event), layout = viewer.state().layout;
    const onSplit = layout.mode === "split" && Math.abs(at.x - layout.split * canvas.clientWidth) < SPLIT_REACH;
    drag = { ...at, onSplit };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    const at = place(viewer, event), { viewpoint, layout } = viewer.state(), panel = viewer.panelAt(at.x);
    if (drag) {
      if (drag.onSplit) layout.split = Math.min(1, Math.max(0, at.x / canvas.clientWidth));
      else panBy(panel, panel.layer, viewpoint, at.x - drag.x, at.y - drag.y);
      Object.assign(drag, at);
      viewer.changed();
    }
    const pixel = pixelUnder(panel, panel.layer, viewpoint, at.x, at.y);
    if (pixel) viewer.point(pixel);
  });
  ["pointerup", "pointercancel"].forEach((name) => canvas.addEventListener(name, () => { drag = null; }));
  canvas.addEventListener("dblclick", () => { Object.assign(viewer.state().viewpoint, wholePicture()); viewer.changed(); });
  // The wheel scrolls the page until the picture has the focus.
  canvas.addEventListener("wheel", (event) => {
    if (document.activeElement !== canvas) return;
    event.preventDefault();
    const at = place(viewer, event);
    zoomBy(viewer, event.deltaY > 0 ? 1 / ZOOM_STEP : ZOOM_STEP, at);
  }, { passive: false });
}

function zoomBy(viewer, factor, at) {
  const panel = viewer.panelAt(at.x);
  zoomAt(panel, panel.layer, viewer.state().viewpoint, factor, at.x, at.y);
  viewer.changed();
}

// Keyboard zoom keeps the chosen pixel where it is, or the middle of the first panel.
function zoomCentre(viewer) {
  const panel = viewer.panels()[0], layer = panel.layer, viewpoint = viewer.state().viewpoint;
  if (!viewer.pixel) return { x: panel.left + panel.width / 2, y: panel.top + panel.height / 2 };
  const origin = originIn(panel, layer, viewpoint), scale = scaleIn(panel, layer, viewpoint);
  return { x: origin.x + (viewer.pixel.x + 0.5) * scale, y: origin.y + (viewer.pixel.y + 0.5) * scale };
}

function movePixel(viewer, dx, dy) {
  const layer = viewer.layers[viewer.active];
  const from = viewer.pixel || { x: Math.floor(layer.width / 2), y: Math.floor(layer.height / 2) };
  const clamp = (value, end) => Math.min(end - 1, Math.max(0, value));
  viewer.point({ x: clamp(from.x + dx, layer.width), y: clamp(from.y + dy, layer.height) });
}

const keys = {
  "+": (viewer) => zoomBy(viewer, ZOOM_STEP, zoomCentre(viewer)),
  "-": (viewer) => zoomBy(viewer, 1 / ZOOM_STEP, zoomCentre(viewer)),
  "0": (viewer) => { Object.assign(viewer.state().viewpoint, wholePicture()); viewer.changed(); },
  "[": (viewer) => moveSplit(viewer, -SPLIT_STEP),
  "]": (viewer) => moveSplit(viewer, SPLIT_STEP),
  "e": (viewer) => expose(viewer, EXPOSURE_STEP),
  "E": (viewer) => expose(viewer, -EXPOSURE_STEP),
  "l": nextTone,
  "m": nextCompared,
};

function nextCompared(viewer) {
  const all = viewer.item.compared;
  if (all.length > 1) viewer.showMapsOf(all[(all.indexOf(viewer.compared) + 1) % all.length]);
}

function nextTone(viewer) {
  const display = viewer.state().display, tones = TONES[viewer.item.kind].map(([tone]) => tone);
  display.tone = tones[(tones.indexOf(display.tone) + 1) % tones.length];
  viewer.changed();
}

function moveSplit(viewer, by) {
  const layout = viewer.state().layout;
  layout.split = Math.min(1, Math.max(0, layout.split + by));
  viewer.changed();
}

function expose(viewer, by) {
  const display = viewer.state().display;
  display.stops = Math.min(MOST_STOPS, Math.max(-MOST_STOPS, display.stops + by));
  viewer.changed();
}

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

function onKey(event) {
  const target = event.target, types = target.matches("select, textarea, input:not([type=range]):not([type=checkbox])");
  if (!current || types || event.ctrlKey || event.metaKey || event.altKey) return;
  const arrow = ARROWS[event.key];
  if (arrow) {
    if (target !== current.canvas) return;
    const step = event.shiftKey ? 10 : 1;
    movePixel(current, step * arrow[0], step * arrow[1]);
  } else if (/^[1-9]$/.test(event.key)) {
    current.show(Number(event.key) - 1);
  } else if (Object.hasOwn(keys, event.key)) {
    keys[event.key](current);
  } else {
    return;
  }
  event.preventDefault();
}
