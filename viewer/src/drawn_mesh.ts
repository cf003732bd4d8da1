/** The scene as triangles for the rasteriser, cut so small that the field and the light are linear within each. */
import type { SceneData, Vec3 } from './scene_file';

export interface DrawnMesh {
  /** 9 floats a vertex: position, material, texture coordinate, colour. */
  vertices: Float32Array;
  /** 8 floats a vertex: position, material, normal on the side of the eye, 0: where light is gathered. */
  places: Float32Array;
  index: Uint32Array;
  vertexCount: number;
}

interface Corner { position: Vec3; normal: Vec3; coordinate: [number, number]; colour: Vec3 }

const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vec3, b: Vec3): Vec3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const middle = <T extends number[]>(a: T, b: T) => a.map((x, k) => 0.5 * (x + (b[k] ?? 0))) as T;

function halfway(a: Corner, b: Corner): Corner {
  return { position: middle(a.position, b.position), normal: middle(a.normal, b.normal), coordinate: middle(a.coordinate, b.coordinate), colour: middle(a.colour, b.colour) };
}

/** Collects triangles; equal corners of one material whose surfaces face nearly alike become one vertex. */
class MeshBuilder {
  private readonly numbers = new Map<string, number>();
  readonly vertices: number[] = [];
  readonly places: number[] = [];
  readonly index: number[] = [];

  constructor(private readonly eye: Vec3) {}

  add(corners: [Corner, Corner, Corner], material: number): void {
    const [a, b, c] = corners;
    const flat = cross(subtract(b.position, a.position), subtract(c.position, a.position)), length = Math.hypot(...flat);
    if (length === 0) return;
    const side = dot(flat, subtract(this.eye, a.position)) < 0 ? -1 / length : 1 / length;
    const normal: Vec3 = [flat[0] * side, flat[1] * side, flat[2] * side];
    for (const corner of corners) this.index.push(this.numberOf(corner, normal, material));
  }

  private numberOf(corner: Corner, flat: Vec3, material: number): number {
    const smooth = Math.hypot(...corner.normal), sign = dot(corner.normal, flat) < 0 ? -1 : 1;
    const normal = smooth > 0 ? (corner.normal.map((x) => (sign * x) / smooth) as Vec3) : flat;
    const key = [...corner.position, material, ...normal.map((x) => Math.round(4 * x)), ...corner.coordinate].join();
    const known = this.numbers.get(key);
    if (known !== undefined) return known;
    const number = this.numbers.size;
    this.numbers.set(key, number);
    this.vertices.push(...corner.position, material, ...corner.coordinate, ...corner.colour);
    this.places.push(...corner.position, material, ...normal, 0);
    return number;
  }
}

/** Cuts every edge that is seen under more than the angle, from both of its sides alike, so that no gaps open. */
function cut(corners: [Corner, Corner, Corner], material: number, isLong: (a: Corner, b: Corner) => boolean, depth: number, into: Pick<MeshBuilder, 'add'>): void {
  const [a, b, c] = corners;
  const ab = depth > 0 && isLong(a, b), bc = depth > 0 && isLong(b, c), ca = depth > 0 && isLong(c, a);
  const again = (...next: [Corner, Corner, Corner]) => cut(next, material, isLong, depth - 1, into);
  if (ab && bc && ca) {
    const d = halfway(a, b), e = halfway(b, c), f = halfway(c, a);
    again(a, d, f); again(d, b, e); again(f, e, c); again(d, e, f);
  } else if (ab) {
    const d = halfway(a, b);
    again(a, d, c); again(d, b, c);
  } else if (bc) {
    const e = halfway(b, c);
    again(b, e, a); again(e, c, a);
  } else if (ca) {
    const f = halfway(c, a);
    again(c, f, b); again(f, a, b);
  } else {
    into.add(corners, material);
  }
}

function cornerOf(scene: SceneData, v: number): Corner {
  const three = (from: Float32Array | null, stride: number, otherwise: Vec3): Vec3 => (from ? [from[stride * v] ?? 0, from[stride * v + 1] ?? 0, from[stride * v + 2] ?? 0] : otherwise);
  return {
    position: three(scene.positions, 3, [0, 0, 0]), normal: three(scene.normals, 3, [0, 0, 0]),
    coordinate: scene.coordinates ? [scene.coordinates[2 * v] ?? 0, scene.coordinates[2 * v + 1] ?? 0] : [0, 0],
    colour: three(scene.colours, 4, [1, 1, 1]),
  };
}

/** 8 faces, cut by `steps` into 4 each: points of the unit sphere. */
function ballTriangles(steps: number): Vec3[][] {
  const signs = [-1, 1];
  let faces: Vec3[][] = signs.flatMap((x) => signs.flatMap((y) => signs.map((z): Vec3[] => {
    const face: Vec3[] = [[x, 0, 0], [0, y, 0], [0, 0, z]];
    return x * y * z > 0 ? face : face.reverse();
  })));
  const out = (p: Vec3): Vec3 => { const l = Math.hypot(...p); return [p[0] / l, p[1] / l, p[2] / l]; };
  for (let k = 0; k < steps; ++k)
    faces = faces.flatMap((face) => {
      const [a, b, c] = face as [Vec3, Vec3, Vec3], d = out(middle(a, b)), e = out(middle(b, c)), f = out(middle(c, a));
      return [[a, d, f], [d, b, e], [f, e, c], [d, e, f]];
    });
  return faces;
}

/** How many triangles an edge limit makes of one; stops counting beyond `most`. */
function pieces(corners: [Corner, Corner, Corner], isLong: (a: Corner, b: Corner) => boolean, depth: number, most: number): number {
  let count = 0;
  cut(corners, 0, (a, b) => count < most && isLong(a, b), depth, { add: () => { ++count; } });
  return count;
}

const depth = 12, mostTriangles = 150000;

/** `angle_rad`: the largest that an edge may be seen under from the eye, unless that makes too many triangles; then it grows. */
export function drawnMesh(scene: SceneData, eye: Vec3, angle_rad: number): DrawnMesh {
  const corners = Array.from({ length: scene.triangles.length / 3 }, (_, t) => [0, 1, 2].map((c) => cornerOf(scene, scene.triangles[3 * t + c] ?? 0)) as [Corner, Corner, Corner]);
  const longer = (angle: number) => (a: Corner, b: Corner) => {
    const from = Math.hypot(...subtract(middle(a.position, b.position), eye));
    return Math.hypot(...subtract(a.position, b.position)) > angle * Math.max(0.2, from);
  };
  const most = mostTriangles + corners.length;
  let angle = angle_rad;
  for (let sum = most + 1; sum > most; angle *= 1.5) {
    sum = 0;
    for (let t = 0; t < corners.length && sum <= most; ++t) sum += pieces(corners[t] as [Corner, Corner, Corner], longer(angle), depth, most);
    if (sum <= most) break;
  }
  const into = new MeshBuilder(eye), isLong = longer(angle);
  corners.forEach((three, t) => cut(three, scene.triangleMaterials[t] ?? 0, isLong, depth, into));
  for (const ball of scene.spheres)
    for (const face of ballTriangles(3)) {
      const three = face.map((p): Corner => ({
        position: p.map((x, k) => (ball.center_m[k] ?? 0) + ball.radius_m * x) as Vec3, normal: p, coordinate: [0, 0], colour: [1, 1, 1],
      })) as [Corner, Corner, Corner];
      into.add(three, ball.material);
    }
  return { vertices: new Float32Array(into.vertices), places: new Float32Array(into.places), index: new Uint32Array(into.index), vertexCount: into.vertices.length / 9 };
}

/** Up to 8 vertices that share an edge with each; −1 where there are fewer. */
export function neighboursOf(mesh: DrawnMesh): Float32Array {
  const lists = new Float32Array(8 * mesh.vertexCount).fill(-1);
  const add = (a: number, b: number) => {
    for (let k = 8 * a; k < 8 * a + 8; ++k) {
      if (lists[k] === b) return;
      if (lists[k] === -1) {
        lists[k] = b;
        return;
      }
    }
  };
  for (let t = 0; t < mesh.index.length; t += 3)
    for (let c = 0; c < 3; ++c) {
      const a = mesh.index[t + c] ?? 0, b = mesh.index[t + ((c + 1) % 3)] ?? 0;
      add(a, b);
      add(b, a);
    }
  return lists;
}
