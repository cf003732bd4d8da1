// Which part of a picture is seen: its centre in shares of width and height, and a zoom of 1 where the whole picture fits.

const LARGEST_ZOOM = 64;

function wholePicture() {
  return { x: 0.5, y: 0.5, zoom: 1 };
}

// Screen pixels per picture pixel in a panel { left, top, width, height }.
function scaleIn(panel, layer, viewpoint) {
  return viewpoint.zoom * Math.min(panel.width / layer.width, panel.height / layer.height);
}

// Where the picture's top left corner lies on the screen.
function originIn(panel, layer, viewpoint) {
  const scale = scaleIn(panel, layer, viewpoint);
  return {
    x: panel.left + panel.width / 2 - viewpoint.x * layer.width * scale,
    y: panel.top + panel.height / 2 - viewpoint.y * layer.height * scale,
  };
}

// The pixel of the picture under a point of the screen, or null beside the picture.
function pixelUnder(panel, layer, viewpoint, x, y) {
  const origin = originIn(panel, layer, viewpoint), scale = scaleIn(panel, layer, viewpoint);
  const pixel = { x: Math.floor((x - origin.x) / scale), y: Math.floor((y - origin.y) / scale) };
  const inside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < layer.width && pixel.y < layer.height;
  return inside ? pixel : null;
}

// Changes the zoom; what lies under the point (x, y) stays there.
function zoomAt(panel, layer, viewpoint, factor, x, y) {
  const before = originIn(panel, layer, viewpoint), old = scaleIn(panel, layer, viewpoint);
  const u = (x - before.x) / old, v = (y - before.y) / old;
  viewpoint.zoom = Math.min(LARGEST_ZOOM, Math.max(1, viewpoint.zoom * factor));
  const scale = scaleIn(panel, layer, viewpoint);
  viewpoint.x = (u - (x - panel.left - panel.width / 2) / scale) / layer.width;
  viewpoint.y = (v - (y - panel.top - panel.height / 2) / scale) / layer.height;
  keepInside(viewpoint);
}

function panBy(panel, layer, viewpoint, dx, dy) {
  const scale = scaleIn(panel, layer, viewpoint);
  viewpoint.x -= dx / (scale * layer.width);
  viewpoint.y -= dy / (scale * layer.height);
  keepInside(viewpoint);
}

// The centre of the view never leaves the picture, and the whole picture stands in the middle.
function keepInside(viewpoint) {
  const reach = viewpoint.zoom === 1 ? 0 : 0.5;
  viewpoint.x = Math.min(0.5 + reach, Math.max(0.5 - reach, viewpoint.x));
  viewpoint.y = Math.min(0.5 + reach, Math.max(0.5 - reach, viewpoint.y));
}
