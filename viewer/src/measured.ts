/** Whole pictures on request, for scripts that compare them with the program's. */
import type { App } from './app';
import type { Panel } from './pictures';
import type { Mode } from './state';

function base64(values: Float32Array): string {
  const bytes = new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
  let text = '';
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  return btoa(text);
}

/** RGB as 32-bit floats in base64, the upper row first: mean over what was added to each pixel. */
function pixelsOf(app: App, panel: Panel): string {
  const { width, height } = panel.sum, sums = app.gpu.read(panel.sum), result = new Float32Array(3 * width * height);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const from = 4 * ((height - 1 - y) * width + x), weight = sums[from + 3] ?? 0;
      for (let c = 0; c < 3; ++c) result[3 * (y * width + x) + c] = weight > 0 ? (sums[from + c] ?? 0) / weight : NaN;
    }
  return base64(result);
}

export class Measured {
  constructor(private readonly app: App) {}

  /** Holds the page; light at vertices is settled first where a mode needs it. Throws what the page says against the state. */
  private ready(): void {
    const { app } = this;
    app.held = true;
    if (!app.prepare()) throw new Error(document.getElementById('message')?.textContent ?? '');
  }

  /** `samples` passes (0: all that the mode has). */
  picture(mode: Mode, samples: number): string {
    this.ready();
    const { pictures, width, height, gpu } = this.app, panel = pictures.panel(mode, width, height), end = samples || pictures.goal(mode);
    while (panel.passes < end) pictures.step(panel, 64);
    const pixels = pixelsOf(this.app, panel);
    gpu.release(panel.sum);
    return pixels;
  }

  /** The rasteriser with every pixel's own set of passes, as `sturm render` takes them. */
  interleaved(): string {
    this.ready();
    const { pictures, width, height, gpu, state } = this.app, panel = pictures.panel('raster', width, height);
    for (let set = 0; set < 16; ++set) for (let pass = 0; pass < state.passes; ++pass) pictures.drawn(panel, pass, set);
    const pixels = pixelsOf(this.app, panel);
    gpu.release(panel.sum);
    return pixels;
  }
}
