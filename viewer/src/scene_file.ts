/** Reads `sturm.viewer_scene/1` (docs/formats/viewer_scene.md). Every place and number is checked before it is used. */

export type Vec3 = [number, number, number];

export interface TextureMap {
  texture: number;
  matrix: number[];
  wrap: ['clamp' | 'repeat' | 'mirror', 'clamp' | 'repeat' | 'mirror'];
}

export interface MaterialFacts {
  name: string;
  type: string;
  albedo: Vec3;
  emission: Vec3;
  emits_behind: boolean;
  nearest: boolean;
  albedo_map: TextureMap | null;
  emission_map: TextureMap | null;
  opacity?: { mode: 'opaque' | 'mask' | 'blend'; factor: number; cutoff: number; map: TextureMap | null };
  roughness?: number;
  index?: number;
  eta?: Vec3;
  kappa?: Vec3;
}

export interface Picture {
  width: number;
  height: number;
  channels: number;
  /** Linear values, row 0 above. */
  values: Float32Array;
}

export interface SceneData {
  positions: Float32Array;
  normals: Float32Array | null;
  coordinates: Float32Array | null;
  emissionCoordinates: Float32Array | null;
  colours: Float32Array | null;
  triangles: Uint32Array;
  /** Index of the material of each triangle. */
  triangleMaterials: Uint32Array;
  spheres: { center_m: Vec3; radius_m: number; material: number }[];
  lights: { position_m: Vec3; intensity: Vec3 }[];
  materials: MaterialFacts[];
  textures: Picture[];
  environment: { radiance: Vec3; texture: number | null; rotation_rad: number } | null;
  lower: Vec3;
  upper: Vec3;
}

const magic = 'STURMVS1';
const kinds = { f32: Float32Array, u32: Uint32Array, u16: Uint16Array, u8: Uint8Array } as const;
type Numbers = Float32Array | Uint32Array | Uint16Array | Uint8Array;
interface Place { at: number; type: keyof typeof kinds; components: number; count: number }

function refuse(what: string): never {
  throw new Error(`The scene of this page cannot be read: ${what}.`);
}

class Reader {
  constructor(private readonly bytes: ArrayBuffer, private readonly first: number) {}

  array(place: Place | null, name: string, components: number, type?: keyof typeof kinds): Numbers | null {
    if (place === null || place === undefined) return null;
    const Kind = kinds[place.type];
    if (!Kind || (type && place.type !== type)) refuse(`${name} has the type ${String(place.type)}`);
    if (place.components !== components) refuse(`${name} has ${place.components} components, expected ${components}`);
    const length = place.components * place.count, at = this.first + place.at;
    const fits = Number.isInteger(place.at) && place.at >= 0 && place.at % 4 === 0 && Number.isSafeInteger(length) && length >= 0 &&
      at + length * Kind.BYTES_PER_ELEMENT <= this.bytes.byteLength;
    if (!fits) refuse(`${name} reaches beyond the data`);
    return new Kind(this.bytes, at, length);
  }
}

function materialsOfTriangles(meshes: { material: number; first_triangle: number; triangle_count: number }[], triangles: number, materials: number): Uint32Array {
  const result = new Uint32Array(triangles);
  for (const mesh of meshes) {
    if (!(mesh.material >= 0 && mesh.material < materials)) refuse(`a mesh names the material ${mesh.material}`);
    if (!(mesh.first_triangle >= 0 && mesh.first_triangle + mesh.triangle_count <= triangles)) refuse('a mesh has more triangles than the scene');
    result.fill(mesh.material, mesh.first_triangle, mesh.first_triangle + mesh.triangle_count);
  }
  return result;
}

function pictureOf(reader: Reader, t: { width: number; height: number; channels: number; texels: Place; table: Place | null }, k: number): Picture {
  const texels = reader.array(t.texels, `texture ${k}`, t.channels) ?? refuse(`texture ${k} has no texels`);
  if (texels.length !== t.width * t.height * t.channels) refuse(`texture ${k} does not have ${t.width} times ${t.height} texels`);
  const table = reader.array(t.table, `table of texture ${k}`, 1, 'f32');
  const values = table ? Float32Array.from(texels, (i) => table[i] ?? refuse(`texture ${k} names a value beyond its table`)) : Float32Array.from(texels);
  return { width: t.width, height: t.height, channels: t.channels, values };
}

/** Throws an Error that says what is wrong. */
export function readScene(bytes: ArrayBuffer): SceneData {
  if (bytes.byteLength < 12 || new TextDecoder().decode(new Uint8Array(bytes, 0, 8)) !== magic) refuse(`it does not begin with ${magic}`);
  const length = new DataView(bytes).getUint32(8, true);
  if (length % 4 !== 0 || 12 + length > bytes.byteLength) refuse('its header is longer than the file');
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 12, length)));
  if (header.format !== 'sturm.viewer_scene/1') refuse(`its format is ${String(header.format)}`);
  const reader = new Reader(bytes, 12 + length);
  const floats = (key: string, components: number) => reader.array(header[key], key, components, 'f32') as Float32Array | null;
  const positions = floats('positions', 3) ?? new Float32Array(0);
  const triangles = (reader.array(header.triangles, 'triangles', 3, 'u32') as Uint32Array | null) ?? new Uint32Array(0);
  if (triangles.some((i) => 3 * i >= positions.length)) refuse('a triangle names a vertex that is not there');
  return {
    positions,
    normals: floats('normals', 3),
    coordinates: floats('texture_coordinates', 2),
    emissionCoordinates: floats('emission_coordinates', 2),
    colours: floats('colours', 4),
    triangles,
    triangleMaterials: materialsOfTriangles(header.meshes, triangles.length / 3, header.materials.length),
    spheres: header.spheres,
    lights: header.lights,
    materials: header.materials,
    textures: header.textures.map((t: Parameters<typeof pictureOf>[1], k: number) => pictureOf(reader, t, k)),
    environment: header.environment,
    lower: header.bounds_m.lower,
    upper: header.bounds_m.upper,
  };
}
