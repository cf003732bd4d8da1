/** Three's objects as a binary glTF file. */
import { type Accessor, Document, type Material, NodeIO, type Primitive, type Texture as GltfTexture } from '@gltf-transform/core';
import { KHRMaterialsEmissiveStrength, KHRMaterialsIOR } from '@gltf-transform/extensions';
import { type BufferAttribute, type BufferGeometry, ClampToEdgeWrapping, type Mesh, type MeshPhysicalMaterial, MirroredRepeatWrapping, type Object3D, type Texture, Vector2 } from 'three';
import { facesOf, posed } from '../src/opening/scene_of_model';
import { type KeptPicture, meanOf } from './kept_pictures';

const clampToEdge = 33071, mirroredRepeat = 33648, repeat = 10497;
const wrapOf = (wrapping: number) => (wrapping === ClampToEdgeWrapping ? clampToEdge : wrapping === MirroredRepeatWrapping ? mirroredRepeat : repeat);

/** Coordinates that a map uses, turned, scaled and moved as it says; rows of a glTF picture run downwards. */
function coordinatesOf(geometry: BufferGeometry, map: Texture): Float32Array {
  const uv = geometry.getAttribute(map.channel === 0 ? 'uv' : `uv${map.channel}`) ?? geometry.getAttribute('uv'), { count } = geometry.getAttribute('position'), result = new Float32Array(2 * count), at = new Vector2();
  map.updateMatrix();
  for (let i = 0; uv && i < count; ++i) {
    at.fromBufferAttribute(uv as BufferAttribute, i).applyMatrix3(map.matrix);
    result.set([at.x, 1 - at.y], 2 * i);
  }
  return result;
}

export class GlbOfScene {
  readonly notes = new Set<string>();
  triangles = 0;
  private readonly document = new Document();
  private readonly buffer = this.document.createBuffer();
  private readonly scene = this.document.createScene();
  private readonly strength = this.document.createExtension(KHRMaterialsEmissiveStrength);
  private readonly index = this.document.createExtension(KHRMaterialsIOR);
  private readonly materials = new Map<string, Material>();
  private readonly pictures = new Map<KeptPicture, GltfTexture>();

  add(root: Object3D): void {
    root.updateMatrixWorld(true);
    root.traverse((object) => {
      if ((object as Mesh).isMesh) this.addMesh(object as Mesh);
    });
  }

  async bytes(): Promise<Uint8Array> {
    return await new NodeIO().registerExtensions([KHRMaterialsEmissiveStrength, KHRMaterialsIOR]).writeBinary(this.document);
  }

  private addMesh(mesh: Mesh): void {
    const geometry = posed(mesh).clone().applyMatrix4(mesh.matrixWorld), own = [mesh.material as MeshPhysicalMaterial | MeshPhysicalMaterial[]].flat();
    if (!geometry.getAttribute('position')) return;
    const { triangles, materials } = facesOf(mesh, geometry), result = this.document.createMesh(mesh.name);
    // A place that mirrors turns faces about.
    if (mesh.matrixWorld.determinant() < 0) for (const list of [triangles, materials]) list.reverse();
    own.forEach((material, k) => {
      const corners = triangles.filter((_, corner) => (materials[Math.floor(corner / 3)] ?? 0) === k);
      if (corners.length > 0) result.addPrimitive(this.primitive(geometry, material, corners));
      this.triangles += corners.length / 3;
    });
    if (result.listPrimitives().length > 0) this.scene.addChild(this.document.createNode(mesh.name).setMesh(result));
  }

  private primitive(geometry: BufferGeometry, material: MeshPhysicalMaterial, corners: number[]): Primitive {
    const result = this.document.createPrimitive().setIndices(this.accessor('SCALAR', Uint32Array.from(corners))), normal = geometry.getAttribute('normal');
    result.setAttribute('POSITION', this.accessor('VEC3', Float32Array.from(geometry.getAttribute('position').array)));
    if (normal) result.setAttribute('NORMAL', this.accessor('VEC3', Float32Array.from(normal.array)));
    if (material.map) result.setAttribute('TEXCOORD_0', this.accessor('VEC2', coordinatesOf(geometry, material.map)));
    const glow = material.emissiveMap;
    if (glow) result.setAttribute(material.map ? 'TEXCOORD_1' : 'TEXCOORD_0', this.accessor('VEC2', coordinatesOf(geometry, glow)));
    return result.setMaterial(this.materialOf(material));
  }

  private accessor(type: 'SCALAR' | 'VEC2' | 'VEC3', values: Float32Array | Uint32Array): Accessor {
    return this.document.createAccessor().setType(type).setArray(values as Float32Array<ArrayBuffer>).setBuffer(this.buffer);
  }

  /** The composer makes a material for each mesh; those of one name and look are one. */
  private materialOf(m: MeshPhysicalMaterial): Material {
    const key = JSON.stringify([m.name, m.color, m.emissive, m.emissiveIntensity, m.opacity, m.roughness, m.metalness, m.map?.uuid, m.emissiveMap?.uuid]), known = this.materials.get(key);
    if (known) return known;
    const made = this.document.createMaterial(m.name).setDoubleSided(true), mode = m.alphaTest > 0 ? 'MASK' : m.transparent ? 'BLEND' : 'OPAQUE';
    made.setBaseColorFactor([m.color.r, m.color.g, m.color.b, m.opacity]).setAlphaMode(mode).setAlphaCutoff(m.alphaTest || 0.5);
    this.setSurface(made, m);
    if (m.map) this.setMap(made.setBaseColorTexture(this.picture(m.map)).getBaseColorTextureInfo(), m.map, 0);
    if (m.emissiveMap) this.setMap(made.setEmissiveTexture(this.picture(m.emissiveMap)).getEmissiveTextureInfo(), m.emissiveMap, m.map ? 1 : 0);
    const radiance = [m.emissive.r, m.emissive.g, m.emissive.b].map((x) => x * m.emissiveIntensity), most = Math.max(1, ...radiance);
    made.setEmissiveFactor(radiance.map((x) => x / most) as [number, number, number]);
    if (most > 1) made.setExtension('KHR_materials_emissive_strength', this.strength.createEmissiveStrength().setEmissiveStrength(most));
    this.materials.set(key, made);
    return made;
  }

  /** Means in the place of textures: the program draws no others. */
  private setSurface(made: Material, m: MeshPhysicalMaterial): void {
    const { name } = m;
    const { roughnessChannel = 1, metalnessChannel = 2 } = m.userData as { roughnessChannel?: number; metalnessChannel?: number };
    const mean = (map: Texture | null, channel: number) => (map ? meanOf(map.image as KeptPicture)[channel] ?? 1 : 1);
    made.setRoughnessFactor(m.roughness * mean(m.roughnessMap, roughnessChannel)).setMetallicFactor(m.metalness * mean(m.metalnessMap, metalnessChannel));
    if (m.roughnessMap ?? m.metalnessMap) this.notes.add(`Of the textures of roughness and metal of "${name}" only the means count.`);
    if (m.normalMap ?? m.aoMap ?? m.specularColorMap) this.notes.add(`Textures of normals, occlusion and highlights of "${name}" are left out.`);
    if (m.ior !== 1.5) made.setExtension('KHR_materials_ior', this.index.createIOR().setIOR(m.ior));
  }

  private picture(map: Texture): GltfTexture {
    const picture = map.image as KeptPicture, known = this.pictures.get(picture);
    if (known) return known;
    const made = this.document.createTexture().setImage(new Uint8Array(picture.bytes)).setMimeType(picture.mimeType);
    this.pictures.set(picture, made);
    return made;
  }

  private setMap(info: ReturnType<Material['getBaseColorTextureInfo']>, map: Texture, channel: number): void {
    info?.setTexCoord(channel).setWrapS(wrapOf(map.wrapS)).setWrapT(wrapOf(map.wrapT));
  }
}
