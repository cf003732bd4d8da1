/** A USD scene as three's objects: its layers as one (layers.ts), composed by three. */
import { DoubleSide, LinearSRGBColorSpace, type LoadingManager, type Mesh, type MeshPhysicalMaterial, type Object3D } from 'three';
import { USDComposer } from 'three/examples/jsm/loaders/usd/USDComposer.js';
import { unstated } from '../materials_of_model';
import { type FindFile, Layers } from './layers';
import { numbersOf, specType, type Specs } from './specs';
import { asOneMatrixEach } from './transforms';

export interface UsdScene {
  /** In metres, y up. */
  root: Object3D;
  /** Once its pictures have arrived. */
  settled: Promise<unknown>;
  /** Files that it names and that are not there. */
  missing: string[];
  /** Sentences on what is left out or taken otherwise. */
  notes: string[];
}

/** As three's ImageLoader. */
export interface UsdPictures { load(url: string, onLoad: (image: unknown) => void, onProgress: unknown, onError: () => void): void }

const drawn = /^(?:|Xform|Scope|Mesh|GeomSubset|Material|Shader|NodeGraph|SkelRoot|Skeleton|SkelAnimation|BlendShape|Camera|Cube|Sphere|Cylinder|Cone|Capsule|.*Light|Backdrop|.*Settings|.*Product|.*Var)$/;
const picture = /\.(?:png|jpe?g|webp|avif|gif|bmp)$/i;

const primsOf = (specs: Specs) => Object.entries(specs).filter(([path, spec]) => spec.specType === specType.prim && path !== '/');
const stated = (specs: Specs, path: string, name: string) => specs[`${path}.${name}`]?.fields.default;

function counted(words: string[]): string {
  const counts = new Map<string, number>();
  for (const word of words) counts.set(word, (counts.get(word) ?? 0) + 1);
  return Array.from(counts, ([word, count]) => `${word} (${count})`).join(', ');
}

/** Takes prims away with all that they hold. */
function without(specs: Specs, prims: string[]): void {
  if (prims.length === 0) return;
  const gone = new Set(prims);
  for (const path of Object.keys(specs)) {
    const [prim = ''] = path.split('.');
    for (let at = prim; at; at = at.slice(0, at.lastIndexOf('/'))) if (gone.has(at)) delete specs[path];
  }
}

/** What is no part of a picture: abstract, switched off, hidden, or meant for a modeller. */
function leaveOutUndrawn(specs: Specs, notes: string[]): void {
  const abstract: string[] = [], hidden: string[] = [], unknown: string[] = [], kinds: string[] = [];
  for (const [path, { fields }] of primsOf(specs)) {
    const purpose = stated(specs, path, 'purpose');
    if (fields.specifier !== 'def' || fields.active === false) abstract.push(path);
    else if (stated(specs, path, 'visibility') === 'invisible' || purpose === 'proxy' || purpose === 'guide') hidden.push(path);
    else if (!drawn.test(fields.typeName ?? '')) {
      unknown.push(path);
      kinds.push(fields.typeName ?? '');
    }
  }
  without(specs, [...abstract, ...hidden, ...unknown]);
  if (hidden.length > 0) notes.push(`Hidden objects, proxies and guides are left out (${hidden.length}).`);
  if (kinds.length > 0) notes.push(`Objects of these kinds are left out: ${counted(kinds)}.`);
}

/** Values that USD gives to what a file does not state, and three otherwise. */
function stateDefaults(specs: Specs, notes: string[]): void {
  const root = specs['/']?.fields;
  if (root && root.metersPerUnit === undefined) {
    root.metersPerUnit = 0.01;
    notes.push('The file states no unit: it is taken in centimetres, as USD says.');
  }
  for (const [path, { fields }] of primsOf(specs)) {
    if (fields.typeName !== 'Shader' || stated(specs, path, 'info:id') !== 'UsdPreviewSurface') continue;
    for (const [name, value] of [['diffuseColor', [0.18, 0.18, 0.18]], ['roughness', 0.5]] as const) {
      const at = `${path}.inputs:${name}`, own = specs[at]?.fields;
      if (own?.default === undefined && !own?.connectionPaths?.length) specs[at] = { specType: specType.attribute, fields: { ...own, default: value } };
    }
  }
}

function noteOthers(specs: Specs, notes: string[]): void {
  const prims = primsOf(specs), count = (is: (path: string, typeName: string) => boolean) => prims.filter(([path, { fields }]) => is(path, fields.typeName ?? '')).length;
  const smooth = count((path, type) => type === 'Mesh' && (stated(specs, path, 'subdivisionScheme') ?? 'catmullClark') !== 'none');
  const domes = count((_, type) => type === 'DomeLight'), moving = Object.values(specs).filter(({ fields }) => fields.moves).length, arcs = prims.filter(([, { fields }]) => fields.references !== undefined || fields.payload !== undefined).length;
  if (smooth > 0) notes.push(`Of subdivision surfaces the cage is drawn (${smooth}).`);
  if (domes > 0) notes.push(`Surroundings of the file are left out (${domes}).`);
  if (moving > 0) notes.push(`What moves stands as at the first moment that is stated (${moving} properties).`);
  if (arcs > 0) notes.push(`References of a binary layer are not followed (${arcs}).`);
}

/** Pictures by their keys, as the composer looks for them. */
function picturesOf(specs: Specs, layers: Layers, notes: string[]): Record<string, Uint8Array> {
  const pictures: Record<string, Uint8Array> = {}, others = new Set<string>();
  for (const [path, { specType: kind, fields }] of Object.entries(specs)) {
    if (kind !== specType.attribute || fields.typeName !== 'asset' || !path.endsWith('.inputs:file') || typeof fields.default !== 'string') continue;
    if (!picture.test(fields.default)) {
      others.add(fields.default);
      delete fields.default;
      continue;
    }
    const bytes = layers.find(fields.default);
    if (bytes) pictures[fields.default] = new Uint8Array(bytes);
  }
  if (others.size > 0) notes.push(`Pictures of kinds that are not read are left out: ${[...others].join(', ')}.`);
  return pictures;
}

/** Colours of objects by their paths, taken away: three would give them to white materials. */
function takeColours(specs: Specs, notes: string[]): Map<string, number[]> {
  const colours = new Map<string, number[]>(), name = '.primvars:displayColor';
  for (const [path, { fields }] of Object.entries(specs)) {
    if (!path.endsWith(name)) continue;
    const values = numbersOf(fields.default);
    if (values.length >= 3) colours.set(path.slice(0, -name.length), values);
    delete specs[path];
  }
  const several = Array.from(colours.values()).filter((values) => values.length > 3).length;
  if (several > 0) notes.push(`Of the colours of vertices only the first counts (${several} objects).`);
  return colours;
}

/**
 * Three's composer, with names for materials and the channels of their textures (`userData.roughnessChannel`, `.metalnessChannel`); what has no
 * material is matt, with the object's colour.
 */
class Composer extends USDComposer {
  constructor(manager: LoadingManager, private readonly colours: Map<string, number[]>, private readonly specs: Specs) {
    super(manager);
  }

  override _applyMaterial(material: MeshPhysicalMaterial, path: string): void {
    super._applyMaterial(material, path);
    material.name = path.split('/').pop() ?? '';
  }

  override _applyPreviewSurface(material: MeshPhysicalMaterial, shader: string): void {
    super._applyPreviewSurface(material, shader);
    for (const [name, input] of [['roughnessChannel', 'roughness'], ['metalnessChannel', 'metallic']] as const) {
      const output = this.specs[`${shader}.inputs:${input}`]?.fields.connectionPaths?.[0]?.split('.outputs:')[1], channel = ['r', 'g', 'b'].indexOf(output ?? '');
      if (channel >= 0) material.userData[name] = channel;
    }
  }

  override _buildMesh(path: string, spec: unknown): Mesh | null {
    const mesh = super._buildMesh(path, spec), bends = ['normals', 'primvars:normals'].some((name) => stated(this.specs, path, name) !== undefined);
    // Three smooths every mesh that states no normals.
    if (!bends && stated(this.specs, path, 'subdivisionScheme') === 'none') mesh?.geometry.deleteAttribute('normal');
    return this.coloured(path, mesh);
  }

  override _buildGeomPrimitive(path: string, spec: unknown, typeName: string): Mesh | null {
    return this.coloured(path, super._buildGeomPrimitive(path, spec, typeName));
  }

  private coloured(path: string, mesh: Mesh | null): Mesh | null {
    const [r = 0, g = 0, b = 0] = this.colours.get(path) ?? unstated.albedo;
    for (const material of [(mesh?.material ?? []) as MeshPhysicalMaterial | MeshPhysicalMaterial[]].flat()) {
      material.side = DoubleSide;
      if (material.name === '') material.color.setRGB(r, g, b, LinearSRGBColorSpace);
    }
    return mesh;
  }
}

/**
 * `key`: its file, `find`: other files by keys relative to where that lies, `pictures`: what reads pictures where there is no browser.
 * Throws an Error that says what is wrong.
 */
export function readUsd(key: string, bytes: ArrayBuffer, find: FindFile, manager: LoadingManager, pictures?: UsdPictures): UsdScene {
  const layers = new Layers(key, bytes, find), specs = layers.scene(), notes: string[] = [];
  leaveOutUndrawn(specs, notes);
  stateDefaults(specs, notes);
  asOneMatrixEach(specs);
  noteOthers(specs, notes);
  const composer = new Composer(manager, takeColours(specs, notes), specs);
  if (pictures) composer.imageLoader = pictures;
  const root = composer.compose({ specsByPath: specs }, picturesOf(specs, layers, notes));
  return { root, settled: Promise.all(composer.texturePromises), missing: [...layers.missing], notes };
}
