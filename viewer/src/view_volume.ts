/** What of space a picture can show, so that the rasteriser leaves out the rest. */
import type { Pose } from './camera';

/** A point is outside where a·x + b·y + c·z + d < 0 for one of them; in the world. */
export type Planes = [number, number, number, number][];

/** Of pupil points [m] and slopes of rays there [rad], for all accommodation. */
export interface RayLimits { pupil: number; slope: number }

/** Of a node's ray: how much each coordinate of origin and direction can differ from its chief ray's. `at`: 0 for origins, 16 for directions. */
function reach(nodes: Float32Array, first: number, at: number, axis: number, limits: RayLimits): number {
  const norm = (k: number) => Math.hypot(nodes[first + k + axis] ?? 0, nodes[first + k + 4 + axis] ?? 0);
  return limits.pupil * norm(8 + at) + limits.slope * norm(16 + at);
}

/** Of points (u, −z) of all rays: u ≥ slope·(−z) + start, for one end of their slopes. */
interface Edge { slope: number; start: number }

/** The upper end of `sign` times an axis; null where a ray does not lead forwards. */
function edgeOf(nodes: Float32Array, axis: number, sign: 1 | -1, limits: RayLimits): Edge | null {
  let slope = -Infinity, start = -Infinity;
  for (let first = 0; first < nodes.length; first += 40) {
    const wide = reach(nodes, first, 16, axis, limits), deep = reach(nodes, first, 16, 2, limits), ahead = -(nodes[first + 6] ?? 0);
    if (ahead - deep < 0.05) return null;
    const along = [sign * (nodes[first + 4 + axis] ?? 0) + wide, sign * (nodes[first + 4 + axis] ?? 0) - wide].flatMap((x) => [x / (ahead + deep), x / (ahead - deep)]);
    const most = Math.max(...along), least = Math.min(...along), z = nodes[first + 2] ?? 0, dz = reach(nodes, first, 0, 2, limits);
    const behind = Math.max(most * (z + dz), most * (z - dz), least * (z + dz), least * (z - dz));
    slope = Math.max(slope, most);
    start = Math.max(start, sign * (nodes[first + axis] ?? 0) + reach(nodes, first, 0, axis, limits) + behind);
  }
  return { slope, start };
}

/** `nodes`: rays over the whole picture, as the core's `sights` has them. Null where no planes bound them. */
export function viewVolume(nodes: Float32Array, pose: Pose, limits: RayLimits): Planes | null {
  const planes: Planes = [];
  for (const axis of [0, 1])
    for (const sign of [1, -1] as const) {
      const edge = edgeOf(nodes, axis, sign, limits);
      if (!edge) return null;
      // Two pixels more, since places move within a pixel.
      const slope = edge.slope + 2 * (pose.pixelSlope[axis] ?? 0);
      const normal = [0, 1, 2].map((k) => -sign * (pose.head[3 * axis + k] ?? 0) - slope * (pose.head[6 + k] ?? 0)) as [number, number, number];
      planes.push([...normal, edge.start - normal.reduce((sum, n, k) => sum + n * (pose.position[k] ?? 0), 0)]);
    }
  return planes;
}

/** The triangles (three numbers of `index` each) that no plane has wholly outside. `stride` floats a vertex, of which the first three are its position. */
export function indexWithin(planes: Planes | null, vertices: Float32Array, stride: number, index: Uint32Array): Uint32Array {
  if (!planes) return index;
  const outside = new Uint8Array(vertices.length / stride), within = new Uint32Array(index.length);
  for (let v = 0, at = 0; v < outside.length; ++v, at += stride) {
    const x = vertices[at] ?? 0, y = vertices[at + 1] ?? 0, z = vertices[at + 2] ?? 0;
    let sides = 0;
    for (let k = 0; k < planes.length; ++k) {
      const plane = planes[k] as Planes[number];
      if (plane[0] * x + plane[1] * y + plane[2] * z + plane[3] < 0) sides |= 1 << k;
    }
    outside[v] = sides;
  }
  let count = 0;
  for (let t = 0; t < index.length; t += 3) {
    const a = index[t] ?? 0, b = index[t + 1] ?? 0, c = index[t + 2] ?? 0;
    if ((outside[a] ?? 0) & (outside[b] ?? 0) & (outside[c] ?? 0)) continue;
    within[count++] = a;
    within[count++] = b;
    within[count++] = c;
  }
  return within.subarray(0, count);
}
