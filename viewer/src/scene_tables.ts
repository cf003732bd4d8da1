/** A scene as the tables that the shaders read (viewer/shaders/surfaces.glsl, intersect.glsl, light.glsl). */
import { luminance } from './colour';
import { environmentShares } from './environment_table';
import type { MaterialFacts, Picture, SceneData, TextureMap, Vec3 } from './scene_file';
import type { SceneTree } from './scene_tree';

export interface SceneTables {
  bounds: Float32Array;
  nodes: Uint32Array;
  corners: Float32Array;
  attributes: Float32Array | null;
  materials: Float32Array;
  mattMaterial: number;
  texels: Float32Array;
  textures: Float32Array;
  spheres: Float32Array;
  sphereCount: number;
  lights: Float32Array;
  lightCount: number;
  environmentRows: Float32Array;
  /** Of all choices of a lamp. */
  environmentShare: number;
}

interface Light { kind: 0 | 1 | 2 | 3; power: number; behind: boolean; a: number[]; radius: number; b: number[]; c: number[]; radiance: Vec3 }

const types: Record<string, number> = { diffuse: 0, conductor: 1, dielectric: 2, plastic: 3 };
export const wraps: Record<TextureMap['wrap'][0], number> = { clamp: 0, repeat: 1, mirror: 2 };

/** 2 ∫ F(μ) μ dμ of a dielectric, and from it what a coat sends back to its base (pathtrace/materials/plastic.cpp). */
export function internalReflectance(index: number): number {
  const steps = 1024;
  let sum = 0;
  for (let i = 0; i < steps; ++i) {
    const cosine = Math.sqrt((i + 0.5) / steps), far = Math.sqrt(1 - (1 - cosine * cosine) / (index * index));
    const parallel = (index * cosine - far) / (index * cosine + far), perpendicular = (cosine - index * far) / (cosine + index * far);
    sum += (0.5 * (parallel * parallel + perpendicular * perpendicular)) / steps;
  }
  return 1 - (1 - sum) / (index * index);
}

function mapTexels(map: TextureMap | null): number[] {
  if (!map) return [1, 0, 0, 0, 0, 1, 0, 0];
  const m = map.matrix;
  return [m[0] ?? 1, m[1] ?? 0, m[2] ?? 0, wraps[map.wrap[0]], m[3] ?? 0, m[4] ?? 1, m[5] ?? 0, wraps[map.wrap[1]]];
}

function materialTexels(m: MaterialFacts): number[] {
  const type = types[m.type] ?? 0, index = m.index ?? 1.5;
  return [
    ...m.albedo, type, ...m.emission, m.emits_behind ? 1 : 0,
    m.roughness ?? 0, index, type === 3 ? internalReflectance(index) : 0, m.nearest ? 1 : 0,
    ...(m.eta ?? [1, 1, 1]), m.albedo_map ? m.albedo_map.texture : -1,
    ...(m.kappa ?? [0, 0, 0]), m.emission_map ? m.emission_map.texture : -1,
    ...mapTexels(m.albedo_map), ...mapTexels(m.emission_map), 0, 0, 0, 0,
  ];
}

/** All pictures one behind the other; a grey one gets three channels. The fourth number is that of `ends`, for the picture that has them. */
function textureTables(pictures: Picture[], environment: number | null, ends: Float32Array | null): { texels: Float32Array; textures: Float32Array } {
  const texels = new Float32Array(4 * Math.max(1, pictures.reduce((sum, p) => sum + p.width * p.height, 0)));
  const textures = new Float32Array(4 * Math.max(1, pictures.length));
  let first = 0;
  pictures.forEach((p, k) => {
    textures.set([first, p.width, p.height, 0], 4 * k);
    for (let i = 0; i < p.width * p.height; ++i)
      for (let c = 0; c < 3; ++c) texels[4 * (first + i) + c] = p.values[i * p.channels + Math.min(c, p.channels - 1)] ?? 0;
    if (k === environment) ends?.forEach((end, i) => { texels[4 * (first + i) + 3] = end; });
    first += p.width * p.height;
  });
  return { texels, textures };
}

/** A lamp that is chosen as such. Surfaces whose emission has a texture are found by the paths alone. */
function shines(m: MaterialFacts | undefined): m is MaterialFacts {
  return !!m && luminance(m.emission) > 0 && !m.emission_map;
}

function cornersOf(scene: SceneData, index: ArrayLike<number>, triangle: number): number[][] {
  return [0, 1, 2].map((c) => Array.from(scene.positions.subarray(3 * (index[3 * triangle + c] ?? 0), 3 * (index[3 * triangle + c] ?? 0) + 3)));
}

function areaOf([a, b, c]: number[][]): number {
  const [e, f] = [b, c].map((q) => (q ?? []).map((x, k) => x - (a?.[k] ?? 0))) as [Vec3, Vec3];
  return 0.5 * Math.hypot(e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]);
}

function lightTable(lights: Light[]): Float32Array {
  const table = new Float32Array(20 * Math.max(1, lights.length)), total = lights.reduce((sum, light) => sum + light.power, 0);
  let end = 0;
  lights.forEach((light, k) => {
    const share = light.power / total;
    end += share;
    const last = k + 1 === lights.length ? 2 : end;
    table.set([light.kind, last, share, light.behind ? 1 : 0, ...light.a, light.radius, ...light.b, 0, ...light.c, 0, ...light.radiance, 0], 20 * k);
  });
  return table;
}

function attributesOf(scene: SceneData, index: Uint32Array): Float32Array | null {
  if (!scene.normals && !scene.coordinates && !scene.colours) return null;
  const table = new Float32Array((36 * index.length) / 3), emission = scene.emissionCoordinates ?? scene.coordinates;
  for (let t = 0; t < index.length / 3; ++t)
    for (let c = 0; c < 3; ++c) {
      const v = index[3 * t + c] ?? 0, first = 36 * t;
      if (scene.normals) table.set(scene.normals.subarray(3 * v, 3 * v + 3), first + 4 * c);
      table[first + 4 * c + 3] = scene.coordinates?.[2 * v] ?? 0;
      table[first + 12 + c] = scene.coordinates?.[2 * v + 1] ?? 0;
      table[first + 16 + c] = emission?.[2 * v] ?? 0;
      table[first + 20 + c] = emission?.[2 * v + 1] ?? 0;
      table.set(scene.colours ? scene.colours.subarray(4 * v, 4 * v + 3) : [1, 1, 1], first + 24 + 4 * c);
    }
  return table;
}

export function sceneTables(scene: SceneData, tree: SceneTree): SceneTables {
  const triangles = tree.index.length / 3;
  const corners = new Float32Array(12 * Math.max(1, triangles)), lights: Light[] = [];
  for (let t = 0; t < triangles; ++t) {
    const material = scene.triangleMaterials[tree.numbers[t] ?? 0] ?? 0, facts = scene.materials[material], at = cornersOf(scene, tree.index, t);
    let light = -1;
    if (shines(facts)) {
      light = lights.length;
      const power = Math.PI * areaOf(at) * luminance(facts.emission) * (facts.emits_behind ? 2 : 1);
      lights.push({ kind: 0, power, behind: facts.emits_behind, a: at[0] ?? [], radius: 0, b: at[1] ?? [], c: at[2] ?? [], radiance: facts.emission });
    }
    corners.set([...(at[0] ?? []), material, ...(at[1] ?? []), tree.numbers[t] ?? 0, ...(at[2] ?? []), light], 12 * t);
  }
  const spheres = new Float32Array(8 * Math.max(1, scene.spheres.length));
  scene.spheres.forEach((ball, k) => {
    const facts = scene.materials[ball.material];
    let light = -1;
    if (shines(facts)) {
      light = lights.length;
      const power = 4 * Math.PI * Math.PI * ball.radius_m ** 2 * luminance(facts.emission);
      lights.push({ kind: 1, power, behind: false, a: ball.center_m, radius: ball.radius_m, b: [0, 0, 0], c: [0, 0, 0], radiance: facts.emission });
    }
    spheres.set([...ball.center_m, ball.radius_m, ball.material, light, 0, 0], 8 * k);
  });
  for (const point of scene.lights)
    lights.push({ kind: 2, power: 4 * Math.PI * luminance(point.intensity), behind: false, a: point.position_m, radius: 0, b: [0, 0, 0], c: [0, 0, 0], radiance: point.intensity });
  const sky = scene.environment && scene.environment.texture !== null ? scene.textures[scene.environment.texture] : undefined, shares = sky ? environmentShares(sky) : null;
  const environmentShare = shares ? (lights.length > 0 ? 0.5 : 1) : 0;
  // Half of all choices are the surroundings', as in pathtrace/lights/light_set.cpp.
  if (shares) lights.push({ kind: 3, power: lights.reduce((sum, light) => sum + light.power, 0) || 1, behind: false, a: [0, 0, 0], radius: 0, b: [0, 0, 0], c: [0, 0, 0], radiance: [0, 0, 0] });
  const matt: MaterialFacts = { name: '', type: 'diffuse', albedo: [1, 1, 1], emission: [0, 0, 0], emits_behind: false, nearest: false, albedo_map: null, emission_map: null };
  return {
    bounds: tree.bounds, nodes: tree.nodes, corners,
    attributes: attributesOf(scene, tree.index),
    materials: new Float32Array([...scene.materials, matt].flatMap(materialTexels)), mattMaterial: scene.materials.length,
    ...textureTables(scene.textures, scene.environment?.texture ?? null, shares?.ends ?? null),
    spheres, sphereCount: scene.spheres.length, lights: lightTable(lights), lightCount: lights.length,
    environmentRows: shares?.rows ?? new Float32Array(4), environmentShare,
  };
}
