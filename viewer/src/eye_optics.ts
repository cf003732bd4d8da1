/** The C++ core's answers for one eye and what it wears, as the shaders take them. */
import type { Core, EyeNumbers, LensNumbers, Optics, PrescriptionNumbers, SlopeGrid } from './core_module';
import { edgesOf, type Pose } from './camera';
import type { Uniform } from './gpu';
import type { LensMaker } from './lens_maker';
import { rayModels, type EyeState, type GlassesState, type Side, type State } from './state';
import type { ViewData } from './view_data';
import type { RayLimits } from './view_volume';

const waveTerms = 66, focusVergences = 64, lastVergence_D = 10, sightStep = 0.02;

function prescriptionOf(p: { sphere_D: number; cylinder_D: number; axis_deg: number }, vertex_m: number): PrescriptionNumbers {
  return { sphere_D: p.sphere_D, cylinder_D: p.cylinder_D, axis_deg: p.axis_deg, vertex_distance_m: vertex_m, prism_cm_per_m: 0, prism_base_deg: 0 };
}

/** Beside a wavefront the prescription is what is left of it. */
export function eyeNumbers(eye: EyeState, ofView: EyeNumbers): EyeNumbers {
  const none = eye.sphere_D === 0 && eye.cylinder_D === 0 && eye.wavefront !== null;
  const focus = eye.focus_D > 0 ? ({ mode: 'fixed', focus_distance_m: 1 / eye.focus_D } as const) : ({ mode: 'fixed', power_D: 0 } as const);
  return {
    prescription: none ? null : prescriptionOf(eye, eye.vertex_mm / 1e3), wavefront: eye.wavefront, pupil_diameter_m: eye.pupil_mm / 1e3, rotation_center_m: ofView.rotation_center_m,
    accommodation: eye.accommodation === 'relaxed' ? { mode: 'relaxed' } : eye.accommodation === 'best' ? { mode: 'best', amplitude_D: eye.amplitude_D } : focus,
  };
}

export function lensNumbers(side: Side, glasses: GlassesState, eye: EyeState, ofView: LensNumbers | null): LensNumbers | null {
  if (glasses.kind === 'none') return null;
  if (glasses.kind === 'view') return ofView;
  const worn = glasses.fitted ? eye : glasses;
  const place = {
    // Plus lenses are thick in the middle, minus lenses at the rim.
    center_thickness_m: Math.max(worn.sphere_D, worn.sphere_D + worn.cylinder_D) > 0 ? 6e-3 : 2e-3,
    refractive_index: 1.6, vertex_distance_m: glasses.vertex_mm / 1e3, diameter_m: 65e-3, mounting: { decentration_m: [0, 0] as [number, number], pantoscopic_tilt_rad: 0, wrap_rad: 0 },
    prescription: glasses.fitted ? null : prescriptionOf(glasses, 0), base_curve_D: null,
  };
  if (glasses.kind === 'single') return { kind: 'single_vision', ...place };
  return {
    kind: 'progressive', ...place, addition_D: glasses.addition_D, corridor_start_m: 0, corridor_length_m: 0.018, near_shift_m: side === 'right' ? -0.0025 : 0.0025, zone_width_m: 0.01, knot_spacing_m: 0.0005,
  };
}

/** Rays over a picture. */
export interface Sights { grid: SlopeGrid; data: Float32Array; limits: RayLimits; /** Whether spectacles stop some. */ meetRim: boolean }

/** Accommodation by vergence (columns) and height in the picture (rows, upper first); RGBA. */
export interface FocusTable { data: Float32Array; width: number; height: number }

export class EyeOptics {
  readonly optics: Optics & { delete(): void };
  private eyeKey = '';
  private lensKey = '';
  lens = false;

  /** A word for the eye and the lens that are worn. */
  get worn(): string {
    return this.eyeKey + this.lensKey;
  }

  constructor(core: Core) {
    this.optics = new core.Optics();
  }

  /**
   * Throws the core's own message where eye or lens cannot be. With a `maker` it returns false while a progressive lens is being made, and what was
   * worn before stays; without one, and for the first lens, that takes its time here.
   */
  wear(state: State, view: ViewData, maker?: LensMaker): boolean {
    const { side } = state, eye = state.eyes[side];
    const eyeNow = eyeNumbers(eye, view.worn[side].eye), lensNow = lensNumbers(side, state.glasses[side], eye, view.worn[side].lens);
    const eyeKey = JSON.stringify([side, eyeNow]), lensKey = JSON.stringify([side, lensNow, lensNow && 'prescription' in lensNow && !lensNow.prescription ? [eye.sphere_D, eye.cylinder_D, eye.axis_deg, eye.vertex_mm] : null]);
    let lens = lensNow;
    if (maker && this.eyeKey !== '' && lensKey !== this.lensKey && lensNow?.kind === 'progressive') {
      const front = maker.front(lensKey, eyeNow, lensNow);
      if (!front) return false;
      lens = { ...lensNow, front };
    }
    if (eyeKey !== this.eyeKey) this.optics.setEye(eyeNow);
    if (lensKey !== this.lensKey) this.optics.setLens(lens);
    [this.eyeKey, this.lensKey, this.lens] = [eyeKey, lensKey, lens !== null];
    return true;
  }

  /** The rays of a grid over a picture, one step wider on each side; of a naked eye, whose rays the shaders know, a few. */
  sights(state: State, pose: Pose): Sights {
    const [left, right, lower, upper] = edgesOf(pose), sizes: [number, number] = [right - left, upper - lower], most = this.lens ? 48 : 4;
    // Even, as the core traces every second node and the first and the last of a line should be such.
    const cells = sizes.map((size) => 2 * Math.min(most, Math.ceil(size / (2 * sightStep)))) as [number, number];
    const step: [number, number] = [sizes[0] / cells[0], sizes[1] / cells[1]];
    const grid: SlopeGrid = { gaze: state.camera.gaze, first_x: left - step[0], first_y: lower - step[1], step_x: step[0], step_y: step[1], columns: cells[0] + 3, rows: cells[1] + 3 };
    const data = this.optics.sights(grid);
    return { grid, data, limits: this.rayLimits(state), meetRim: this.lens && data.some((x, k) => k % 40 === 3 && x <= 0) };
  }

  private rayLimits(state: State): RayLimits {
    const eye = state.eyes[state.side], pupil = eye.pupil_mm / 2e3, [xx, xy, yy] = this.optics.correction() as [number, number, number];
    return { pupil, slope: pupil * (Math.hypot(xx, xy, xy, yy) + Math.max(eye.focus_D, eye.amplitude_D)) };
  }

  /** Of an eye that seeks focus. */
  focusTable(pose: Pose): FocusTable {
    const [, , lower, upper] = edgesOf(pose), height = this.lens ? 9 : 2, data = new Float32Array(4 * focusVergences * height);
    for (let j = 0; j < height; ++j) {
      const slope = upper + ((lower - upper) * j) / (height - 1);
      for (let i = 0; i < focusVergences; ++i)
        data[4 * (j * focusVergences + i)] = this.optics.accommodation(0, Math.atan(slope), (lastVergence_D * i) / (focusVergences - 1)) ?? 0;
    }
    return { data, width: focusVergences, height };
  }

  uniforms(state: State, view: ViewData): Record<string, Uniform> {
    const eye = state.eyes[state.side], best = eye.accommodation === 'best';
    const wave = this.waveTerms(state);
    return {
      u_pupil_radius: eye.pupil_mm / 2e3, u_correction: this.optics.correction(), u_seeks_focus: best, u_focus_last_vergence: lastVergence_D,
      u_accommodation: eye.accommodation === 'fixed' ? eye.focus_D : 0, u_focus_distance: eye.accommodation === 'fixed' && eye.focus_D > 0 ? 1 / eye.focus_D : 0,
      u_ray_model: rayModels.indexOf(state.rayModel), u_lens: this.lens, u_foveal: state.camera.gaze === 'foveal', u_rotation_center: view.worn[state.side].eye.rotation_center_m, ...wave,
    };
  }

  private waveTerms(state: State): Record<string, Uniform> {
    if (state.rayModel !== 'zernike') return {};
    const wave = this.optics.wavefrontSlopes(), terms = new Float32Array(2 * waveTerms), degree = Math.min(wave.degree, 10);
    if (wave.degree > 10) throw new Error(`This wavefront has slopes of degree ${wave.degree}; the page traces up to 10.`);
    let k = 0;
    for (let n = 0; n <= degree; ++n)
      for (let j = 0; j <= n; ++j, ++k) {
        const at = (n - j) * (wave.degree + 1) + j;
        terms.set([wave.x[at] ?? 0, wave.y[at] ?? 0], 2 * k);
      }
    return { u_wave_slopes: terms, u_wave_degree: degree, u_wave_radius: wave.radius_m };
  }
}
