// One case in the viewer: what is shown (state) and how it is drawn. Its buttons are in viewer_panel.js, mouse and keys in viewer_input.js.

// What all cases of a kind share while they are linked.
function freshState(tone) {
  return { viewpoint: wholePicture(), display: { stops: 0, tone }, layout: { mode: "one", split: 0.5 } };
}
const common = { radiance: freshState("srgb"), density: freshState("log") };
const viewers = [];
const PANEL_GAP = 8;  // CSS pixels between panels side by side

class Viewer {
  constructor(place, item, colours) {
    Object.assign(this, { place, item, colours, active: 0, behind: 1, pixel: null, linked: true });
    this.compare(item.compared[0] || "");
    this.own = freshState(common[item.kind].display.tone);
    buildPanel(this);
    listen(this);
    new ResizeObserver(() => this.draw()).observe(this.canvas);
    viewers.push(this);
  }

  state() {
    return this.linked ? common[this.item.kind] : this.own;
  }

  // Draws again whatever shows the state that has just been changed.
  changed() {
    const kind = this.item.kind;
    viewers.filter((viewer) => viewer === this || (this.linked && viewer.linked && viewer.item.kind === kind)).forEach((viewer) => {
      updatePanel(viewer);
      viewer.draw();
    });
  }

  // Takes the maps of one picture among the layers, which keep their places.
  compare(of) {
    this.compared = of;
    this.layers = [...this.item.pictures, ...this.item.maps.filter((map) => map.of === of)];
    [this.active, this.behind] = [this.active, this.behind].map((number) => Math.min(number, this.layers.length - 1));
  }

  // The same, and shows it.
  showMapsOf(of) {
    this.compare(of);
    fillLayers(this);
    updatePanel(this);
    updateReadout(this);
    this.draw();
  }

  // The maps follow the prediction that is looked at.
  show(number) {
    if (!this.layers[number]) return;
    if (number === this.behind) this.behind = this.active;
    this.active = number;
    const key = this.layers[number].key;
    if (number < this.item.pictures.length && key !== this.compared && this.item.compared.includes(key)) this.showMapsOf(key);
    updatePanel(this);
    this.draw();
  }

  point(pixel) {
    this.pixel = pixel;
    updateReadout(this);
    this.draw();
  }

  // Numbers of the layers that have a panel.
  shown() {
    if (this.state().layout.mode !== "side") return [this.active];
    const partner = Math.max(1, this.item.pictures.findIndex((picture) => picture.key === this.compared));
    return Array.from(new Set([0, partner, this.active]));
  }

  // Panels in CSS pixels with their layers: one, or several of one size side by side.
  panels() {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight, shown = this.shown();
    const each = (width - PANEL_GAP * (shown.length - 1)) / shown.length;
    return shown.map((layer, i) => ({ left: i * (each + PANEL_GAP), top: 0, width: each, height, layer: this.layers[layer] }));
  }

  panelAt(x) {
    const panels = this.panels();
    return panels.find((panel) => x < panel.left + panel.width + PANEL_GAP) || panels[panels.length - 1];
  }

  draw() {
    const ratio = window.devicePixelRatio || 1, canvas = this.canvas;
    const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
    if (!width || !height) return;
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    const context = canvas.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.imageSmoothingEnabled = false;
    context.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
    const mode = this.state().layout.mode;
    this.panels().forEach((panel) => {
      this.drawLayer(context, panel, panel.layer, panel.left, panel.width);
      if (mode === "side") label(context, panel.layer.title, panel.left + 8, "left");
    });
    if (mode === "split") this.drawSplit(context);
  }

  // The part of a layer from `left` on, `width` wide, with a mark around the pixel whose values are shown.
  drawLayer(context, panel, layer, left, width) {
    const { viewpoint, display } = this.state();
    const origin = originIn(panel, layer, viewpoint), scale = scaleIn(panel, layer, viewpoint);
    context.save();
    context.beginPath();
    context.rect(left, panel.top, width, panel.height);
    context.clip();
    context.drawImage(bitmapOf(layer, display, this.colours), origin.x, origin.y, layer.width * scale, layer.height * scale);
    if (this.pixel) {
      const side = Math.max(scale, 5), inset = (scale - side) / 2;
      const x = origin.x + this.pixel.x * scale + inset, y = origin.y + this.pixel.y * scale + inset;
      context.strokeStyle = "#000";
      context.strokeRect(x - 1, y - 1, side + 2, side + 2);
      context.strokeStyle = "#fff";
      context.strokeRect(x, y, side, side);
    }
    context.restore();
  }

  // Left of the line the shown layer, right of it the one behind.
  drawSplit(context) {
    const panel = this.panels()[0], x = this.state().layout.split * panel.width;
    context.clearRect(x, 0, panel.width - x, panel.height);
    this.drawLayer(context, panel, this.layers[this.behind], x, panel.width - x);
    context.fillStyle = "#fff";
    context.fillRect(x - 1, 0, 2, panel.height);
    label(context, this.layers[this.active].title, x - 8, "right");
    label(context, this.layers[this.behind].title, x + 8, "left");
  }
}

// White text with a dark rim at the top of the canvas.
function label(context, text, x, align) {
  context.save();
  Object.assign(context, { font: "12px sans-serif", textBaseline: "top", textAlign: align, strokeStyle: "#000", fillStyle: "#fff", lineWidth: 3 });
  context.strokeText(text, x, 6);
  context.fillText(text, x, 6);
  context.restore();
}
