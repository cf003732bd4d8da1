// The numbers behind the viewer: 16-bit floats in base64 (io/images/half_pixels.h), decoded when they are first shown.

let halfTable = null;

// The value of each of the 65536 numbers of IEEE 754 binary16.
function halfValues() {
  if (halfTable) return halfTable;
  halfTable = new Float32Array(65536);
  for (let bits = 0; bits < 65536; ++bits) {
    const exponent = (bits >> 10) & 31, fraction = bits & 1023, sign = bits & 0x8000 ? -1 : 1;
    const special = fraction ? 0 / 0 : 1 / 0;
    const size = exponent === 0 ? fraction * 2 ** -24 : exponent === 31 ? special : (1024 + fraction) * 2 ** (exponent - 25);
    halfTable[bits] = sign * size;
  }
  return halfTable;
}

function bytesOf(address) {
  return atob(address.slice(address.indexOf(",") + 1));
}

// `exponent`: of the power of two by which the values were multiplied.
function floatsOf(address, exponent) {
  const bytes = bytesOf(address), table = halfValues(), unit = 2 ** -exponent;
  const values = new Float32Array(bytes.length / 2);
  for (let i = 0; i < values.length; ++i) values[i] = unit * table[bytes.charCodeAt(2 * i) | (bytes.charCodeAt(2 * i + 1) << 8)];
  return values;
}

// What can be shown of a case: a picture (scale "radiance" or "density", `end` of a density: its peak) or a map ("signed", "error",
// "similarity"), with values() and at(x, y). Exposure acts on pictures, and on the maps of densities, which are their differences.
// `name`: without the picture `of` which a map has the errors; "" where the case has one prediction only.
class Layer {
  constructor(key, name, of, scale, end, pixels, exposed) {
    const title = of ? of + ": " + name : name;
    Object.assign(this, { key, name, title, of, scale, end, pixels, exposed, width: pixels.width, height: pixels.height, channels: pixels.channels });
    this.decoded = null;
  }
  values() {
    if (!this.decoded) this.decoded = floatsOf(this.pixels.halves, this.pixels.exponent || 0);
    return this.decoded;
  }
  at(x, y) {
    const first = (y * this.width + x) * this.channels;
    return Array.from(this.values().subarray(first, first + this.channels));
  }
}

// { cases, colours } or null where the page has no pictures. A case has layers for its pictures and maps; `compared`: keys of the pictures
// that have maps of their own.
function readPayload() {
  const holder = document.getElementById("viewer-payload");
  if (!holder) return null;
  const payload = JSON.parse(holder.textContent);
  const table = (address) => Uint8Array.from(bytesOf(address), (c) => c.charCodeAt(0));
  const cases = payload.cases.map((item) => ({
    ...item,
    pictures: item.pictures.map((picture) => new Layer(picture.key, picture.title, "", item.kind, item.peak, payload.pictures[picture.file], true)),
    maps: item.maps.map((map) => new Layer(map.key, map.title, map.of || "", map.scale, map.end, map, item.kind === "density")),
    compared: Array.from(new Set(item.maps.map((map) => map.of).filter(Boolean))),
  }));
  return { cases, colours: { sequential: table(payload.colours.sequential), diverging: table(payload.colours.diverging) } };
}
