/** Whole pictures on request, for scripts that compare them with the program's. */
import type { App } from './app';
import type { Target } from './gpu';
import { sets } from './pictures';
import { viewDocument } from './save';
import type { Mode, Side } from './state';

function base64(values: Float32Array): string {
  const bytes = new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
  let text = '';
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  return btoa(text);
}

/** RGB as 32-bit floats in base64, the upper row first: mean over what was added to each pixel. */
function pixelsOf(app: App, sum: Target): string {
  const { width, height } = sum, sums = app.gpu.read(sum), result = new Float32Array(3 * width * height);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const from = 4 * ((height - 1 - y) * width + x), weight = sums[from + 3] ?? 0;
      for (let c = 0; c < 3; ++c) result[3 * (y * width + x) + c] = weight > 0 ? (sums[from + c] ?? 0) / weight : NaN;
    }
  return base64(result);
}

interface Size { width: number; height: number }

export class Measured {
  constructor(private readonly app: App) {}

  /** Holds the page; light at vertices is settled first where a mode needs it. Throws what the page says against the state. */
  private ready(): void {
    const { app } = this;
    app.held = true;
    if (!app.prepare(true)) throw new Error(document.getElementById('message')?.textContent ?? '');
  }

  /** `samples` passes (0: the first round, as the program makes them), on request filtered. */
  picture(mode: Mode, samples: number, filter = false, seed = 1): string {
    this.ready();
    return this.grown(mode, this.app, samples, filter, seed);
  }

  /** The rasteriser with every pixel's own set of passes, as `sturm render` takes them. */
  interleaved(): string {
    this.ready();
    return this.woven(this.app);
  }

  /** What an eye in the headset sees, in its own size: traced passes, or as `interleaved`. */
  inHeadset(side: Side, mode: 'gather' | 'raster'): string {
    const { headset, pictures, state } = this.app;
    pictures.setPasses(state.passes);
    const pose = headset?.lookThrough(side);
    if (!pose) throw new Error('expected an eye in a headset');
    return mode === 'gather' ? this.grown(mode, pose, 0) : this.woven(pose);
  }

  private grown(mode: Mode, { width, height }: Size, samples: number, filter = false, seed = 1): string {
    const { pictures, gpu } = this.app, panel = pictures.panel(mode, width, height, seed), end = samples || pictures.round(mode);
    while (panel.passes < end) pictures.step(panel, 64);
    const pixels = pixelsOf(this.app, filter ? pictures.filtered(panel) : panel.sum);
    gpu.release(panel.sum);
    return pixels;
  }

  private woven({ width, height }: Size): string {
    const { pictures, gpu, state } = this.app, panel = pictures.panel('raster', width, height);
    for (let set = 0; set < sets; ++set) for (let pass = 0; pass < state.passes; ++pass) pictures.drawn(panel, pass, set, true);
    const pixels = pixelsOf(this.app, panel.sum);
    gpu.release(panel.sum);
    return pixels;
  }

  /** What "save view.json" saves. */
  document(): string {
    const { state, view, width, height } = this.app;
    return JSON.stringify(viewDocument(state, view, width, height));
  }

  /** Slopes of the ray model in use at `count` points along a spiral over the pupil: x, y [m], slopes of the shader, slopes of the core. */
  slopes(count: number): string {
    this.ready();
    const { gpu, pictures, eye, state, view } = this.app, radius = state.eyes[state.side].pupil_mm / 2e3, uniforms = eye.uniforms(state, view);
    const points = Float32Array.from({ length: 2 * count }, (_, k) => {
      const i = k >> 1, r = radius * Math.sqrt((i + 0.5) / count), angle = 2.4 * i;
      return r * (k % 2 === 0 ? Math.cos(angle) : Math.sin(angle));
    });
    const texels = new Float32Array(4 * count);
    for (let i = 0; i < count; ++i) texels.set(points.subarray(2 * i, 2 * i + 2), 4 * i);
    const table = gpu.floats(texels, count, 1), target = gpu.target(count, 1);
    pictures.programs.use('slopes').set(uniforms).texture('u_points', table);
    gpu.into(target);
    gpu.fill(false);
    const drawn = gpu.read(target), focus = uniforms.u_focus_distance as number;
    const core = eye.optics.rayModel(state.rayModel, uniforms.u_accommodation as number, focus > 0 ? focus : Infinity, points);
    gpu.gl.deleteTexture(table);
    gpu.release(target);
    const rows = new Float32Array(6 * count);
    for (let i = 0; i < count; ++i)
      rows.set([...points.subarray(2 * i, 2 * i + 2), drawn[4 * i] ?? NaN, drawn[4 * i + 1] ?? NaN, ...core.slopes.subarray(2 * i, 2 * i + 2)], 6 * i);
    return base64(rows);
  }
}
