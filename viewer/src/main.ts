/** Starts the page. */
import { App } from './app';
import { loadCore } from './core';
import { byId, element } from './elements';
import { Measured } from './measured';
import { sceneOfPage, viewOfPage } from './view_data';

declare global {
  interface Window {
    /** For scripts that drive the page. */
    sturmViewer?: { app: App; measured: Measured };
  }
}

async function start(): Promise<void> {
  const view = viewOfPage();
  if (!view) throw new Error('This page has no view in it; `sturm view VIEW.json -o page.html` makes one that has.');
  const [core, scene] = await Promise.all([loadCore(), sceneOfPage()]);
  byId('title').textContent = view.title;
  document.title = `${view.title} · Sturm`;
  const fixed = ['Sharp and rasterised pictures have matt light, gathered at vertices: no highlights, mirrors or glass.', 'Rays through spectacles are of first order in the pupil, in every mode.'];
  byId('left-out').querySelector('ul')?.replaceChildren(...[...fixed, ...view.notDrawn].map((text) => element('li', { textContent: text })));
  const app = new App(core, view, scene);
  window.sturmViewer = { app, measured: new Measured(app) };
}

start().catch((problem: Error) => {
  const message = byId('message');
  message.textContent = problem.message;
  message.hidden = false;
});
