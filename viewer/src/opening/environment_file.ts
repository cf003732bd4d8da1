/** HDR and EXR pictures of all directions. */
import { FloatType } from 'three';
import { EXRLoader } from 'three/examples/jsm/loaders/EXRLoader.js';
import { HDRLoader } from 'three/examples/jsm/loaders/HDRLoader.js';
import type { Picture } from '../scene_file';
import { mostPixels, mostTexels } from './limits';
import { suffixOf } from './model_files';
import type { OpenedFile } from './opening_api';

interface Table { width: number; height: number; data: ArrayLike<number>; format?: number }

/** Width and height as the header states them, before a loader makes room for them. */
function statedSize(file: OpenedFile): [number, number] | null {
  const head = new Uint8Array(file.bytes, 0, Math.min(65536, file.bytes.byteLength)), text = Array.from(head, (c) => String.fromCharCode(c)).join('');
  if (suffixOf(file.name) !== 'exr') {
    const size = /[-+]Y (\d+) [-+]X (\d+)/.exec(text);
    return size ? [Number(size[2]), Number(size[1])] : null;
  }
  const at = text.indexOf('dataWindow\0box2i\0');
  if (at < 0 || at + 37 > head.length) return null;
  const box = new DataView(file.bytes, at + 21, 16), [left = 0, top = 0, right = 0, bottom = 0] = [0, 4, 8, 12].map((k) => box.getInt32(k, true));
  return [right - left + 1, bottom - top + 1];
}

/** Means of 2 × 2 pixels. */
function halved({ width, height, values }: Picture): Picture {
  const w = Math.floor(width / 2), h = Math.floor(height / 2), half = new Float32Array(3 * w * h);
  for (let y = 0; y < h; ++y)
    for (let x = 0; x < w; ++x)
      for (let c = 0; c < 3; ++c) {
        const at = (i: number, j: number) => values[3 * ((2 * y + j) * width + 2 * x + i) + c] ?? 0;
        half[3 * (y * w + x) + c] = 0.25 * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1));
      }
  return { width: w, height: h, channels: 3, values: half };
}

/** Of the loader's numbers, which take 255 mantissa steps for 1 where Radiance's own programs take 256. */
const hdrScale = 255 / 256;

function pictureOf({ width, height, data }: Table, fromBelow: boolean, scale: number): Picture {
  const values = new Float32Array(3 * width * height), channels = data.length / (width * height);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x)
      for (let c = 0; c < 3; ++c) {
        const value = scale * (data[channels * ((fromBelow ? height - 1 - y : y) * width + x) + Math.min(c, channels >= 3 ? 2 : 0)] ?? NaN);
        if (!Number.isFinite(value) || value < 0) throw new Error(`its pixel (${x}, ${y}) is ${value}, expected a number from 0`);
        values[3 * (y * width + x) + c] = value;
      }
  return { width, height, channels: 3, values };
}

export function openEnvironment(file: OpenedFile): Picture {
  try {
    const isExr = suffixOf(file.name) === 'exr', size = statedSize(file);
    if (!size) throw new Error('its header states no size');
    if (!(size[0] > 0 && size[1] > 0 && size[0] * size[1] <= mostPixels)) throw new Error(`its header states ${size[0]} × ${size[1]} pixels; this page takes up to ${mostPixels}`);
    const table = (isExr ? new EXRLoader().setDataType(FloatType).parse(file.bytes) : new HDRLoader().setDataType(FloatType).parse(file.bytes)) as unknown as Table;
    let picture = pictureOf(table, isExr, isExr ? 1 : hdrScale);
    while (picture.width * picture.height > mostTexels) picture = halved(picture);
    return picture;
  } catch (problem) {
    throw new Error(`${file.name} cannot be opened: ${(problem as Error).message ?? String(problem)}.`);
  }
}
