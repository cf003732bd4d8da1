/** What `sturm view` has put into the page (docs/formats/viewer_scene.md). */
import type { CameraNumbers, EyeNumbers, WornNumbers } from './core_module';
import { readScene, type SceneData } from './scene_file';
import { ranges, rayModels, startEye, startGlasses, type CameraState, type EyeState, type GlassesState, type RayModel, type State } from './state';

export interface ViewData {
  title: string;
  /** The render document with all defaults. */
  document: Record<string, unknown>;
  camera: CameraNumbers;
  worn: { right: WornNumbers; left: WornNumbers };
  rayModel: RayModel;
  /** Of paths, in reflections. */
  maxBounces: number;
  /** And what else reading the view and its scene brought up. */
  notDrawn: string[];
}

export function textOf(id: string): string {
  return document.getElementById(id)?.textContent?.trim() ?? '';
}

/** Null in a page without a view. */
export function viewOfPage(): ViewData | null {
  const view = JSON.parse(textOf('sturm-view') || 'null');
  if (!view) return null;
  if (view.format !== 'sturm.viewer_view/1') throw new Error(`The view of this page has the format ${String(view.format)}, expected sturm.viewer_view/1.`);
  return {
    title: view.title, document: view.view, camera: view.camera, worn: { right: view.right, left: view.left ?? view.right },
    maxBounces: view.view?.method?.max_bounces ?? 16, rayModel: rayModels.includes(view.ray_model) ? view.ray_model : 'power_matrix', notDrawn: [...view.not_drawn, ...view.notes],
  };
}

/** Bytes that were packed with gzip and written in base64. */
export async function unzipped(text: string): Promise<ArrayBuffer> {
  const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

export async function sceneOfPage(): Promise<SceneData> {
  return readScene(await unzipped(textOf('sturm-scene')));
}

const within = (name: keyof typeof ranges, value: number) => Math.min(ranges[name][1], Math.max(ranges[name][0], value));

export function eyeState(eye: EyeNumbers): EyeState {
  const rx = eye.prescription, a = eye.accommodation, wave = eye.wavefront;
  const state: EyeState = { ...startEye, pupil_mm: within('pupil_mm', 1e3 * eye.pupil_diameter_m), accommodation: a.mode, wavefront: wave && { ...wave, coefficients_m: Array.from(wave.coefficients_m) } };
  if (rx) Object.assign(state, { sphere_D: rx.sphere_D, cylinder_D: rx.cylinder_D, axis_deg: rx.axis_deg, vertex_mm: 1e3 * rx.vertex_distance_m });
  if (a.mode === 'fixed') state.focus_D = within('focus_D', 'power_D' in a ? a.power_D : a.focus_distance_m === 'inf' ? 0 : 1 / a.focus_distance_m);
  if (a.mode === 'best') state.amplitude_D = within('amplitude_D', a.amplitude_D);
  return state;
}

function glassesState(worn: WornNumbers): GlassesState {
  return { ...startGlasses, kind: worn.lens ? 'view' : 'none' };
}

export function cameraState(c: CameraNumbers): CameraState {
  const ahead = c.look_at_m.map((x, k) => x - (c.position_m[k] ?? 0)), deg = 180 / Math.PI;
  return {
    position_m: [...c.position_m], turn_deg: deg * Math.atan2(ahead[0] ?? 0, -(ahead[2] ?? -1)),
    tilt_deg: within('tilt_deg', deg * Math.atan2(ahead[1] ?? 0, Math.hypot(ahead[0] ?? 0, ahead[2] ?? 0))), field_deg: within('field_deg', deg * c.vfov_rad), gaze: c.gaze,
  };
}

/** The state that the page opens with. */
export function startState(view: ViewData): State {
  return {
    side: 'right',
    eyes: { right: eyeState(view.worn.right.eye), left: eyeState(view.worn.left.eye) },
    glasses: { right: glassesState(view.worn.right), left: glassesState(view.worn.left) },
    camera: cameraState(view.camera),
    modes: ['raster'], rayModel: view.rayModel, passes: 64, exposure: 1, filter: false, fieldOverlay: false, rimOverlay: false, lensMap: false,
  };
}
