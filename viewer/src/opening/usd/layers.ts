/** The layers of a USD scene, read when another one names them, and all of them as one. */
import { unzipSync } from 'three/examples/jsm/libs/fflate.module.js';
import { USDCParser } from 'three/examples/jsm/loaders/usd/USDCParser.js';
import { type Arc, isWithin, keyOf, type Layer, specType, type Spec, type Specs } from './specs';
import { usdaLayer } from './usda_layer';

/** Bytes of a file by its key, null: there is none. */
export type FindFile = (key: string) => ArrayBuffer | null;

const mostDepth = 50, mostSpecs = 2e6;

function begins(bytes: ArrayBuffer, text: string): boolean {
  return new TextDecoder('latin1').decode(bytes.slice(0, text.length)) === text;
}

/** Files of an archive by their names. Entries of a USDZ archive are stored as they are; one that is packed could unfold to any size. */
function unpacked(archive: ArrayBuffer): Map<string, ArrayBuffer> {
  const filter = ({ compression, size, originalSize }: { compression: number; size: number; originalSize: number }) => {
    if (compression !== 0 || size !== originalSize) throw new Error('its archive is compressed, which USDZ does not allow');
    return true;
  };
  return new Map(Object.entries(unzipSync(new Uint8Array(archive), { filter })).map(([name, entry]) => [name, entry.slice().buffer]));
}

/** What three reads of a binary layer, with names of files as keys. Its references are not read there. */
function crateLayer(bytes: ArrayBuffer, key: string): Layer {
  const { specsByPath } = new USDCParser().parseData(bytes) as { specsByPath: Specs };
  for (const { specType: kind, fields } of Object.values(specsByPath))
    if (kind === specType.prim) fields.specifier = (['def', 'over', 'class'] as const)[fields.specifier as unknown as number] ?? 'def';
    else {
      const { timeSamples } = fields as { timeSamples?: { values: unknown[] } };
      if (timeSamples) Object.assign(fields, { moves: true, default: fields.default ?? timeSamples.values[0], timeSamples: undefined });
      if (fields.typeName === 'asset' && typeof fields.default === 'string') fields.default = keyOf(fields.default, key);
    }
  return { specs: specsByPath, sublayers: [] };
}

export class Layers {
  /** Keys that were asked for and are not here. */
  readonly missing = new Set<string>();
  private readonly findOutside: FindFile;
  private readonly known = new Map<string, Specs>();
  /** The archive's, or the root alone. */
  private readonly files: Map<string, ArrayBuffer>;
  private readonly rootKey: string;
  private count = 0;

  /** What an archive holds names nothing outside of it. */
  constructor(key: string, bytes: ArrayBuffer, findOutside: FindFile) {
    const isArchive = begins(bytes, 'PK');
    this.files = isArchive ? unpacked(bytes) : new Map([[key, bytes]]);
    this.findOutside = isArchive ? () => null : findOutside;
    // The first file of an archive is its scene.
    this.rootKey = [...this.files.keys()][0] ?? key;
  }

  find(key: string): ArrayBuffer | null {
    const found = this.files.get(key) ?? this.findOutside(key);
    if (!found) this.missing.add(key);
    return found;
  }

  /** All that the root and its references say, with nothing left to follow. */
  scene(): Specs {
    const specs = copied(this.layer(this.rootKey)), waiting = Object.keys(specs).map((path) => ({ path, depth: 0 }));
    for (let k = 0; k < waiting.length; ++k) {
      const { path, depth } = waiting[k] as { path: string; depth: number };
      for (const grafted of this.takeVariants(specs, path)) waiting.push({ path: grafted, depth: depth + 1 });
      const arcs = specs[path]?.fields.arcs ?? [];
      if (arcs.length > 0 && depth > mostDepth) throw new Error(`its references are nested more than ${mostDepth} deep`);
      delete specs[path]?.fields.arcs;
      for (const arc of arcs) for (const grafted of this.graft(specs, path, arc)) waiting.push({ path: grafted, depth: depth + 1 });
    }
    return specs;
  }

  /** A layer over its sublayers; references to its own prims name it. */
  private layer(key: string): Specs {
    const known = this.known.get(key);
    if (known) return known;
    const specs = this.stack(key, []);
    for (const { fields } of Object.values(specs)) if (fields.arcs) fields.arcs = fields.arcs.map(({ file, prim }) => ({ file: file ?? key, prim }));
    this.known.set(key, specs);
    return specs;
  }

  private stack(key: string, above: string[]): Specs {
    if (above.includes(key)) throw new Error(`the layer ${key} contains itself`);
    const bytes = this.find(key);
    if (!bytes) return {};
    const { specs, sublayers } = this.read(key, bytes);
    for (const weaker of sublayers) this.over(specs, this.stack(weaker, [...above, key]), '', '');
    return specs;
  }

  private read(key: string, bytes: ArrayBuffer): Layer {
    try {
      return begins(bytes, 'PXR-USDC') ? crateLayer(bytes, key) : usdaLayer(new TextDecoder().decode(bytes), key);
    } catch (problem) {
      if (key === this.rootKey) throw problem;
      throw new Error(`in ${key}, ${(problem as Error).message}`);
    }
  }

  /** What the chosen variant of each of the prim's sets says, the first where none is chosen. */
  private takeVariants(specs: Specs, path: string): string[] {
    const fields = specs[path]?.fields, changed: string[] = [];
    for (const set of fields?.variantSetChildren ?? []) {
      const kinds = specs[`${path}/{${set}=}`]?.fields.variantChildren as string[] | undefined, chosen = fields?.variantSelection?.[set] ?? kinds?.[0];
      if (chosen !== undefined) changed.push(...this.over(specs, { ...specs }, `${path}/{${set}=${chosen}}`, path));
      for (const own of Object.keys(specs)) if (own.startsWith(`${path}/{${set}=`)) delete specs[own];
    }
    delete specs[path]?.fields.variantSetChildren;
    return changed;
  }

  private graft(specs: Specs, path: string, { file, prim }: Arc): string[] {
    const weaker = this.layer(file ?? this.rootKey), root = weaker['/']?.fields.defaultPrim as string | undefined;
    const source = prim ?? (root ? `/${root.replace(/^\//, '')}` : Object.keys(weaker).find((known) => /^\/[^/.]+$/.test(known)));
    return source ? this.over(specs, weaker, source, path) : [];
  }

  /** Puts what `weaker` says of the prim `source` (empty: of everything) under what `specs` says of `path`, and tells of which paths. */
  private over(specs: Specs, weaker: Specs, source: string, path: string): string[] {
    const moved = (own: string) => (source !== '' && isWithin(own, source) ? path + own.slice(source.length) : own), changed: string[] = [];
    for (const [own, spec] of Object.entries(weaker)) {
      if (source !== '' && !isWithin(own, source)) continue;
      const at = moved(own);
      specs[at] = merged(specs[at] ?? { specType: spec.specType, fields: {} }, spec, moved);
      changed.push(at);
    }
    this.count += changed.length;
    if (this.count > mostSpecs) throw new Error(`its references state more than ${mostSpecs} things`);
    return changed;
  }
}

function copied(specs: Specs): Specs {
  return Object.fromEntries(Object.entries(specs).map(([path, { specType: kind, fields }]) => [path, { specType: kind, fields: { ...fields } }]));
}

function merged(strong: Spec, weak: Spec, moved: (path: string) => string): Spec {
  const fields = { ...weak.fields, ...strong.fields };
  if (weak.specType === specType.prim) {
    fields.typeName = strong.fields.typeName || weak.fields.typeName;
    fields.specifier = strong.fields.specifier === 'over' || !strong.fields.specifier ? weak.fields.specifier : strong.fields.specifier;
    fields.arcs = [...(strong.fields.arcs ?? []), ...(weak.fields.arcs ?? [])];
    fields.variantSetChildren = [...new Set([...(strong.fields.variantSetChildren ?? []), ...(weak.fields.variantSetChildren ?? [])])];
    fields.variantSelection = { ...weak.fields.variantSelection, ...strong.fields.variantSelection };
  }
  for (const name of ['targetPaths', 'connectionPaths'] as const) if (!strong.fields[name] && weak.fields[name]) fields[name] = weak.fields[name].map(moved);
  return { specType: weak.specType, fields };
}
