/** What leaves the page: a document for the program, a picture, a link. */
import { numbersOf } from './camera';
import type { EyeNumbers, LensNumbers, WavefrontNumbers } from './core_module';
import { element } from './elements';
import { eyeNumbers, lensNumbers } from './eye_optics';
import type { Side, State } from './state';
import type { ViewData } from './view_data';

const mm = (m: number) => Number((1e3 * m).toPrecision(12));

function accommodationDocument(a: EyeNumbers['accommodation']): Record<string, unknown> {
  if (a.mode === 'best') return { mode: 'best', amplitude_D: a.amplitude_D };
  if (a.mode === 'relaxed') return { mode: 'relaxed' };
  return 'power_D' in a ? { mode: 'fixed', power_D: a.power_D } : { mode: 'fixed', focus_distance_m: a.focus_distance_m };
}

/** In what `given` says of it besides (its wavelength) nothing changes. */
function wavefrontDocument(wave: WavefrontNumbers, combine: boolean, given: unknown): Record<string, unknown> {
  const { wavelength_nm } = (given ?? {}) as { wavelength_nm?: number };
  return {
    ...(wavelength_nm === undefined ? {} : { wavelength_nm }), order: 'osa', coefficients_um: Array.from(wave.coefficients_m, (c) => Number((1e6 * c).toPrecision(15))), pupil_diameter_mm: mm(2 * wave.radius_m),
    second_order: wave.second_order, combine,
  };
}

/** Names of the files that a document needs beside itself. */
export function filesOf(document: unknown, key = ''): string[] {
  if (typeof document === 'string') return ['scene', 'file', 'spectacles', 'eye'].includes(key) ? [document] : [];
  if (typeof document !== 'object' || document === null) return [];
  return [...new Set(Object.entries(document).flatMap(([name, value]) => filesOf(value, Array.isArray(document) ? key : name)))];
}

function eyeDocument(state: State, view: ViewData, side: Side, given: Record<string, unknown>): Record<string, unknown> {
  const eye = eyeNumbers(state.eyes[side], view.worn[side].eye), rx = eye.prescription, { prescription: _, wavefront, ...others } = given;
  return {
    ...others,
    ...(eye.wavefront ? { wavefront: wavefrontDocument(eye.wavefront, rx !== null, wavefront) } : {}),
    ...(rx ? { prescription: { sphere_D: rx.sphere_D, cylinder_D: rx.cylinder_D, axis_deg: rx.axis_deg, vertex_distance_mm: mm(rx.vertex_distance_m) } } : {}),
    pupil_diameter_mm: mm(eye.pupil_diameter_m), accommodation: accommodationDocument(eye.accommodation),
  };
}

function lensDocument(lens: LensNumbers | null, given: unknown): unknown {
  if (!lens) return null;
  if (lens.kind === 'surfaces') return given;
  const rx = lens.prescription;
  const shared = {
    ...(rx ? { prescription: { sphere_D: rx.sphere_D, cylinder_D: rx.cylinder_D, axis_deg: rx.axis_deg } } : {}),
    center_thickness_mm: mm(lens.center_thickness_m), refractive_index: lens.refractive_index, vertex_distance_mm: mm(lens.vertex_distance_m), diameter_mm: mm(lens.diameter_m),
  };
  if (lens.kind === 'single_vision') return { single_vision: shared };
  return {
    progressive: {
      ...shared, addition_D: lens.addition_D, corridor_start_mm: mm(lens.corridor_start_m), corridor_length_mm: mm(lens.corridor_length_m), inset_mm: mm(Math.abs(lens.near_shift_m)), eye: lens.near_shift_m < 0 ? 'right' : 'left',
      zone_width_mm: lens.zone_width_m === null ? null : mm(lens.zone_width_m), knot_spacing_mm: mm(lens.knot_spacing_m),
    },
  };
}

/** A sturm.render/1 document of what is shown. */
export function viewDocument(state: State, view: ViewData, width: number, height: number): Record<string, unknown> {
  const given = view.document as Record<string, any>, camera = numbersOf(state.camera, width, height), sphere = state.modes[0] === 'sphere', traced = sphere || state.modes[0] === 'path';
  const worn = (side: Side) => {
    const of = side === 'right' ? given : { eye: given.eye, spectacles: given.spectacles, ...given.left };
    const kind = state.glasses[side].kind;
    return {
      eye: eyeDocument(state, view, side, of.eye ?? {}),
      spectacles: kind === 'view' ? of.spectacles ?? null : lensDocument(lensNumbers(side, state.glasses[side], state.eyes[side], view.worn[side].lens), of.spectacles),
    };
  };
  const { stereo: _, vfov_deg: __, ...givenCamera } = given.camera ?? {};
  const projection = sphere ? { projection: 'equirectangular', gaze: 'camera' } : { vfov_deg: state.camera.field_deg, gaze: camera.gaze };
  return {
    format: 'sturm.render/1', scene: given.scene,
    camera: { ...givenCamera, position_m: camera.position_m, look_at_m: camera.look_at_m, up: camera.up, resolution: [width, height], ...projection },
    ...worn(state.side),
    method: traced ? { type: 'path_trace', ray_model: state.rayModel, samples_per_pixel: 256, max_bounces: view.maxBounces }
      : state.modes[0] === 'sharp' ? { type: 'path_trace', ray_model: 'pinhole', samples_per_pixel: 256 } : { type: 'predict', prediction: 'multipass', passes: state.passes },
    seed: given.seed ?? 1,
  };
}

export function download(name: string, blob: Blob): void {
  const link = element('a', { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
