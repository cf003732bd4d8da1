/** Of three's files that its types leave out. */
declare module 'three/examples/jsm/loaders/usd/USDCParser.js' {
  export class USDCParser {
    parseData(bytes: ArrayBuffer): { specsByPath: unknown };
  }
}
declare module 'three/examples/jsm/loaders/usd/USDComposer.js' {
  import type { Group, LoadingManager, Mesh, MeshPhysicalMaterial } from 'three';
  export class USDComposer {
    constructor(manager: LoadingManager);
    imageLoader: unknown;
    texturePromises: Promise<void>[];
    compose(data: { specsByPath: unknown }, assets: Record<string, Uint8Array>): Group;
    _applyMaterial(material: MeshPhysicalMaterial, path: string): void;
    _applyPreviewSurface(material: MeshPhysicalMaterial, shader: string): void;
    _buildMesh(path: string, spec: unknown): Mesh | null;
    _buildGeomPrimitive(path: string, spec: unknown, typeName: string): Mesh | null;
  }
}
