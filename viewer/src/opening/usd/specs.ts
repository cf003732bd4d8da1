/** The specs of a USD layer by their paths, in the form that three's composer takes. */
export const specType = { attribute: 1, prim: 6, relationship: 8 } as const;

export interface Fields {
  typeName?: string;
  specifier?: 'def' | 'over' | 'class';
  /** Of an attribute: vectors and matrices without brackets, quaternions as x, y, z, w, files by their keys. */
  default?: unknown;
  connectionPaths?: string[];
  targetPaths?: string[];
  /** Prims that this one takes over, the strongest first. */
  arcs?: Arc[];
  /** Names of its sets of variants, and which variant of each it takes. */
  variantSetChildren?: string[];
  variantSelection?: Record<string, string>;
  [name: string]: unknown;
}

/** `file`: the key of a layer, null: this one. `prim`: a path in it, null: its default prim. */
export interface Arc { file: string | null; prim: string | null }
export interface Spec { specType: number; fields: Fields }
export type Specs = Record<string, Spec>;

export interface Layer {
  /** That of the root, '/', has upAxis, metersPerUnit and defaultPrim. */
  specs: Specs;
  /** Keys of weaker layers, the strongest first. */
  sublayers: string[];
}

/** Whether the path is that of the prim, of its properties or of what it holds. */
export function isWithin(path: string, prim: string): boolean {
  return path === prim || (path.startsWith(prim) && (path[prim.length] === '/' || path[prim.length] === '.'));
}

/** A layer's file by the name that another one states: relative to that one's folder. */
export function keyOf(name: string, layer: string): string {
  const parts = name.startsWith('/') ? [] : layer.split('/').slice(0, -1);
  for (const part of name.replaceAll('\\', '/').split('/'))
    if (part === '..' && parts.length > 0 && parts[parts.length - 1] !== '..') parts.pop();
    else if (part !== '.' && part !== '') parts.push(part);
  return (name.startsWith('/') ? '/' : '') + parts.join('/');
}

/** One number or a list of any kind. */
export function numbersOf(value: unknown): number[] {
  return typeof value === 'number' ? [value] : typeof value === 'object' && value !== null && 'length' in value ? (Array.from(value as ArrayLike<unknown>).flat(2) as number[]) : [];
}
