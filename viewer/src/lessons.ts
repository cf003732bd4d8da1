/** Five states for teachers, with two sentences each. They change the eye and the modes, and begin where the view does. */
import { startEye, startGlasses, type State } from './state';

export interface Lesson {
  title: string;
  text: string;
  set(state: State): void;
}

function eye(state: State, numbers: Partial<typeof startEye>): void {
  state.eyes[state.side] = { ...startEye, pupil_mm: 5, ...numbers };
  state.glasses[state.side] = { ...startGlasses };
  state.rayModel = 'power_matrix';
  state.fieldOverlay = state.rimOverlay = state.lensMap = false;
}

export const lessons: readonly Lesson[] = [
  {
    title: 'Myopia',
    text: 'An eye of −2 D sees sharply at half a metre, and everything beyond is spread over a disc. Make the pupil small: the same error blurs less, which is why short-sighted people squint.',
    set: (s) => { eye(s, { sphere_D: -2 }); s.modes = ['raster']; },
  },
  {
    title: 'Hyperopia',
    text: 'An eye of +2 D that may accommodate by 4 D sees the far wall as sharply as any other, at the price of half of its strength. Lower the amplitude: first what is near goes out of focus, and below 2 D everything does.',
    set: (s) => { eye(s, { sphere_D: 2, accommodation: 'best', amplitude_D: 4 }); s.modes = ['raster']; },
  },
  {
    title: 'Astigmatism',
    text: 'A cylinder of −2 D blurs along one meridian, so a point becomes an ellipse. Turn the dial: the ellipse under the pointer turns the other way, since AXIS is written as an examiner sees it who faces the wearer.',
    set: (s) => { eye(s, { sphere_D: 0, cylinder_D: -2, axis_deg: 30 }); s.modes = ['raster']; s.fieldOverlay = true; },
  },
  {
    title: 'Presbyopia',
    text: 'At sixty an eye accommodates by about half a dioptre, so what is nearer than two metres blurs. Put on the progressive spectacles and let the eye turn: through their lower part what is near is sharp, and beside the corridor it is not.',
    set: (s) => {
      eye(s, { accommodation: 'best', amplitude_D: 0.5 });
      s.modes = ['raster'];
      s.lensMap = true;
      // The head is up, so that what is near lies where the lens has its near zone.
      Object.assign(s.camera, { gaze: 'foveal', tilt_deg: s.camera.tilt_deg + 15, field_deg: Math.max(80, s.camera.field_deg) });
    },
  },
  {
    title: 'sin² and the truth',
    text: 'On the left each ray is bent by the power of its own meridian alone (sin²), as some simulators do it. Choose the power matrix: what was missing is the tangential part of the bending, and the blur becomes a true disc or ellipse.',
    set: (s) => { eye(s, { sphere_D: 1, cylinder_D: -2, axis_deg: 30, pupil_mm: 6 }); s.rayModel = 'sin2_radial'; s.modes = ['path', 'raster']; },
  },
];
