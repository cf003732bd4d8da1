/** Starts the page. */
import { App } from './app';
import { loadCore } from './core';
import { byId } from './elements';
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
  const app = new App(core, view, scene);
  window.sturmViewer = { app, measured: new Measured(app) };
}

start().catch((problem: Error) => {
  const message = byId('message');
  message.textContent = problem.message;
  message.classList.add('problem');
  message.hidden = false;
});
