/** What a glTF file says of its own sizes and tree, held against what is there before a loader believes it. */
import { mostTriangles } from './limits';

interface Thing { [key: string]: unknown }

const componentBytes: Record<number, number> = { 5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4 };
const widths: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16 };
/** What three's loader reads, or may leave out without harm to shape and colour. */
const known = /^(KHR_materials_\w+|KHR_texture_transform|KHR_mesh_quantization|KHR_lights_punctual|EXT_mesh_gpu_instancing|EXT_texture_(webp|avif))$/;

export class GltfProblem extends Error {}

/** The JSON of a .gltf or .glb file and the length of the latter's own data. */
export function gltfDocument(bytes: ArrayBuffer): { document: Thing; ownBytes: number | null } {
  const view = new DataView(bytes), text = (from: number, length: number) => new TextDecoder().decode(new Uint8Array(bytes, from, length));
  if (bytes.byteLength < 12 || view.getUint32(0, true) !== 0x46546c67) return { document: parsed(text(0, bytes.byteLength)), ownBytes: null };
  const length = bytes.byteLength < 20 ? Infinity : view.getUint32(12, true);
  if (20 + length > bytes.byteLength) throw new GltfProblem('its first chunk reaches beyond the file');
  const second = 20 + length, own = second + 8 <= bytes.byteLength ? view.getUint32(second, true) : 0;
  if (own > 0 && second + 8 + own > bytes.byteLength) throw new GltfProblem('its second chunk reaches beyond the file');
  return { document: parsed(text(20, length)), ownBytes: own };
}

function parsed(text: string): Thing {
  try {
    const value: unknown = JSON.parse(text);
    if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as Thing;
  } catch {
    // Said below.
  }
  throw new GltfProblem('it holds no JSON object');
}

class Check {
  constructor(private readonly document: Thing, private readonly ownBytes: number | null, private readonly sizeOf: (uri: string) => number | null) {}

  private list(key: string): Thing[] {
    const value = this.document[key] ?? [];
    if (!Array.isArray(value)) throw new GltfProblem(`/${key} is no list`);
    return value as Thing[];
  }

  private count(value: unknown, where: string, otherwise?: number): number {
    const number = value ?? otherwise;
    if (typeof number !== 'number' || !Number.isSafeInteger(number) || number < 0) throw new GltfProblem(`${where} is ${JSON.stringify(value) ?? 'missing'}, expected a whole number from 0`);
    return number;
  }

  private member(key: string, index: unknown, where: string): Thing {
    return this.list(key)[this.count(index, where)] ?? this.none(`${where} names ${key}/${String(index)}, which is not there`);
  }

  private none(what: string): never {
    throw new GltfProblem(what);
  }

  run(): void {
    const version = (this.document.asset as Thing | undefined)?.version;
    if (!String(version).startsWith('2.')) this.none(`/asset/version is ${JSON.stringify(version) ?? 'missing'}, expected 2.0`);
    for (const name of this.list('extensionsRequired') as unknown as string[]) if (!known.test(name)) this.none(`it requires ${name}, which this page does not read`);
    this.list('buffers').forEach((buffer, k) => this.buffer(buffer, `/buffers/${k}`));
    this.list('bufferViews').forEach((view, k) => {
      const where = `/bufferViews/${k}`, buffer = this.member('buffers', view.buffer, `${where}/buffer`);
      if (this.count(view.byteOffset, `${where}/byteOffset`, 0) + this.count(view.byteLength, `${where}/byteLength`) > Number(buffer.byteLength)) this.none(`${where} reaches beyond its buffer`);
    });
    this.list('accessors').forEach((accessor, k) => this.accessor(accessor, `/accessors/${k}`));
    this.list('images').forEach((image) => { if (typeof image.uri === 'string') this.there(image.uri); });
    this.nodes();
  }

  private there(uri: string): number {
    return uri.startsWith('data:') ? Math.floor((3 * (uri.length - uri.indexOf(',') - 1)) / 4) : this.sizeOf(uri) ?? this.none(`it names the file ${decodeURIComponent(uri)}, which was not opened with it; open all of its files together`);
  }

  private buffer(buffer: Thing, where: string): void {
    const length = this.count(buffer.byteLength, `${where}/byteLength`);
    const there = typeof buffer.uri === 'string' ? this.there(buffer.uri) : this.ownBytes ?? this.none(`${where} has no uri`);
    // Base64 may end in signs that stand for nothing.
    if (length > there) this.none(`${where} has ${there} bytes, its byteLength says ${length}`);
  }

  private accessor(accessor: Thing, where: string): void {
    const count = this.count(accessor.count, `${where}/count`), size = componentBytes[accessor.componentType as number], width = widths[accessor.type as string];
    if (!size || !width) this.none(`${where} has no known type`);
    if (count > 4 * mostTriangles) this.none(`${where}/count is ${count}; this page takes up to ${4 * mostTriangles}`);
    const fits = (viewNumber: unknown, offset: unknown, elements: number, bytes: number, at: string) => {
      const view = this.member('bufferViews', viewNumber, at), stride = this.count(view.byteStride, at, bytes) || bytes;
      if (elements > 0 && this.count(offset, `${at}/byteOffset`, 0) + stride * (elements - 1) + bytes > Number(view.byteLength)) this.none(`${at} reaches beyond its bufferView`);
    };
    if (accessor.bufferView !== undefined) fits(accessor.bufferView, accessor.byteOffset, count, size * width, where);
    const sparse = accessor.sparse as { count?: unknown; indices?: Thing; values?: Thing } | undefined;
    if (!sparse) return;
    const some = this.count(sparse.count, `${where}/sparse/count`);
    if (some > count) this.none(`${where}/sparse/count is ${some}, more than ${count}`);
    fits(sparse.indices?.bufferView, sparse.indices?.byteOffset, some, componentBytes[sparse.indices?.componentType as number] ?? 4, `${where}/sparse/indices`);
    fits(sparse.values?.bufferView, sparse.values?.byteOffset, some, size * width, `${where}/sparse/values`);
  }

  /** Nodes form trees, and what they show together is not too much. */
  private nodes(): void {
    const nodes = this.list('nodes'), parents = new Array<number>(nodes.length).fill(-1);
    nodes.forEach((node, k) => {
      for (const child of (node.children ?? []) as number[]) {
        this.member('nodes', child, `/nodes/${k}/children`);
        if (parents[child] !== -1) this.none(`/nodes/${k} shows the node ${child}, which another one shows`);
        parents[child] = k;
      }
    });
    nodes.forEach((_, k) => {
      let steps = 0;
      for (let at = k; at !== -1; at = parents[at] ?? -1) if (++steps > nodes.length) this.none(`/nodes/${k} contains itself`);
    });
    let triangles = 0;
    nodes.forEach((node, k) => { if (node.mesh !== undefined) triangles += this.trianglesOf(this.member('meshes', node.mesh, `/nodes/${k}/mesh`)); });
    if (triangles > mostTriangles) this.none(`it has ${Math.round(triangles)} triangles; this page takes up to ${mostTriangles}`);
  }

  private trianglesOf(mesh: Thing): number {
    return ((mesh.primitives ?? []) as Thing[]).reduce((sum, primitive) => {
      const position = (primitive.attributes as Thing | undefined)?.POSITION;
      if (position === undefined) return sum;
      const vertices = this.member('accessors', primitive.indices ?? position, '/meshes').count as number;
      return sum + (primitive.mode === undefined || primitive.mode === 4 ? vertices / 3 : vertices);
    }, 0);
  }
}

/** Throws a GltfProblem. `sizeOf`: bytes of a file that was opened with it. */
export function checkGltf(bytes: ArrayBuffer, sizeOf: (uri: string) => number | null): Thing {
  const { document, ownBytes } = gltfDocument(bytes);
  new Check(document, ownBytes, sizeOf).run();
  return document;
}
