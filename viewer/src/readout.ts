/** Numbers at the pointer, in words and as a table; all from the core, as `sturm ellipse` has them. */
import type { EllipseNumbers, Optics } from './core_module';
import { signed } from './controls';
import { byId, element } from './elements';
import type { State } from './state';

/** What counts as clear: a larger vergence error of at most this. */
const clearDioptres = 0.125;

const statusWords: Record<string, string> = {
  missed_lens: 'This line of sight passes beside the lens.', total_internal_reflection: 'The lens reflects this line of sight back inside.',
  no_convergence: 'The ray through the lens could not be found.',
};

const fixed = (x: number, digits: number) => signed(x, digits, false);

export function distanceWords(distance_m: number): string {
  return Number.isFinite(distance_m) ? `${fixed(distance_m, distance_m < 10 ? 2 : 1)} m (${fixed(1 / distance_m, 2)} D)` : 'infinity (0 D)';
}

function ellipseWords(e: EllipseNumbers): string {
  const [major, minor] = e.semi_axes_arcmin ?? [0, 0];
  if (major < 0.05) return 'is sharp: the blur is below 0.1′';
  const size = `${fixed(2 * major, 1)}′ long and ${fixed(2 * minor, 1)}′ wide`;
  if (e.orientation_deg === null || minor > 0.98 * major) return `is spread over a disc of ${fixed(2 * major, 1)}′ diameter`;
  if (minor < 0.02 * major) return `is spread over a line of ${fixed(2 * major, 1)}′, at ${fixed(e.orientation_deg, 0)}° from the horizontal`;
  return `is spread over an ellipse ${size}, its long axis at ${fixed(e.orientation_deg, 0)}° from the horizontal`;
}

function clearWords(optics: Optics, state: State, azimuth: number, elevation: number): string {
  const pupil_m = state.eyes[state.side].pupil_mm / 1e3;
  if (pupil_m === 0) return 'Through a pinhole all distances are clear.';
  const clear = optics.clearVision(azimuth, elevation, (clearDioptres * pupil_m) / 2);
  if (clear.status !== 'ok' || clear.near_vergence_D === null || clear.far_vergence_D === null) return clear.status === 'never_clear' ? 'No distance is clear to ⅛\u00a0D.' : '';
  const metres = (v: number) => (v > 0.001 ? `${fixed(1 / v, 2)} m` : 'infinity');
  return `Clear to ⅛\u00a0D from ${metres(clear.near_vergence_D)} to ${metres(clear.far_vergence_D)}.`;
}

export class Readout {
  private readonly said = byId('said');
  private readonly rows = byId('numbers').querySelector('tbody') as HTMLElement;

  show(optics: Optics, state: State, gaze: { azimuth_rad: number; elevation_rad: number }, distance_m: number): EllipseNumbers {
    const e = optics.ellipse(gaze.azimuth_rad, gaze.elevation_rad, distance_m);
    if (e.status !== 'ok' || !e.semi_axes_rad) {
      this.said.textContent = statusWords[e.status] ?? e.status;
      this.rows.replaceChildren();
      return e;
    }
    this.said.textContent = `A point at ${distanceWords(distance_m)} ${ellipseWords(e)}. ${clearWords(optics, state, gaze.azimuth_rad, gaze.elevation_rad)}`;
    const row = (name: string, pair: [number, number] | null, digits: number, unit: string, scale = 1) =>
      element('tr', {}, element('th', { scope: 'row', textContent: name }), ...(pair ?? []).map((x) => element('td', { textContent: `${fixed(scale * x, digits)}${unit}` })));
    this.rows.replaceChildren(
      row('Semi-axes, angle', e.semi_axes_arcmin, 2, '′'), row('Semi-axes there', e.semi_axes_m, 3, ' mm', 1e3), row('Vergence errors', e.semi_axes_D, 3, ' D'),
      ...(e.accommodation_D === null ? [] : [element('tr', {}, element('th', { scope: 'row', textContent: 'Accommodation' }), element('td', { textContent: `${fixed(e.accommodation_D, 2)} D` }))]),
    );
    return e;
  }
}
