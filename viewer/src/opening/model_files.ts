/** Files that were opened together, for three's loaders: each by its name, as a blob; nothing else can be reached. */
import { LoadingManager } from 'three';
import type { OpenedFile } from './opening_api';

const types: Record<string, string> = { png: 'image/png', jpg: 'image/jpeg', jpeg: 'image/jpeg', webp: 'image/webp', avif: 'image/avif', gif: 'image/gif', bmp: 'image/bmp' };

export function suffixOf(name: string): string {
  return /\.([^./\\]+)$/.exec(name)?.[1]?.toLowerCase() ?? '';
}

/** Without folders and escapes, in small letters. */
function plainName(uri: string): string {
  let name = uri;
  try {
    name = decodeURIComponent(uri);
  } catch {
    // A name with a plain percent sign.
  }
  return (name.split(/[\\/]/).pop() ?? '').trim().toLowerCase();
}

export class ModelFiles {
  readonly manager = new LoadingManager();
  /** Names that were asked for and are not here. */
  readonly missing = new Set<string>();
  private readonly files = new Map<string, OpenedFile>();
  private readonly addresses = new Map<string, string>();

  constructor(files: OpenedFile[]) {
    for (const file of files) this.files.set(plainName(file.name), file);
    this.manager.setURLModifier((uri) => this.address(uri));
  }

  find(uri: string): OpenedFile | null {
    return this.files.get(plainName(uri)) ?? null;
  }

  private address(uri: string): string {
    if (/^(blob|data):/.test(uri)) return uri;
    const file = this.find(uri);
    if (!file) {
      this.missing.add(uri);
      return 'data:,';
    }
    const known = this.addresses.get(file.name) ?? URL.createObjectURL(new Blob([file.bytes], { type: types[suffixOf(file.name)] ?? '' }));
    this.addresses.set(file.name, known);
    return known;
  }

  /** What `work` makes, once everything has arrived that it began to load. Throws the names that are missing. */
  async settled<T>(work: () => Promise<T> | T): Promise<T> {
    const done = new Promise<void>((resolve) => { this.manager.onLoad = resolve; });
    this.manager.itemStart('all');
    try {
      const result = await work();
      this.manager.itemEnd('all');
      await done;
      this.requireAll();
      return result;
    } catch (problem) {
      this.requireAll();
      throw problem;
    } finally {
      this.addresses.forEach((address) => URL.revokeObjectURL(address));
      this.addresses.clear();
    }
  }

  private requireAll(): void {
    if (this.missing.size > 0) throw new Error(`it names the file ${[...this.missing].join(', ')}, which was not opened with it; open all of its files together`);
  }
}
