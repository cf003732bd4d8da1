/** What the page shows: one eye a side, one pair of spectacles, one camera. In the units of the controls. */

export const sides = ['right', 'left'] as const;
export type Side = (typeof sides)[number];
export const modes = ['sharp', 'raster', 'gather', 'path', 'sphere'] as const;
export type Mode = (typeof modes)[number];
/** A ray for each pixel; else triangles are drawn. */
export const isTraced = (mode: Mode): boolean => mode === 'gather' || mode === 'path' || mode === 'sphere';
export const rayModels = ['pinhole', 'thin_lens', 'metalstigmatism', 'sin2_radial', 'power_matrix', 'zernike'] as const;
export type RayModel = (typeof rayModels)[number];
export const accommodations = ['relaxed', 'fixed', 'best'] as const;
export const glassesKinds = ['none', 'view', 'single', 'progressive'] as const;
export const secondOrders = ['least_squares', 'paraxial'] as const;
export const gazes = ['camera', 'foveal'] as const;

/** As the core has it: OSA/ANSI from j = 0 on, normalised, examiner's frame. */
export interface WavefrontState {
  coefficients_m: number[];
  radius_m: number;
  second_order: (typeof secondOrders)[number];
}

export interface EyeState {
  sphere_D: number;
  cylinder_D: number;
  axis_deg: number;
  vertex_mm: number;
  pupil_mm: number;
  accommodation: (typeof accommodations)[number];
  focus_D: number;
  amplitude_D: number;
  /** Measured; the prescription adds to it. */
  wavefront: WavefrontState | null;
}

export interface GlassesState {
  kind: (typeof glassesKinds)[number];
  /** Made for this eye; else for the prescription below. */
  fitted: boolean;
  sphere_D: number;
  cylinder_D: number;
  axis_deg: number;
  addition_D: number;
  vertex_mm: number;
}

export interface CameraState {
  position_m: [number, number, number];
  /** Of the head: to the right, and up. */
  turn_deg: number;
  tilt_deg: number;
  field_deg: number;
  gaze: (typeof gazes)[number];
}

export interface State {
  side: Side;
  eyes: Record<Side, EyeState>;
  glasses: Record<Side, GlassesState>;
  camera: CameraState;
  modes: [Mode] | [Mode, Mode];
  rayModel: RayModel;
  passes: number;
  exposure: number;
  /** Traced pictures are shown without their noise. */
  filter: boolean;
  fieldOverlay: boolean;
  /** The rim of the spectacles on the picture, and a map of their errors below it. */
  rimOverlay: boolean;
  lensMap: boolean;
}

/** Least, largest and step of every number, as the controls and the link have them. */
export const ranges = {
  sphere_D: [-20, 20, 0.25], cylinder_D: [-8, 8, 0.25], axis_deg: [0, 180, 1], vertex_mm: [0, 20, 0.5], pupil_mm: [0, 9, 0.1],
  focus_D: [0, 12, 0.05], amplitude_D: [0, 16, 0.25], addition_D: [0, 4, 0.25], turn_deg: [-180, 180, 0.1], tilt_deg: [-89, 89, 0.1],
  age_years: [10, 60, 1], field_deg: [2, 120, 0.1], passes: [1, 256, 1], exposure: [0.01, 100, 0.01], brightness_stops: [-6.5, 6.5, 0.1], position_m: [-1e6, 1e6, 0.001], coefficients_m: [-1e-3, 1e-3, 1e-9], radius_m: [1e-4, 0.02, 1e-6],
} as const;

export const startEye: EyeState = { sphere_D: 0, cylinder_D: 0, axis_deg: 180, vertex_mm: 0, pupil_mm: 4, accommodation: 'relaxed', focus_D: 0, amplitude_D: 4, wavefront: null };
export const startGlasses: GlassesState = { kind: 'none', fitted: true, sphere_D: 0, cylinder_D: 0, axis_deg: 180, addition_D: 2, vertex_mm: 12 };
