/** The optics core, from the classic script that stands before the page's own. */
import type { Core, CoreFactory } from './core_module';

export async function loadCore(): Promise<Core> {
  const factory = (globalThis as { SturmCore?: CoreFactory }).SturmCore;
  if (!factory) throw new Error('This page was built without its optics core.');
  return factory();
}
