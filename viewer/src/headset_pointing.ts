/** The panel's place in the room, and who points at it: a controller, a hand, or a look and a pinch (`transient-pointer`), all by a ray. */
import type { Drag, HeadsetPanel } from './headset_panel';
import type { Vec3 } from './scene_file';

/** Before and below the eyes of somebody who sits, within reach of a look and clear of what is straight ahead [m]. */
const ahead = 0.75, below = 0.38, halfWidth = 0.27;

const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const along = (a: Vec3, t: number, b: Vec3): Vec3 => [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]];

export class PanelPlace {
  readonly middle: Vec3;
  /** Half of the sides. */
  readonly right: Vec3;
  readonly up: Vec3;

  /** Where the head is, as the headset says: the panel stands there and faces it, level with the room. */
  constructor(head: XRRigidTransform, aspect: number) {
    const m = head.matrix, x = -(m[8] ?? 0), z = -(m[10] ?? 1), level = Math.hypot(x, z) || 1, forward: Vec3 = [x / level, 0, z / level];
    const { position: { x: px, y: py, z: pz } } = head, distance = Math.hypot(ahead, below), halfHeight = halfWidth / aspect;
    this.middle = along([px, py - below, pz], ahead, forward);
    this.right = [-halfWidth * forward[2], 0, halfWidth * forward[0]];
    // Across the line to the eyes.
    this.up = [(halfHeight * below * forward[0]) / distance, (halfHeight * ahead) / distance, (halfHeight * below * forward[2]) / distance];
  }

  /** Place on the panel, 0 … 1 from its upper left corner, that a ray meets; null beside it. */
  met(ray: XRRigidTransform): [number, number] | null {
    const m = ray.matrix, { position: { x, y, z } } = ray, origin: Vec3 = [x, y, z], direction: Vec3 = [-(m[8] ?? 0), -(m[9] ?? 0), -(m[10] ?? 0)];
    const { right: r, up: u } = this, normal: Vec3 = [r[1] * u[2] - r[2] * u[1], r[2] * u[0] - r[0] * u[2], r[0] * u[1] - r[1] * u[0]];
    const t = dot(along(this.middle, -1, origin), normal) / dot(direction, normal);
    if (!(t > 0)) return null;
    const there = along(along(origin, t, direction), -1, this.middle), h = dot(there, r) / dot(r, r), v = dot(there, u) / dot(u, u);
    return Math.abs(h) <= 1 && Math.abs(v) <= 1 ? [0.5 + 0.5 * h, 0.5 - 0.5 * v] : null;
  }
}

export class PanelPointing {
  place: PanelPlace | null = null;
  /** Where the panel is pointed at. */
  pointed: [number, number] | null = null;
  private readonly drags = new Map<XRInputSource, Drag>();
  private readonly holds = new Set<XRInputSource>();

  constructor(session: XRSession, private readonly space: XRReferenceSpace, private readonly panel: HeadsetPanel) {
    session.addEventListener('selectstart', ({ inputSource, frame }) => {
      const at = this.metBy(inputSource, frame);
      if (!at) {
        this.holds.add(inputSource);
        return;
      }
      const drag = this.panel.press(...at);
      if (drag) this.drags.set(inputSource, drag);
    });
    session.addEventListener('selectend', ({ inputSource }) => {
      this.drags.delete(inputSource);
      this.holds.delete(inputSource);
    });
  }

  /** A press beside the panel is held. */
  get isHeld(): boolean {
    return this.holds.size > 0;
  }

  private metBy(source: XRInputSource, frame: XRFrame): [number, number] | null {
    const ray = frame.getPose(source.targetRaySpace, this.space);
    return ray && this.place ? this.place.met(ray.transform) : null;
  }

  /** Once a frame: sliders follow the rays that hold them. */
  follow(frame: XRFrame): void {
    this.pointed = null;
    for (const source of frame.session.inputSources) {
      const at = this.metBy(source, frame);
      this.pointed ??= at;
      if (at) this.drags.get(source)?.(at[0]);
    }
  }
}
