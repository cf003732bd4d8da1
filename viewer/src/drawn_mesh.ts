/** The scene as triangles for the rasteriser, cut so small that the field and the light are linear within each. */
import { Numbering } from './numbering';
import type { MaterialFacts, SceneData, TextureMap, Vec3 } from './scene_file';
import { wraps } from './scene_tables';

/**
 * Position; coordinates on the textures of reflectance and emission; of each its number (−1: none) and how it is read (wraps in bits 0–1 and 2–3, 16:
 * no mixing of texels); reflectance; emission and 1 where it shines behind.
 */
export const vertexParts = [3, 4, 4, 3, 4];

export interface DrawnMesh {
  /** 18 floats a vertex: `vertexParts`. */
  vertices: Float32Array;
  /** 8 floats a vertex: position, material, normal on the side of the eye, 0: where light is gathered. */
  places: Float32Array;
  index: Uint32Array;
  vertexCount: number;
}

type Vec2 = [number, number];
interface Corner { position: Vec3; normal: Vec3; coordinate: Vec2; emissionCoordinate: Vec2; colour: Vec3 }
type Three = [Corner, Corner, Corner];

const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vec3, b: Vec3): Vec3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a: Vec3) => Math.sqrt(dot(a, a));
const middle = (a: Vec3, b: Vec3): Vec3 => [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])];
const halfway2 = (a: Vec2, b: Vec2): Vec2 => [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];

/** Where a texture has a coordinate. */
function on(map: TextureMap | null, [u, v]: Vec2): Vec2 {
  const [xu = 1, xv = 0, x = 0, yu = 0, yv = 1, y = 0] = map?.matrix ?? [];
  return [xu * u + xv * v + x, yu * u + yv * v + y];
}

function reading(material: MaterialFacts, map: TextureMap | null): Vec2 {
  return map ? [map.texture, wraps[map.wrap[0]] + 4 * wraps[map.wrap[1]] + (material.nearest ? 16 : 0)] : [-1, 0];
}

function halfway(a: Corner, b: Corner): Corner {
  return {
    position: middle(a.position, b.position), normal: middle(a.normal, b.normal), colour: middle(a.colour, b.colour),
    coordinate: halfway2(a.coordinate, b.coordinate), emissionCoordinate: halfway2(a.emissionCoordinate, b.emissionCoordinate),
  };
}

/** Collects triangles; equal corners of one material whose surfaces face nearly alike become one vertex. */
class MeshBuilder {
  private readonly numbers = new Numbering(11);
  readonly vertices: number[] = [];
  readonly places: number[] = [];
  readonly index: number[] = [];

  constructor(private readonly eye: Vec3, private readonly materials: readonly MaterialFacts[]) {}

  add(corners: Three, material: number): void {
    const [a, b, c] = corners;
    const flat = cross(subtract(b.position, a.position), subtract(c.position, a.position)), size = length(flat);
    if (size === 0) return;
    const side = dot(flat, subtract(this.eye, a.position)) < 0 ? -1 / size : 1 / size;
    const normal: Vec3 = [flat[0] * side, flat[1] * side, flat[2] * side];
    for (const corner of corners) this.index.push(this.numberOf(corner, normal, material));
  }

  private numberOf(corner: Corner, flat: Vec3, material: number): number {
    const { position: p, coordinate: c, colour } = corner, smooth = length(corner.normal), scale = (dot(corner.normal, flat) < 0 ? -1 : 1) / smooth;
    const n: Vec3 = smooth > 0 ? [corner.normal[0] * scale, corner.normal[1] * scale, corner.normal[2] * scale] : flat;
    const before = this.numbers.count, number = this.numbers.numberOf([p[0], p[1], p[2], material, Math.round(4 * n[0]), Math.round(4 * n[1]), Math.round(4 * n[2]), c[0], c[1], ...corner.emissionCoordinate]);
    if (number === before) {
      const m = this.materials[material] as MaterialFacts, { albedo: a } = m;
      this.vertices.push(p[0], p[1], p[2], ...on(m.albedo_map, c), ...on(m.emission_map, corner.emissionCoordinate), ...reading(m, m.albedo_map), ...reading(m, m.emission_map),
        a[0] * colour[0], a[1] * colour[1], a[2] * colour[2], ...m.emission, m.emits_behind ? 1 : 0);
      this.places.push(p[0], p[1], p[2], material, n[0], n[1], n[2], 0);
    }
    return number;
  }
}

/**
 * Cuts every edge that is seen under more than the angle, from both of its sides alike, so that no gaps open; the longest first, so that pieces of a long
 * and narrow triangle are not narrow: a rasteriser that clips them at the picture's edge would leave gaps.
 */
function cut(corners: Three, isLong: (a: Corner, b: Corner) => boolean, add: (piece: Three) => void): void {
  const [a, b, c] = corners, turns: Three[] = [[a, b, c], [b, c, a], [c, a, b]];
  let longest: Three | null = null, most = 0;
  for (const turn of turns) {
    const size = length(subtract(turn[0].position, turn[1].position));
    if (size > most && isLong(turn[0], turn[1])) [longest, most] = [turn, size];
  }
  if (!longest) {
    add(corners);
    return;
  }
  const [from, to, across] = longest, between = halfway(from, to);
  cut([from, between, across], isLong, add);
  cut([between, to, across], isLong, add);
}

function cornerOf(scene: SceneData, v: number): Corner {
  const two = (from: Float32Array | null): Vec2 => (from ? [from[2 * v] ?? 0, from[2 * v + 1] ?? 0] : [0, 0]);
  const three = (from: Float32Array | null, stride: number, otherwise: Vec3): Vec3 => (from ? [from[stride * v] ?? 0, from[stride * v + 1] ?? 0, from[stride * v + 2] ?? 0] : otherwise);
  return {
    position: three(scene.positions, 3, [0, 0, 0]), normal: three(scene.normals, 3, [0, 0, 0]),
    coordinate: two(scene.coordinates), emissionCoordinate: two(scene.emissionCoordinates ?? scene.coordinates),
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
  const out = (p: Vec3): Vec3 => { const l = length(p); return [p[0] / l, p[1] / l, p[2] / l]; };
  for (let k = 0; k < steps; ++k)
    faces = faces.flatMap((face) => {
      const [a, b, c] = face as [Vec3, Vec3, Vec3], d = out(middle(a, b)), e = out(middle(b, c)), f = out(middle(c, a));
      return [[a, d, f], [d, b, e], [f, e, c], [d, e, f]];
    });
  return faces;
}

const mostTriangles = 150000;

interface Piece { corners: Three; material: number }

/** Null where an edge limit makes more than `most`. */
function piecesOf(scene: SceneData, corners: readonly Three[], eye: Vec3, angle: number, most: number): Piece[] | null {
  const pieces: Piece[] = [];
  // Whoever has too many already cuts no further.
  const isLong = (a: Corner, b: Corner) =>
    pieces.length <= most && length(subtract(a.position, b.position)) > angle * Math.max(0.2, length(subtract(middle(a.position, b.position), eye)));
  for (let t = 0; t < corners.length && pieces.length <= most; ++t) {
    const material = scene.triangleMaterials[t] ?? 0;
    cut(corners[t] as Three, isLong, (piece) => pieces.push({ corners: piece, material }));
  }
  return pieces.length <= most ? pieces : null;
}

/** `angle_rad`: the largest that an edge may be seen under from the eye, unless that makes too many triangles; then it grows. */
export function drawnMesh(scene: SceneData, eye: Vec3, angle_rad: number): DrawnMesh {
  const corners = Array.from({ length: scene.triangles.length / 3 }, (_, t) => [0, 1, 2].map((c) => cornerOf(scene, scene.triangles[3 * t + c] ?? 0)) as Three);
  const most = mostTriangles + corners.length;
  let pieces = piecesOf(scene, corners, eye, angle_rad, most);
  for (let angle = 1.5 * angle_rad; !pieces; angle *= 1.5) pieces = piecesOf(scene, corners, eye, angle, most);
  const into = new MeshBuilder(eye, scene.materials);
  for (const piece of pieces) into.add(piece.corners, piece.material);
  for (const ball of scene.spheres)
    for (const face of ballTriangles(3)) {
      const three = face.map((p): Corner => ({
        position: p.map((x, k) => (ball.center_m[k] ?? 0) + ball.radius_m * x) as Vec3, normal: p, coordinate: [0, 0], emissionCoordinate: [0, 0], colour: [1, 1, 1],
      })) as Three;
      into.add(three, ball.material);
    }
  return { vertices: new Float32Array(into.vertices), places: new Float32Array(into.places), index: new Uint32Array(into.index), vertexCount: into.places.length / 8 };
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
