/** The objects of three's loaders as one scene of the page: all in their places, in metres. */
import { InstancedMesh, Matrix3, Matrix4, Vector3, type BufferAttribute, type BufferGeometry, type Material, type Mesh, type Object3D, type SkinnedMesh } from 'three';
import type { SceneData, Vec3 } from '../scene_file';
import { mostTriangles } from './limits';
import type { MaterialsOfModel } from './materials_of_model';

interface Part { positions: Float32Array; normals: Float32Array; coordinates: Float32Array; emission: Float32Array; colours: Float32Array; triangles: number[]; materials: number[]; bends: boolean; coloured: boolean; mapped: boolean }

const nameOf = (object: Object3D) => object.name || 'without a name';

/** Positions where skins and morph targets put them. */
export function posed(mesh: Mesh): BufferGeometry {
  const geometry = mesh.geometry;
  if (!(mesh as SkinnedMesh).isSkinnedMesh && !geometry.morphAttributes.position) return geometry;
  const still = geometry.clone(), place = still.getAttribute('position'), at = new Vector3();
  const positions = new Float32Array(3 * place.count);
  for (let i = 0; i < place.count; ++i) mesh.getVertexPosition(i, at).toArray(positions, 3 * i);
  still.setAttribute('position', new (place.constructor as typeof BufferAttribute)(positions, 3));
  still.computeVertexNormals();
  return still;
}

/** Two numbers a vertex of the texture coordinates that a map uses, running upwards. */
function coordinatesOf(geometry: BufferGeometry, channel: number, flipped: boolean): Float32Array {
  const uv = geometry.getAttribute(channel === 0 ? 'uv' : `uv${channel}`), count = geometry.getAttribute('position').count, result = new Float32Array(2 * count);
  if (!uv) return result;
  for (let i = 0; i < count; ++i) result.set([uv.getX(i), flipped ? uv.getY(i) : 1 - uv.getY(i)], 2 * i);
  return result;
}

/** Three vertices a triangle, and the number of its material in the mesh. */
export function facesOf(mesh: Mesh, geometry: BufferGeometry): { triangles: number[]; materials: number[] } {
  const count = geometry.getAttribute('position').count, index = geometry.getIndex(), corners = index ? index.count : count;
  const groups = Array.isArray(mesh.material) ? geometry.groups : [{ start: 0, count: corners, materialIndex: 0 }];
  const triangles: number[] = [], materials: number[] = [];
  for (const group of groups)
    for (let k = group.start; k + 2 < Math.min(corners, group.start + group.count); k += 3) {
      for (let c = 0; c < 3; ++c) {
        const vertex = index ? index.getX(k + c) : k + c;
        if (!(vertex < count)) throw new Error(`a triangle of the mesh ${nameOf(mesh)} names the vertex ${vertex} of ${count}`);
        triangles.push(vertex);
      }
      materials.push(group.materialIndex ?? 0);
    }
  return { triangles, materials };
}

function placed(mesh: Mesh, geometry: BufferGeometry, world: Matrix4, materials: MaterialsOfModel): Part {
  const place = geometry.getAttribute('position'), normal = geometry.getAttribute('normal'), colour = geometry.getAttribute('color'), { count } = place;
  const own = (Array.isArray(mesh.material) ? mesh.material : [mesh.material]) as (Material & { map?: { channel: number; flipY: boolean } | null; emissiveMap?: { channel: number; flipY: boolean } | null; flatShading?: boolean })[];
  const faces = facesOf(mesh, geometry), numbers = own.map((m) => materials.numberOf(m)), map = own.find((m) => m.map)?.map, glow = own.find((m) => m.emissiveMap)?.emissiveMap;
  const part: Part = {
    positions: new Float32Array(3 * count), normals: new Float32Array(3 * count), colours: new Float32Array(4 * count).fill(1), coordinates: coordinatesOf(geometry, map?.channel ?? 0, map?.flipY ?? true),
    emission: coordinatesOf(geometry, glow?.channel ?? map?.channel ?? 0, glow?.flipY ?? map?.flipY ?? true),
    triangles: faces.triangles, materials: faces.materials.map((k) => numbers[k] ?? numbers[0] ?? 0), bends: !!normal && !own.some((m) => m.flatShading), coloured: !!colour && own.some((m) => m.vertexColors), mapped: !!(map ?? glow),
  };
  const at = new Vector3(), turned = new Matrix3().getNormalMatrix(world);
  for (let i = 0; i < count; ++i) {
    at.fromBufferAttribute(place as BufferAttribute, i).applyMatrix4(world).toArray(part.positions, 3 * i);
    if (part.bends) at.fromBufferAttribute(normal as BufferAttribute, i).applyMatrix3(turned).normalize().toArray(part.normals, 3 * i);
    if (part.coloured) for (let c = 0; c < 3; ++c) part.colours[4 * i + c] = Math.min(1, Math.max(0, colour.getComponent(i, c)));
  }
  if (part.normals.some((x) => Number.isNaN(x))) part.bends = false;
  if (!part.bends) part.normals.fill(0);
  const wrong = part.positions.findIndex((x) => !Number.isFinite(x) || Math.abs(x) > 1e6);
  if (wrong >= 0) throw new Error(`the vertex ${Math.floor(wrong / 3)} of the mesh ${nameOf(mesh)} lies at ${part.positions[wrong]}, expected a place within a million metres`);
  // A node that mirrors turns faces about.
  if (world.determinant() < 0) for (let k = 0; k < part.triangles.length; k += 3) [part.triangles[k + 1], part.triangles[k + 2]] = [part.triangles[k + 2] ?? 0, part.triangles[k + 1] ?? 0];
  return part;
}

function partsOf(mesh: Mesh, materials: MaterialsOfModel): Part[] {
  const geometry = posed(mesh);
  if (!geometry.getAttribute('position')) return [];
  if (!(mesh instanceof InstancedMesh)) return [placed(mesh, geometry, mesh.matrixWorld, materials)];
  return Array.from({ length: mesh.count }, (_, k) => {
    const own = new Matrix4();
    mesh.getMatrixAt(k, own);
    return placed(mesh, geometry, own.premultiply(mesh.matrixWorld), materials);
  });
}

function joined(parts: Part[], key: 'positions' | 'normals' | 'coordinates' | 'emission' | 'colours'): Float32Array {
  const result = new Float32Array(parts.reduce((sum, part) => sum + part[key].length, 0));
  let at = 0;
  for (const part of parts) {
    result.set(part[key], at);
    at += part[key].length;
  }
  return result;
}

function bounds(positions: Float32Array, triangles: Uint32Array): { lower: Vec3; upper: Vec3 } {
  const lower: Vec3 = [Infinity, Infinity, Infinity], upper: Vec3 = [-Infinity, -Infinity, -Infinity];
  for (const vertex of triangles)
    for (let c = 0; c < 3; ++c) {
      const x = positions[3 * vertex + c] ?? 0;
      lower[c] = Math.min(lower[c] ?? x, x);
      upper[c] = Math.max(upper[c] ?? x, x);
    }
  return { lower, upper };
}

/** Without textures, lights and surroundings. Throws where there is nothing to see or too much. */
export function sceneOfModel(root: Object3D, materials: MaterialsOfModel): Omit<SceneData, 'materials' | 'textures' | 'lights' | 'environment'> {
  const parts: Part[] = [];
  let total = 0;
  root.updateMatrixWorld(true);
  root.traverseVisible((object) => {
    if (!(object as Mesh).isMesh) return;
    for (const part of partsOf(object as Mesh, materials)) {
      total += part.triangles.length / 3;
      if (total > mostTriangles) throw new Error(`it has more than ${mostTriangles} triangles`);
      parts.push(part);
    }
  });
  if (total === 0) throw new Error('there is no triangle in it');
  const triangles = new Uint32Array(3 * total), triangleMaterials = new Uint32Array(total);
  let vertex = 0, triangle = 0;
  for (const part of parts) {
    triangles.set(part.triangles.map((v) => v + vertex), 3 * triangle);
    triangleMaterials.set(part.materials, triangle);
    vertex += part.positions.length / 3;
    triangle += part.materials.length;
  }
  const positions = joined(parts, 'positions'), mapped = parts.some((p) => p.mapped);
  return {
    positions, normals: parts.some((p) => p.bends) ? joined(parts, 'normals') : null, coordinates: mapped ? joined(parts, 'coordinates') : null, emissionCoordinates: mapped ? joined(parts, 'emission') : null,
    colours: parts.some((p) => p.coloured) ? joined(parts, 'colours') : null, triangles, triangleMaterials, spheres: [], ...bounds(positions, triangles),
  };
}
