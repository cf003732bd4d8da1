/** The list of what the page leaves out. */
import { byId, element } from './elements';

const always = ['Sharp and rasterised pictures have matt light, gathered at vertices: no highlights, mirrors or glass.', 'Rays through spectacles are of first order in the pupil, in every mode.'];

export function showLeftOut(ofView: string[]): void {
  byId('left-out').querySelector('ul')?.replaceChildren(...[...always, ...ofView].map((text) => element('li', { textContent: text })));
}
