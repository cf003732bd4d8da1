/** The head in the world and the picture's pixels. */
import type { CameraNumbers } from './core_module';
import type { CameraState } from './state';

export interface Pose {
  /** Columns right, up, back. */
  head: number[];
  position: [number, number, number];
  /** Of a pixel's width and height. */
  pixelSlope: [number, number];
  /** Where straight ahead is in the picture [px], y down. */
  center: [number, number];
  width: number;
  height: number;
}

/** Chief slopes of a picture's edges: left, right, lower, upper. */
export function edgesOf(pose: Pose): [number, number, number, number] {
  const [sx, sy] = pose.pixelSlope, [cx, cy] = pose.center;
  return [-cx * sx, (pose.width - cx) * sx, (cy - pose.height) * sy, cy * sy];
}

export function poseOf(camera: CameraState, width: number, height: number): Pose {
  const rad = Math.PI / 180, st = Math.sin(camera.turn_deg * rad), ct = Math.cos(camera.turn_deg * rad), se = Math.sin(camera.tilt_deg * rad), ce = Math.cos(camera.tilt_deg * rad);
  const head = [ct, 0, st, -st * se, ce, ct * se, -st * ce, -se, ct * ce];
  const slope = (2 * Math.tan(0.5 * camera.field_deg * rad)) / height;
  return { head, position: camera.position_m, pixelSlope: [slope, slope], center: [0.5 * width, 0.5 * height], width, height };
}

export function numbersOf(camera: CameraState, width: number, height: number): CameraNumbers {
  const { head, position } = poseOf(camera, width, height);
  const look = position.map((x, k) => x - (head[6 + k] ?? 0)) as [number, number, number];
  return { position_m: position, look_at_m: look, up: [0, 1, 0], vfov_rad: (camera.field_deg * Math.PI) / 180, width, height, gaze: camera.gaze };
}
