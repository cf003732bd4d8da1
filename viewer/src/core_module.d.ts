/**
 * The optics core as WebAssembly: what viewer/core/ binds of the C++ libraries. Lengths are in metres, angles in radians
 * unless a name says otherwise, powers in dioptres. Frames: docs/theory.md#1-frames-signs-units (wearer frame: x to the
 * wearer's right, y up, z back; AXIS and bases in the examiner's frame). A 2×2 matrix is four numbers, row by row.
 * Every returned array is a copy that belongs to the caller. Bad input throws an Error whose message says what is wrong.
 */

export interface PrescriptionNumbers {
  sphere_D: number;
  cylinder_D: number;
  axis_deg: number;
  /** Of the plane it is written for; 0 = at the cornea. Lenses ignore it: their own vertex distance counts. */
  vertex_distance_m: number;
  prism_cm_per_m: number;
  prism_base_deg: number;
}

export type AccommodationNumbers =
  | { mode: 'relaxed' }
  | { mode: 'fixed'; power_D: number }
  | { mode: 'fixed'; focus_distance_m: number | 'inf' }
  | { mode: 'best'; amplitude_D: number };

export interface WavefrontNumbers {
  /** OSA/ANSI, from j = 0 on, normalised, examiner's frame. */
  coefficients_m: ArrayLike<number>;
  radius_m: number;
  second_order: 'least_squares' | 'paraxial';
}

export interface EyeNumbers {
  /** Null only beside a wavefront; with one it adds to the wavefront. */
  prescription: PrescriptionNumbers | null;
  wavefront: WavefrontNumbers | null;
  pupil_diameter_m: number;
  rotation_center_m: number;
  accommodation: AccommodationNumbers;
}

export interface MountingNumbers {
  decentration_m: [number, number];
  pantoscopic_tilt_rad: number;
  wrap_rad: number;
}

interface LensPlace {
  center_thickness_m: number;
  refractive_index: number;
  vertex_distance_m: number;
  diameter_m: number;
  mounting: MountingNumbers;
}

export interface SingleVisionNumbers extends LensPlace {
  kind: 'single_vision';
  /** Back vertex power; null = what the eye needs at this vertex distance. */
  prescription: PrescriptionNumbers | null;
  /** Null = the usual one. */
  base_curve_D: number | null;
}

export interface ProgressiveNumbers extends Omit<SingleVisionNumbers, 'kind'> {
  kind: 'progressive';
  addition_D: number;
  corridor_start_m: number;
  corridor_length_m: number;
  near_shift_m: number;
  /** Null = circular sections. */
  zone_width_m: number | null;
  knot_spacing_m: number;
  /** What `frontSpline` said of the same lens: the same one again, without the time that it takes. */
  front?: SplineNumbers;
}

export interface SplineNumbers {
  type: 'spline';
  first_m: [number, number];
  spacing_m: [number, number];
  cells: [number, number];
  coefficients_m: ArrayLike<number>;
}

export type SurfaceNumbers =
  | { type: 'sphere'; curvature_per_m: number }
  | { type: 'conic'; curvature_per_m: number; conic_constant: number }
  | { type: 'torus'; sweep_curvature_per_m: number; generator_curvature_per_m: number; sweep_meridian_deg: number }
  | SplineNumbers;

export interface TwoSurfacesNumbers extends LensPlace {
  kind: 'surfaces';
  front: SurfaceNumbers;
  back: SurfaceNumbers;
  /** Slopes of the back surface against the lens's axis: a prism. */
  wedge: [number, number];
}

export type LensNumbers = SingleVisionNumbers | ProgressiveNumbers | TwoSurfacesNumbers;

/** Grid of a blur field: directions over a perspective field of view, (0, 0) upper left; distances uniform in dioptres, nearest first. */
export interface GridNumbers {
  nx: number;
  ny: number;
  nz: number;
  tan_half_width: number;
  tan_half_height: number;
  near_vergence_D: number;
  far_vergence_D: number;
}

/** Perspective pictures only. The pupil's centre in primary gaze is at `position_m`. */
export interface CameraNumbers {
  position_m: [number, number, number];
  look_at_m: [number, number, number];
  up: [number, number, number];
  vfov_rad: number;
  width: number;
  height: number;
  gaze: 'camera' | 'foveal';
}

export interface AnalyticField {
  /** 16 floats a direction (index j·nx + i): A, B, Q0, Q1 as rows xx xy yx yy. X/d = V·A + B − a·(V·Q0 + Q1) [rad/m], V = 1/d, a = accommodation [D]. */
  nodes: Float32Array;
  /** 1 where the direction has a conoid. */
  usable: Uint8Array;
  counters: { traced: number; mirrored: number; beyond_rim: number; usable: number; missed_lens: number; total_internal_reflection: number; no_convergence: number };
}

export interface VoxelFieldNumbers {
  /** 4 floats a voxel, xx xy yx yy of X/d [rad/m]; direction-major, depth fastest: a 3-D texture of width nz, height nx, depth ny. */
  voxels: Float32Array;
  /** 1 where the voxel has a footprint. */
  defined: Uint8Array;
}

export type LensStatus = 'ok' | 'missed_lens' | 'total_internal_reflection' | 'no_convergence';

/** What `sturm ellipse` answers for the method "conoid". Null = undefined (status), and metres at infinity. */
export interface EllipseNumbers {
  status: LensStatus;
  accommodation_D: number | null;
  /** [major, minor]. */
  semi_axes_m: [number, number] | null;
  semi_axes_rad: [number, number] | null;
  semi_axes_arcmin: [number, number] | null;
  /** Angular semi-axes over the pupil's radius: |X/d| in dioptres. */
  semi_axes_D: [number, number] | null;
  /** Of the major axis, wearer frame, (−90, 90]; null for a circle. */
  orientation_deg: number | null;
  /** The same line as an examiner writes it (TABO), (0, 180]. */
  orientation_tabo_deg: number | null;
  /** X/d [rad/m] on (e1, e2) across the outgoing chief ray. */
  angular_footprint: [number, number, number, number] | null;
  /** X [m/m]; null at infinity. */
  footprint: [number, number, number, number] | null;
  /** xx, xy, yy of the wave that leaves towards the scene [D]; null at a focal line. */
  wavefront_curvature_D: [number, number, number] | null;
  chief_ray: { origin_m: [number, number, number]; direction: [number, number, number] } | null;
}

/** Distances along one line of sight at which the larger semi-axis stays within a limit, with the accommodation that the eye has. */
export interface ClearVision {
  status: LensStatus | 'never_clear';
  /** 1/d [D]; far ≥ 0, 0 = infinity. */
  near_vergence_D: number | null;
  far_vergence_D: number | null;
  /** Where the larger semi-axis is least. */
  best_vergence_D: number | null;
  best_semi_major_rad: number | null;
}

/**
 * First-order rays of places whose chief slopes are (first_x + i·step_x, first_y + j·step_y), x right, y up. Head frame: pupil in primary
 * gaze at the origin, x right, y up, z back; a camera turns and moves what comes out. 40 floats a node (index j·columns + i), ten
 * texels RGBA: origin and how far within the rim the chief ray leaves the lens (1 at its axis and for a naked eye, 0 on the rim, less than 0
 * where spectacles stop it) | direction, 0 | then column 0 and column 1 of offset_p, offset_s, slope_p, slope_s, each followed by a 0.
 * Beyond the rim these numbers go on from within; where no node is within, they are 0, and −1 for the rim. A ray through the pupil point p [m] with the slope s = S p, S = F − A, is
 * origin + offset_p p + offset_s s, direction + slope_p p + slope_s s.
 */
export interface SlopeGrid {
  gaze: 'camera' | 'foveal';
  first_x: number;
  first_y: number;
  step_x: number;
  step_y: number;
  columns: number;
  rows: number;
}

/** The blur of a point as seen on the picture, about its chief place. */
export interface PictureEllipse {
  semi_axes_px: [number, number];
  /** Counter-clockwise from the picture's right, y up, (−90, 90]; null for a circle. */
  orientation_deg: number | null;
  /** Places [px, y down] that pupil points map to: place = M p + chief place. */
  map_px_per_m: [number, number, number, number];
  accommodation_D: number;
}

export type RayModelName = 'pinhole' | 'thin_lens' | 'metalstigmatism' | 'sin2_radial' | 'power_matrix' | 'zernike';

/** One eye and what it wears. Call `delete()` when it is done with. */
export interface Optics {
  setEye(eye: EyeNumbers): void;
  /** Null = naked. Made for the eye that was set. A progressive lens takes about 60 ms; all others far less than 1 ms. */
  setLens(lens: LensNumbers | null): void;
  /** F = correction at the cornea [D]: xx, xy, yy. */
  correction(): [number, number, number];
  /** The front of the lens where it is a spline, as progressive ones are; else null. */
  frontSpline(): SplineNumbers | null;
  /** The accommodation [D] for what a line of sight meets at 1/`vergence_D`; null where spectacles stop it. Relaxed and fixed eyes have one for all. */
  accommodation(azimuth_rad: number, elevation_rad: number, vergence_D: number): number | null;
  /** −∇W as polynomials in p/radius_m for the zernike ray model: coefficient [i][j] of x^i y^j at i·(degree + 1) + j. */
  wavefrontSlopes(): { radius_m: number; degree: number; x: Float32Array; y: Float32Array };

  fieldAnalytic(grid: GridNumbers): AnalyticField;
  fieldVoxels(grid: GridNumbers): VoxelFieldNumbers;

  /** Azimuth to the wearer's right, elevation up; distance from the pupil, or from the lens's exit point; may be Infinity. */
  ellipse(azimuth_rad: number, elevation_rad: number, distance_m: number): EllipseNumbers;
  /**
   * The larger error of an eye that turns to each line of sight (azimuth, elevation, azimuth, …) at one distance: 4 floats each, x, y where the
   * chief ray leaves the lens (without one: the pupil) [m, wearer frame], the larger of `semi_axes_D`, and 1; four zeros where spectacles stop it.
   */
  errors(gazes_rad: ArrayLike<number>, distance_m: number): Float32Array;
  /** Limit: the larger angular semi-axis that still counts as clear [rad]. */
  clearVision(azimuth_rad: number, elevation_rad: number, limit_rad: number): ClearVision;
  /** Azimuth and elevation of the line of sight to a place of the picture. */
  gazeAt(camera: CameraNumbers, x_px: number, y_px: number): { azimuth_rad: number; elevation_rad: number };
  /** Null where spectacles stop the chief ray. `vergence_D` = 1/distance along the chief ray. */
  pictureEllipse(camera: CameraNumbers, x_px: number, y_px: number, vergence_D: number): PictureEllipse | null;

  sights(grid: SlopeGrid): Float32Array;
  /**
   * The rays of `sturm render`'s multipass for the pixels of a rectangle, 32 floats each: origin 3, direction 3,
   * origin_by_place 6, direction_by_place 6 [per px], origin_by_pupil 6, direction_by_pupil 6 [per unit disc] (3×2, row by row), then 1 where the
   * chief ray comes through, then 0. Row by row from the top. `vergences_D`: one a pixel, along its chief ray.
   */
  pixelRays(camera: CameraNumbers, x: number, y: number, width: number, height: number, vergences_D: Float32Array): Float32Array;

  /** Slopes (x, y) in single precision that rays leave the pupil points (x, y) [m] with; status 0 ok, 1 negative focus, 2 dropped. */
  rayModel(model: RayModelName, accommodation_D: number, focus_distance_m: number, points_m: Float32Array): { slopes: Float32Array; status: Uint8Array };
}

export interface NotedPrescription {
  eye: 'right' | 'left' | null;
  /** Its `vertex_distance_m` is that of the text, else 0.012. */
  prescription: PrescriptionNumbers;
  vertex_distance_m: number | null;
  addition_D: number | null;
}

export interface Core {
  readonly Optics: new () => Optics & { delete(): void };
  /** 4 floats a pass: point of the unit disc (x, y), place in the pixel (x, y) in [0, 1)². */
  pupilPasses(count: number, turn: number): Float32Array;
  /** 16 sets of `count` passes; pixel (x, y), y down, takes set (y mod 4)·4 + x mod 4. */
  interleavedPasses(count: number): Float32Array;
  /** Optical notation as `--rx` reads it, e.g. "-2.00 -1.50 x 30"; throws its message. One element, or one for each eye that is named. */
  readNotation(text: string): NotedPrescription[];
  /** Mean amplitude of accommodation at an age [D]. */
  amplitudeAtAge(age_years: number): number;
}

/** A document of Sturm as the command line reads it; `document` has every default spelt out. */
export type ReadDocument =
  | { format: 'eye'; document: Record<string, unknown>; eye: EyeNumbers }
  | { format: 'spectacles'; document: Record<string, unknown>; lens: LensNumbers }
  | { format: 'render'; document: Record<string, unknown>; view: { camera: CameraNumbers; right: WornNumbers; left: WornNumbers | null; ray_model: string | null } };

/** What the second, larger module adds: the command line's own readers, with its messages. It has all of `Core` too. */
export interface CoreWithReaders extends Core {
  /** sturm.eye/1, sturm.spectacles/1 or sturm.render/1 without files of its own but the scene, which is not read. `name` is what messages call the text, `wearer` who wears spectacles. */
  readDocument(json: string, name: string, wearer: EyeNumbers): ReadDocument;
}

export interface WornNumbers {
  eye: EyeNumbers;
  lens: LensNumbers | null;
}

/** Global functions of the two scripts, `SturmCore` and `SturmReaders`. */
export type CoreFactory<C extends Core = Core> = (options?: { wasmBinary?: Uint8Array }) => Promise<C>;
