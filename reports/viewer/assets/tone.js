// From values to the colours of the screen.

// Of the logarithmic false colours, below the radiance that exposure makes white, or below the peak of a density.
const LOG_DECADES = { radiance: 4, density: 3 };

function srgbByte(linear) {
  const x = Math.min(1, Math.max(0, linear));
  return Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
}

function luma(r, g, b) {
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

// Writes colour number t (0 … 1) of a table of 256 at byte `to`.
function putColour(bytes, to, table, t) {
  const entry = 3 * Math.round(255 * Math.min(1, Math.max(0, t)));
  for (let c = 0; c < 3; ++c) bytes[to + c] = table[entry + c];
}

// Green stands for a radiance that is no number, as on the stills; grey for a map that has no value there.
function putNoValue(bytes, to, isMap) {
  bytes[to] = bytes[to + 2] = isMap ? 128 : 0;
  bytes[to + 1] = isMap ? 128 : 255;
}

// display: { stops, tone }: the exposure in powers of two, and "srgb", "reinhard" or "log".
function paintRadiance(layer, display, colours, bytes) {
  const values = layer.values(), gain = 2 ** display.stops;
  for (let i = 0, to = 0; to < bytes.length; i += 3, to += 4) {
    bytes[to + 3] = 255;
    const r = gain * values[i], g = gain * values[i + 1], b = gain * values[i + 2], light = luma(r, g, b);
    if (Number.isNaN(light)) {
      putNoValue(bytes, to, false);
    } else if (display.tone === "log") {
      putColour(bytes, to, colours.sequential, light > 0 ? 1 + Math.log10(light) / LOG_DECADES.radiance : 0);
    } else {
      const press = display.tone === "reinhard" ? 1 / (1 + Math.max(0, light)) : 1;
      bytes[to] = srgbByte(press * r);
      bytes[to + 1] = srgbByte(press * g);
      bytes[to + 2] = srgbByte(press * b);
    }
  }
}

// Relative to the peak that all densities of the case have in common; display.tone is "linear" or "log".
function paintDensity(layer, display, colours, bytes) {
  const values = layer.values(), gain = 2 ** display.stops / layer.end, log = display.tone === "log";
  for (let i = 0, to = 0; to < bytes.length; ++i, to += 4) {
    bytes[to + 3] = 255;
    const share = gain * values[i];
    if (Number.isNaN(share)) putNoValue(bytes, to, false);
    else putColour(bytes, to, colours.sequential, log ? (share > 0 ? 1 + Math.log10(share) / LOG_DECADES.density : 0) : share);
  }
}

// Where a map's colours end.
function mapEnd(layer, display) {
  return layer.exposed ? layer.end * 2 ** -display.stops : layer.end;
}

function mapPosition(layer, value, end) {
  if (layer.scale === "signed") return 0.5 + 0.5 * value / end;
  return (layer.scale === "similarity" ? 1 - value : value) / end;
}

function paintMap(layer, display, colours, bytes) {
  const values = layer.values(), end = mapEnd(layer, display), table = layer.scale === "signed" ? colours.diverging : colours.sequential;
  for (let i = 0, to = 0; to < bytes.length; ++i, to += 4) {
    bytes[to + 3] = 255;
    if (Number.isNaN(values[i])) putNoValue(bytes, to, true);
    else putColour(bytes, to, table, mapPosition(layer, values[i], end));
  }
}

// The layer as a canvas of its own size; painted anew only where the display has changed.
function bitmapOf(layer, display, colours) {
  const paint = { radiance: paintRadiance, density: paintDensity }[layer.scale] || paintMap;
  const state = layer.exposed ? display.tone + " " + display.stops : "map";
  if (layer.paintedAs === state) return layer.bitmap;
  if (!layer.bitmap) layer.bitmap = make("canvas", { width: layer.width, height: layer.height });
  const context = layer.bitmap.getContext("2d"), image = context.createImageData(layer.width, layer.height);
  paint(layer, display, colours, image.data);
  context.putImageData(image, 0, 0);
  layer.paintedAs = state;
  return layer.bitmap;
}
