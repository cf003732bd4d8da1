/** A noted prescription as the state of the eyes that it names. */
import type { Core } from './core_module';
import { ranges, type State } from './state';

const words = { sphere_D: 'spheres', cylinder_D: 'cylinders' } as const;

/** How the text changes the state. Throws the core's message, or what the page does not show. */
export function prescribed(core: Core, text: string): (state: State) => void {
  const noted = core.readNotation(text);
  if (noted.length === 0) throw new Error('Expected a prescription, for example -2.00 -1.50 x 30.');
  for (const { prescription } of noted)
    for (const key of ['sphere_D', 'cylinder_D'] as const)
      if (!(prescription[key] >= ranges[key][0] && prescription[key] <= ranges[key][1])) throw new Error(`This page shows ${words[key]} from ${ranges[key][0]} to ${ranges[key][1]} D.`);
  return (state) => {
    for (const { eye, prescription: p, addition_D } of noted) {
      const side = eye ?? state.side;
      Object.assign(state.eyes[side], { sphere_D: p.sphere_D, cylinder_D: p.cylinder_D, axis_deg: p.axis_deg, wavefront: null });
      if (addition_D !== null) state.glasses[side].addition_D = Math.min(ranges.addition_D[1], Math.max(0, addition_D));
    }
  };
}
