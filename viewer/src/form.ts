/** Which controls there are. */
import { FormPart, type Bound, type Change } from './controls';
import type { Core } from './core_module';
import { element } from './elements';
import { lessons } from './lessons';
import { prescribed } from './prescription';
import { isOf, realEyes, type RealEye } from './real_eyes';
import { isTraced, ranges, type EyeState, type GlassesState, type Mode, type RayModel, type Side, type State } from './state';
import type { ViewData } from './view_data';

export interface FormActions {
  lesson(number: number): void;
  reset(): void;
  saveView(): void;
  savePicture(): void;
  copyLink(): void;
  /** What chooses files to open. */
  files: HTMLInputElement;
  realEye(eye: RealEye): void;
  /** Gets the button that is shown where a program answers. */
  native(button: HTMLButtonElement): void;
  /** Gets the button that is shown where there is a headset. */
  headset(button: HTMLButtonElement): void;
}

export const modeNames: readonly (readonly [Mode, string])[] = [
  ['sharp', 'Sharp'], ['raster', 'Passes, rasterised'], ['gather', 'Passes, traced'], ['path', 'Path traced'], ['sphere', 'Path traced, whole sphere'],
];
const modelNames: readonly (readonly [RayModel, string])[] = [
  ['power_matrix', 'Power matrix'], ['sin2_radial', 'sin² (radial)'], ['metalstigmatism', 'Metalstigmatism'], ['thin_lens', 'Thin lens'], ['zernike', 'Zernike wavefront'], ['pinhole', 'Pinhole'],
];

const eyeOf = (s: State): EyeState => s.eyes[s.side];
const glassesOf = (s: State): GlassesState => s.glasses[s.side];

/** The age of the slider at which the core's mean amplitude is nearest. */
function ageOf(core: Core, amplitude_D: number): number {
  const [least, largest] = ranges.age_years, away = (age: number) => Math.abs(core.amplitudeAtAge(age) - amplitude_D);
  return Array.from({ length: largest - least + 1 }, (_, k) => least + k).reduce((best, age) => (away(age) < away(best) ? age : best));
}

/** An option that cannot be chosen now. */
function hideOption(select: HTMLSelectElement, value: string, hidden: boolean): void {
  const option = select.querySelector<HTMLOptionElement>(`option[value=${value}]`);
  if (option) option.hidden = option.disabled = hidden;
}

function eyePart(change: Change, core: Core, realEye: (eye: RealEye) => void): FormPart {
  const part = new FormPart('Eye', change);
  part.select<Side>('Looks', [['right', 'Right eye'], ['left', 'Left eye']], (s) => s.side, (s, side) => { s.side = side; });
  part.text('Prescription', '-2.00 -1.50 x 30', (text) => {
    change(prescribed(core, text));
  });
  const real = realEyes.map((eye) => [eye.file, eye.title] as const), known = (s: State) => realEyes.find((eye) => isOf(eye, eyeOf(s).wavefront?.coefficients_m ?? []));
  const measured = part.select<string>('Wavefront', [['none', 'None: by the prescription'], ...real, ['opened', 'That of a file']], (s) => (eyeOf(s).wavefront ? known(s)?.file ?? 'opened' : 'none'), (s, file) => {
    if (file === 'none') eyeOf(s).wavefront = null;
    const eye = realEyes.find((e) => e.file === file);
    if (eye) realEye(eye);
  });
  part.bound.push({ show: (s) => hideOption(measured, 'opened', !eyeOf(s).wavefront || known(s) !== undefined) });
  part.slider('SPH', 'sphere_D', ' D', 2, (s) => eyeOf(s).sphere_D, (s, x) => { eyeOf(s).sphere_D = x; });
  part.slider('CYL', 'cylinder_D', ' D', 2, (s) => eyeOf(s).cylinder_D, (s, x) => { eyeOf(s).cylinder_D = x; });
  part.slider('AXIS', 'axis_deg', '°', 0, (s) => eyeOf(s).axis_deg, (s, x) => { eyeOf(s).axis_deg = x; });
  part.dial((s) => eyeOf(s).axis_deg, (s, x) => { eyeOf(s).axis_deg = x; });
  part.slider('Stated at', 'vertex_mm', ' mm', 1, (s) => eyeOf(s).vertex_mm, (s, x) => { eyeOf(s).vertex_mm = x; });
  part.slider('Pupil', 'pupil_mm', ' mm', 1, (s) => eyeOf(s).pupil_mm, (s, x) => { eyeOf(s).pupil_mm = x; });
  part.select('Accommodation', [['relaxed', 'Relaxed'], ['fixed', 'Fixed'], ['best', 'Best, everywhere']], (s) => eyeOf(s).accommodation, (s, word) => { eyeOf(s).accommodation = word; });
  part.slider('Focus', 'focus_D', ' D', 2, (s) => eyeOf(s).focus_D, (s, x) => { eyeOf(s).focus_D = x; }, (s) => eyeOf(s).accommodation === 'fixed');
  const seeks = (s: State) => eyeOf(s).accommodation === 'best';
  part.slider('Amplitude', 'amplitude_D', ' D', 2, (s) => eyeOf(s).amplitude_D, (s, x) => { eyeOf(s).amplitude_D = x; }, seeks);
  part.slider('Usual at age', 'age_years', ' years', 0, (s) => ageOf(core, eyeOf(s).amplitude_D), (s, x) => { eyeOf(s).amplitude_D = core.amplitudeAtAge(x); }, seeks);
  return part;
}

function glassesPart(change: Change, view: () => ViewData): FormPart {
  const part = new FormPart('Spectacles', change), single = (s: State) => glassesOf(s).kind === 'single' || glassesOf(s).kind === 'progressive';
  const worn = part.select('Worn', [['none', 'None'], ['view', 'Those of the file'], ['single', 'Single vision'], ['progressive', 'Progressive']], (s) => glassesOf(s).kind, (s, word) => { glassesOf(s).kind = word; });
  part.bound.push({ show: (s) => hideOption(worn, 'view', view().worn[s.side].lens === null) });
  part.check('Made for this eye', (s) => glassesOf(s).fitted, (s, on) => { glassesOf(s).fitted = on; }, single);
  const own = (s: State) => single(s) && !glassesOf(s).fitted;
  part.slider('Lens SPH', 'sphere_D', ' D', 2, (s) => glassesOf(s).sphere_D, (s, x) => { glassesOf(s).sphere_D = x; }, own);
  part.slider('Lens CYL', 'cylinder_D', ' D', 2, (s) => glassesOf(s).cylinder_D, (s, x) => { glassesOf(s).cylinder_D = x; }, own);
  part.slider('Lens AXIS', 'axis_deg', '°', 0, (s) => glassesOf(s).axis_deg, (s, x) => { glassesOf(s).axis_deg = x; }, own);
  part.slider('Add', 'addition_D', ' D', 2, (s) => glassesOf(s).addition_D, (s, x) => { glassesOf(s).addition_D = x; }, (s) => glassesOf(s).kind === 'progressive');
  part.slider('Vertex dist.', 'vertex_mm', ' mm', 1, (s) => glassesOf(s).vertex_mm, (s, x) => { glassesOf(s).vertex_mm = x; }, single);
  const isWorn = (s: State) => glassesOf(s).kind !== 'none';
  part.check('Rim on the picture', (s) => s.rimOverlay, (s, on) => { s.rimOverlay = on; }, isWorn);
  part.check('Map of the lens', (s) => s.lensMap, (s, on) => { s.lensMap = on; }, isWorn);
  part.select('Gaze', [['camera', 'Eye looks ahead'], ['foveal', 'Eye turns to each point']], (s) => s.camera.gaze, (s, word) => { s.camera.gaze = word; });
  return part;
}

function picturePart(change: Change): FormPart {
  const part = new FormPart('Picture', change), paths = (s: State) => s.modes.some((m) => m === 'path' || m === 'sphere'), isFlat = (s: State) => !s.modes.includes('sphere');
  part.select('Mode', modeNames, (s) => s.modes[0], (s, mode) => { s.modes[0] = mode; });
  part.select('Beside it', [['nothing', 'Nothing'], ...modeNames], (s) => s.modes[1] ?? 'nothing', (s, mode) => { s.modes = mode === 'nothing' ? [s.modes[0]] : [s.modes[0], mode]; });
  part.select('Ray model', modelNames, (s) => s.rayModel, (s, model) => { s.rayModel = model; }, paths);
  part.select('Passes', [['16', '16'], ['64', '64'], ['256', '256']], (s) => String(s.passes), (s, n) => { s.passes = Number(n); }, (s) => s.modes.some((m) => m === 'raster' || m === 'gather'));
  part.check('Filter noise', (s) => s.filter, (s, on) => { s.filter = on; }, (s) => s.modes.some(isTraced));
  part.slider('Brightness', 'brightness_stops', ' stops', 1, (s) => Math.log2(s.exposure), (s, x) => { s.exposure = 2 ** x; });
  part.slider('Field', 'field_deg', '°', 1, (s) => s.camera.field_deg, (s, x) => { s.camera.field_deg = x; }, (s) => s.modes.some((m) => m !== 'sphere'));
  part.check('Ellipses over the field', (s) => s.fieldOverlay, (s, on) => { s.fieldOverlay = on; }, isFlat);
  return part;
}

/** Fills the form; what it returns follows the state. */
export function fillForm(form: HTMLFormElement, change: Change, core: Core, view: () => ViewData, actions: FormActions): Bound[] {
  const lessonPart = new FormPart('Lessons', change);
  lessonPart.buttons(...lessons.map((lesson, k): [string, () => void] => [lesson.title, () => actions.lesson(k)]), ['As it came', actions.reset]);
  const keep = new FormPart('Keep', change);
  keep.buttons(['Save view.json', actions.saveView], ['Save picture', actions.savePicture], ['Copy link', actions.copyLink]);
  const [native, headset] = keep.buttons(['Render this natively', () => undefined], ['Enter the headset', () => undefined]) as [HTMLButtonElement, HTMLButtonElement];
  native.hidden = headset.hidden = true;
  actions.native(native);
  actions.headset(headset);
  const open = new FormPart('Open', change);
  open.buttons(['Open files…', () => actions.files.click()]);
  open.add(element('label', { hidden: true }, 'Files to open', actions.files));
  open.add(element('p', { className: 'note', textContent: 'Or drop them here: glTF, OBJ, USD, HDR or EXR, eyes, spectacles and views of Sturm (.json), prescriptions (.txt). A model comes with all files that it names.' }));
  const parts = [eyePart(change, core, actions.realEye), glassesPart(change, view), picturePart(change), lessonPart, open, keep];
  form.append(...parts.map((part) => part.element));
  form.addEventListener('submit', (event) => event.preventDefault());
  return parts.flatMap((part) => part.bound);
}
