/** The state as the part of a link behind #. What comes in is a stranger's: every key and number is checked. */
import { accommodations, gazes, glassesKinds, modes, ranges, rayModels, secondOrders, sides, type State } from './state';

type Checker = (value: unknown, path: string) => unknown;

class LinkError extends Error {}

const number = (name: keyof typeof ranges): Checker => (value, path) => {
  const [least, largest] = ranges[name];
  if (typeof value !== 'number' || !(value >= least && value <= largest)) throw new LinkError(`${path} is ${short(value)}, expected a number from ${least} to ${largest}`);
  return value;
};
const word = (words: readonly string[]): Checker => (value, path) => {
  if (typeof value !== 'string' || !words.includes(value)) throw new LinkError(`${path} is ${short(value)}, expected one of ${words.join(', ')}`);
  return value;
};
const truth: Checker = (value, path) => {
  if (typeof value !== 'boolean') throw new LinkError(`${path} is ${short(value)}, expected true or false`);
  return value;
};
/** For what links have had only since it came. */
const otherwise = (check: Checker, value: unknown): Checker => (given, path) => (given === undefined ? value : check(given, path));
const list = (item: Checker, least: number, most: number): Checker => (value, path) => {
  if (!Array.isArray(value) || value.length < least || value.length > most) throw new LinkError(`${path} is ${short(value)}, expected a list of ${least === most ? least : `${least} to ${most}`}`);
  return value.map((v, k) => item(v, `${path}/${k}`));
};
const record = (keys: Record<string, Checker>): Checker => (value, path) => {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) throw new LinkError(`${path || 'the state'} is ${short(value)}, expected an object`);
  const given = value as Record<string, unknown>;
  for (const key of Object.keys(given)) if (!Object.hasOwn(keys, key)) throw new LinkError(`${path}/${short(key)} is not known`);
  return Object.fromEntries(Object.entries(keys).map(([key, check]) => {
    return [key, check(Object.hasOwn(given, key) ? given[key] : undefined, `${path}/${key}`)];
  }));
};

const orNull = (check: Checker): Checker => (value, path) => (value === null ? null : check(value, path));

function short(value: unknown): string {
  const text = JSON.stringify(value) ?? 'nothing';
  return text.length > 40 ? `${text.slice(0, 40)}…` : text;
}

/** 66: orders up to 10, which is what the page traces. */
const wavefront = record({ coefficients_m: list(number('coefficients_m'), 1, 66), radius_m: number('radius_m'), second_order: word(secondOrders) });
const eye = record({
  sphere_D: number('sphere_D'), cylinder_D: number('cylinder_D'), axis_deg: number('axis_deg'), vertex_mm: number('vertex_mm'), pupil_mm: number('pupil_mm'),
  accommodation: word(accommodations), focus_D: number('focus_D'), amplitude_D: number('amplitude_D'),
  wavefront: orNull(wavefront),
});
const glasses = record({
  kind: word(glassesKinds), fitted: truth, sphere_D: number('sphere_D'), cylinder_D: number('cylinder_D'), axis_deg: number('axis_deg'),
  addition_D: number('addition_D'), vertex_mm: number('vertex_mm'),
});
const state = record({
  side: word(sides), eyes: record({ right: eye, left: eye }), glasses: record({ right: glasses, left: glasses }),
  camera: record({ position_m: list(number('position_m'), 3, 3), turn_deg: number('turn_deg'), tilt_deg: number('tilt_deg'), field_deg: number('field_deg'), gaze: word(gazes) }),
  modes: list(word(modes), 1, 2), rayModel: word(rayModels), passes: number('passes'), exposure: number('exposure'), filter: truth, fieldOverlay: truth, rimOverlay: otherwise(truth, false), lensMap: otherwise(truth, false),
});

export function hashOf(shown: State): string {
  return '#' + btoa(JSON.stringify(shown)).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}

/** Null where the link has no state. Throws an Error for a state that is none. */
export function stateOfHash(hash: string): State | null {
  if (hash.length <= 1) return null;
  if (hash.length > 8000) throw new LinkError('The state in the link is too long.');
  let value: unknown;
  try {
    value = JSON.parse(atob(hash.slice(1).replace(/-/g, '+').replace(/_/g, '/')));
  } catch {
    throw new LinkError('The part of the link behind # is no state of this page.');
  }
  try {
    return state(value, '') as State;
  } catch (error) {
    throw new LinkError(`The state in the link is not valid: ${(error as Error).message}.`);
  }
}
