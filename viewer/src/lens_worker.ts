/** Runs in a worker, behind the core's script: makes the front of a progressive lens while the page stays awake. */
import { loadCore } from './core';
import type { LensAnswer, LensOrder } from './lens_maker';

const core = loadCore();

addEventListener('message', ({ data: { key, eye, lens } }: MessageEvent<LensOrder>) => {
  void core.then(({ Optics }) => {
    const optics = new Optics();
    let answer: LensAnswer;
    try {
      optics.setEye(eye);
      optics.setLens(lens);
      answer = { key, front: optics.frontSpline(), refusal: '' };
    } catch (problem) {
      answer = { key, front: null, refusal: (problem as Error).message };
    }
    optics.delete();
    postMessage(answer);
  });
});
