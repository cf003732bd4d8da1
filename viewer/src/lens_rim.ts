/** The rim of the spectacles on the picture. */
import { edgesOf, type Pose } from './camera';
import type { Optics } from './core_module';

const meridians = 48, halvings = 11;

/** Where the lens ends in each meridian [px, y down], by halving between straight ahead and well beyond the picture. Empty where straight ahead is beyond the rim. */
export function rimOf(optics: Optics, gaze: 'camera' | 'foveal', pose: Pose): [number, number][] {
  const reaches = (x: number, y: number) => (optics.sights({ gaze, first_x: x, first_y: y, step_x: 1, step_y: 1, columns: 1, rows: 1 })[3] ?? -1) > 0;
  if (!reaches(0, 0)) return [];
  const far = 1.5 * Math.max(...edgesOf(pose).map(Math.abs)) * Math.SQRT2;
  return Array.from({ length: meridians }, (_, k): [number, number] => {
    const angle = (2 * Math.PI * k) / meridians, c = Math.cos(angle), s = Math.sin(angle);
    let inside = 0, outside = far;
    for (let n = 0; n < halvings; ++n) {
      const middle = 0.5 * (inside + outside);
      if (reaches(middle * c, middle * s)) inside = middle;
      else outside = middle;
    }
    return [pose.center[0] + (outside * c) / pose.pixelSlope[0], pose.center[1] - (outside * s) / pose.pixelSlope[1]];
  });
}
