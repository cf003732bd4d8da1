/** Pictures in the making: each mode adds passes to a sum until it has enough. */
import type { Core } from './core_module';
import type { Pose } from './camera';
import type { FocusTable, Sights } from './eye_optics';
import type { Gpu, Target, Uniform } from './gpu';
import type { GpuScene } from './gpu_scene';
import { NoiseFilter } from './noise_filter';
import { Programs } from './programs';
import { isTraced, type Mode } from './state';
import { viewVolume } from './view_volume';

export interface Panel {
  mode: Mode;
  /** Of its random numbers. */
  seed: number;
  sum: Target;
  /** Complete ones, and rows of the next. */
  passes: number;
  rows: number;
}

/** Passes of a sharp picture: places within the pixel. */
const sharpPasses = 16;
const manyPaths = 4096;
/** Of points of the pupil, one for each pixel of a square of 4 × 4. */
export const sets = 16;

/** Steps through 0 … count − 1 so that the first few are spread over all. */
export function spreadOrder(count: number): number[] {
  let step = Math.max(1, Math.round(0.618034 * count));
  const divisor = (a: number, b: number): number => (b === 0 ? a : divisor(b, a % b));
  while (divisor(step, count) !== 1) ++step;
  return Array.from({ length: count }, (_, k) => (k * step) % count);
}

export class Pictures {
  readonly programs: Programs;
  private readonly filter: NoiseFilter;
  private eye: Record<string, Uniform> = {};
  private pose: Pose | null = null;
  private sights: WebGLTexture;
  private focus: WebGLTexture;
  private pass: Target | null = null;
  private passTable: WebGLTexture;
  private passPoints: Float32Array = new Float32Array(4);
  private order: number[] = [0];
  private rays: Sights | null = null;
  /** Whether the scene's vertices are where this eye, so placed, sees them. */
  private isPlaced = false;

  constructor(readonly gpu: Gpu, private readonly core: Core, private scene: GpuScene, private maxBounces: number) {
    this.programs = new Programs(gpu);
    this.filter = new NoiseFilter(gpu, this.programs);
    this.sights = gpu.floats(new Float32Array(4), 1, 1);
    this.focus = gpu.floats(new Float32Array(4), 1, 1);
    this.passTable = gpu.floats(new Float32Array(4), 1, 1);
  }

  showScene(scene: GpuScene, maxBounces: number): void {
    [this.scene, this.maxBounces, this.isPlaced] = [scene, maxBounces, false];
  }

  setPasses(count: number): void {
    if (this.order.length === count && this.passPoints.length === 64 * count) return;
    this.passPoints = this.core.interleavedPasses(count);
    this.gpu.gl.deleteTexture(this.passTable);
    this.passTable = this.gpu.floats(this.passPoints, count, 16);
    this.order = spreadOrder(count);
  }

  setEye(uniforms: Record<string, Uniform>, rays: Sights, focus: FocusTable | null): void {
    const { gl } = this.gpu, { grid } = rays;
    [this.eye, this.rays, this.isPlaced] = [uniforms, rays, false];
    gl.deleteTexture(this.sights);
    this.sights = this.gpu.floats(rays.data, 10 * grid.columns, grid.rows);
    Object.assign(this.eye, {
      u_sight_nodes: [grid.columns, grid.rows], u_sight_first: [grid.first_x, grid.first_y], u_sight_step: [grid.step_x, grid.step_y], u_rim_shows: rays.meetRim,
    });
    if (focus) {
      gl.deleteTexture(this.focus);
      this.focus = this.gpu.floats(focus.data, focus.width, focus.height);
    }
  }

  setPose(pose: Pose): void {
    [this.pose, this.isPlaced] = [pose, false];
    if (this.pass && (this.pass.width !== pose.width || this.pass.height !== pose.height)) {
      this.gpu.release(this.pass);
      this.pass = null;
    }
    this.pass ??= this.gpu.target(pose.width, pose.height, true);
  }

  panel(mode: Mode, width: number, height: number, seed = 1): Panel {
    return { mode, seed, sum: this.gpu.target(width, height, false, isTraced(mode) ? 2 : 0), passes: 0, rows: 0 };
  }

  restart(panel: Panel): void {
    this.gpu.clear(panel.sum);
    panel.passes = 0;
    panel.rows = 0;
  }

  /** How many passes make the picture. */
  round(mode: Mode): number {
    return mode === 'sharp' ? sharpPasses : mode === 'raster' || mode === 'gather' ? this.order.length : manyPaths;
  }

  /** How many are made while nothing moves: every pixel gets the points of all 16 sets. */
  goal(mode: Mode): number {
    return mode === 'raster' || mode === 'gather' ? sets * this.round(mode) : this.round(mode);
  }

  private seeing(): Record<string, Uniform> {
    const pose = this.pose as Pose;
    return { ...this.eye, u_head: pose.head, u_position: pose.position, u_size: [pose.width, pose.height], u_pixel_slope: pose.pixelSlope, u_center: pose.center };
  }

  /** Adds the next pass, or so many rows of it where each pixel is a ray. */
  step(panel: Panel, rows: number): void {
    if (isTraced(panel.mode)) {
      const end = Math.min(panel.sum.height, panel.rows + rows);
      this.traced(panel, panel.rows, end);
      panel.rows = end;
      if (end < panel.sum.height) return;
      panel.rows = 0;
    } else {
      const round = Math.floor(panel.passes / this.order.length);
      this.drawn(panel, this.order[panel.passes % this.order.length] ?? 0, round % sets, false);
    }
    ++panel.passes;
  }

  private traced(panel: Panel, first: number, end: number): void {
    const { gl } = this.gpu, gathers = panel.mode === 'gather';
    const program = this.scene.bind(this.programs.use('eye').set(this.seeing())).texture('u_sights', this.sights).texture('u_focus', this.focus).texture('u_passes', this.passTable);
    program.set({
      u_gathers: gathers, u_sphere: panel.mode === 'sphere', u_pass: this.order[panel.passes % this.order.length] ?? 0, u_round: Math.floor(panel.passes / this.order.length), u_sample: panel.passes, u_seed: panel.seed, u_max_bounces: this.maxBounces,
      ...(gathers ? { u_ray_model: 4 } : {}),
    });
    this.gpu.into(panel.sum);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(0, panel.sum.height - end, panel.sum.width, end - first);
    this.gpu.fill(true);
    gl.disable(gl.SCISSOR_TEST);
  }

  /** Vertices for this eye: those that it can see, and where it sees them. */
  private place(): void {
    if (this.isPlaced) return;
    this.isPlaced = true;
    const pose = this.pose as Pose, rays = this.rays as Sights;
    this.scene.showWithin(viewVolume(rays.data, pose, rays.limits));
    if (this.displaces) this.scene.displace(this.programs.use('displace').set(this.seeing()).texture('u_sights', this.sights).texture('u_focus', this.focus));
  }

  /** Else places are linear in space, and found for each pass. */
  private get displaces(): boolean {
    return this.eye.u_lens === true || this.eye.u_foveal === true || this.eye.u_seeks_focus === true;
  }

  /** One rasterised pass: a point of the pupil from one of the 16 sets, added to all pixels or to those of the set. */
  drawn(panel: Panel, pass: number, set: number, onlyItsPixels: boolean): void {
    const target = this.pass as Target, at = 4 * (set * this.order.length + pass);
    const sharp = panel.mode === 'sharp', [px, py, fx, fy] = this.passPoints.subarray(at, at + 4) as unknown as [number, number, number, number];
    const places: Record<string, Uniform> = {
      ...this.seeing(), u_pupil_point: sharp ? [0, 0] : [px, py], u_shift: [0.5 - fx, 0.5 - fy], u_nearest: this.scene.nearest, u_farthest: this.scene.farthest, u_is_displaced: this.displaces,
    };
    this.place();
    this.gpu.clear(target);
    if (this.scene.hasSurroundings) {
      this.scene.bind(this.programs.use('surroundings').set(places)).texture('u_sights', this.sights).texture('u_focus', this.focus);
      this.gpu.fill(false);
    }
    this.gpu.into(target);
    this.scene.draw(this.scene.bind(this.programs.use('mesh').set(places)));
    this.programs.use('add').set(places).texture('u_picture', target.texture).texture('u_sights', this.sights).set({ u_set: onlyItsPixels ? set : -1 });
    this.gpu.into(panel.sum);
    this.gpu.fill(true);
  }

  /** Panels beside each other on the canvas. */
  show(panels: Panel[], canvas: { width: number; height: number }, exposure: number, filter = false): void {
    const width = Math.floor(canvas.width / panels.length);
    panels.forEach((panel, k) => this.showIn(null, filter && isTraced(panel.mode) && panel.passes > 0 ? this.filtered(panel) : panel.sum, { x: k * width, y: 0, width, height: canvas.height }, exposure));
  }

  filtered(panel: Panel): Target {
    return this.filter.filtered(panel.sum);
  }

  /** A sum in a part of a framebuffer; null: the canvas. */
  showIn(framebuffer: WebGLFramebuffer | null, sum: Target, port: { x: number; y: number; width: number; height: number }, exposure: number): void {
    const { gl } = this.gpu;
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.viewport(port.x, port.y, port.width, port.height);
    this.programs.use('show').texture('u_sum', sum.texture)
      .set({ u_corner: [port.x, port.y], u_scale: [sum.width / port.width, sum.height / port.height], u_exposure: exposure });
    this.gpu.fill(false);
  }
}
