/** Materials of a model as those of the scene, by the rules of docs/formats/scene.md. */
import { DoubleSide, type Material, type MeshPhysicalMaterial, type Texture } from 'three';
import type { MaterialFacts, Vec3 } from '../scene_file';
import { meanOf, PicturesOfModel } from './pictures_of_model';

/** Numbers of a material library that three's reader has bent: reflectances are linear here. */
export interface StatedColours { albedo: Vec3; emission: Vec3 }

/** Of a surface without a material. */
export const unstated: StatedColours = { albedo: [0.6, 0.6, 0.6], emission: [0, 0, 0] };

type Known = Partial<MeshPhysicalMaterial> & Material;

const leastRoughness = 0.01;
const otherMaps = { normalMap: 'the texture of its normals', bumpMap: 'its bump map', aoMap: 'its occlusion', displacementMap: 'its displacement', specularMap: 'its highlights', alphaMap: 'the texture of its opacity' } as const;
const otherNumbers = { transmission: 'its transmission', clearcoat: 'its clear coat', iridescence: 'its iridescence', anisotropy: 'its anisotropy', sheen: 'its sheen' } as const;

function metal(reflectance: Vec3): Pick<MaterialFacts, 'eta' | 'kappa'> {
  return { eta: [1, 1, 1], kappa: reflectance.map((r) => 2 * Math.sqrt(Math.min(0.999, r) / (1 - Math.min(0.999, r)))) as Vec3 };
}

export class MaterialsOfModel {
  readonly facts: MaterialFacts[] = [];
  readonly notes = new Set<string>();
  private readonly numbers = new Map<Material, number>();

  constructor(private readonly pictures: PicturesOfModel, private readonly stated: (name: string) => StatedColours | null) {}

  numberOf(material: Material): number {
    const known = this.numbers.get(material);
    if (known !== undefined) return known;
    this.numbers.set(material, this.facts.length);
    this.facts.push(this.factsOf(material as Known));
    return this.facts.length - 1;
  }

  private factsOf(m: Known): MaterialFacts {
    const stated = this.stated(m.name), name = m.name || `material ${this.facts.length}`, lit = 'metalness' in m;
    const albedo = stated?.albedo ?? (m.color ? (m.color.toArray() as Vec3) : [1, 1, 1]);
    const emission = stated?.emission ?? (m.emissive ? (m.emissive.clone().multiplyScalar(m.emissiveIntensity ?? 1).toArray() as Vec3) : [0, 0, 0]);
    const facts: MaterialFacts = {
      name, type: 'diffuse', albedo, emission, emits_behind: m.side === DoubleSide, nearest: PicturesOfModel.isNearest(m.map ?? m.emissiveMap ?? null),
      albedo_map: this.pictures.map(m.map ?? null, 'colour'), emission_map: this.pictures.map(m.emissiveMap ?? null, 'colour'), opacity: this.opacityOf(m, name),
    };
    this.noteOthers(m, name);
    return lit && !stated ? this.withSurface(facts, m) : facts;
  }

  /** Metallic-roughness: a metal, a coat over a matt base, or a matt surface. */
  private withSurface(facts: MaterialFacts, m: Known): MaterialFacts {
    let metalness = m.metalness ?? 0, roughness = m.roughness ?? 1;
    const { roughnessChannel = 1, metalnessChannel = 2 } = (m.userData ?? {}) as { roughnessChannel?: 0 | 1 | 2; metalnessChannel?: 0 | 1 | 2 };
    if (m.roughnessMap) roughness *= meanOf(m.roughnessMap, false)[roughnessChannel];
    if (m.metalnessMap) metalness *= meanOf(m.metalnessMap, false)[metalnessChannel];
    if (m.roughnessMap ?? m.metalnessMap) this.notes.add(`Of the metallic-roughness texture of "${facts.name}" only the mean counts.`);
    if (metalness > 0 && metalness < 1) this.notes.add(`"${facts.name}" is a mixture of metal and dielectric, drawn as the nearer of the two.`);
    if (roughness < leastRoughness) roughness = 0;
    if (metalness < 0.5) return roughness >= 1 ? facts : { ...facts, type: 'plastic', roughness, index: m.ior ?? 1.5 };
    const mean = m.map ? meanOf(m.map, true) : [1, 1, 1];
    if (m.map) this.notes.add(`The metal "${facts.name}" has the mean of its texture.`);
    return { ...facts, type: 'conductor', roughness, ...metal(facts.albedo.map((a, k) => a * (mean[k] ?? 1)) as Vec3) };
  }

  private opacityOf(m: Known, name: string): MaterialFacts['opacity'] {
    const mode = (m.alphaTest ?? 0) > 0 ? 'mask' : m.transparent ? 'blend' : 'opaque';
    if (mode !== 'opaque') this.notes.add(`The material "${name}" lets rays pass in parts and is drawn opaque.`);
    return { mode, factor: m.opacity ?? 1, cutoff: m.alphaTest || 0.5, map: mode === 'opaque' ? null : this.pictures.map(m.map ?? null, 'alpha') };
  }

  private noteOthers(m: Known, name: string): void {
    const out: string[] = [];
    for (const [key, words] of Object.entries(otherMaps)) if (m[key as keyof Known] as Texture | null) out.push(words);
    for (const [key, words] of Object.entries(otherNumbers)) if (((m[key as keyof Known] as number | undefined) ?? 0) > 0) out.push(words);
    if (out.length > 0) this.notes.add(`Of the material "${name}" ${out.join(', ')} ${out.length > 1 ? 'are' : 'is'} left out.`);
  }
}
