/** How a lamp's choice falls on the pixels of the surroundings (viewer/shaders/environment.glsl). */
import { luminance } from './colour';
import type { Picture } from './scene_file';

export interface EnvironmentShares {
  /** Of every pixel: where its share of its row ends, 0 … 1. */
  ends: Float32Array;
  /** Four numbers a row: end of its share of the whole, its share, cosines from above of its upper and lower edge. */
  rows: Float32Array;
}

/** In proportion to luminance times solid angle; null for a black picture. */
export function environmentShares({ width, height, channels, values }: Picture): EnvironmentShares | null {
  const ends = new Float32Array(width * height), rows = new Float32Array(4 * height), sums = new Float64Array(height);
  const colour = (i: number) => [0, 1, 2].map((c) => values[channels * i + Math.min(c, channels - 1)] ?? 0);
  const cosineOf = (edge: number) => Math.cos((Math.PI * edge) / height);
  for (let y = 0; y < height; ++y) {
    let sum = 0;
    const running = Float64Array.from({ length: width }, (_, x) => (sum += luminance(colour(y * width + x))));
    ends.set(running.map((s, x) => (x + 1 === width ? 1 : s / (sum || 1))), y * width);
    sums[y] = sum * (cosineOf(y) - cosineOf(y + 1));
  }
  const whole = sums.reduce((a, b) => a + b, 0);
  if (!(whole > 0)) return null;
  let end = 0;
  sums.forEach((sum, y) => {
    end += sum / whole;
    rows.set([y + 1 === height ? 1 : end, sum / whole, cosineOf(y), cosineOf(y + 1)], 4 * y);
  });
  return { ends, rows };
}
