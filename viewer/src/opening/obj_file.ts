/** OBJ files with their material libraries; what these state as numbers is taken as docs/formats/scene.md says. */
import type { Object3D } from 'three';
import { MTLLoader } from 'three/examples/jsm/loaders/MTLLoader.js';
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';
import type { Vec3 } from '../scene_file';
import { unstated, type StatedColours } from './materials_of_model';
import type { ModelFiles } from './model_files';
import type { OpenedFile } from './opening_api';

type Stated = Record<string, string | number[] | undefined>;

function librariesOf(text: string, files: ModelFiles): string {
  const texts: string[] = [];
  for (const [, named = ''] of text.matchAll(/^[ \t]*mtllib[ \t]+(.+?)[ \t]*$/gim)) {
    const found = files.find(named) ? [named] : named.split(/\s+/);
    for (const name of found) {
      const file = files.find(name);
      if (file) texts.push(new TextDecoder().decode(file.bytes));
      else files.missing.add(name);
    }
  }
  // Where two define a material, the first counts, and the reader keeps the last.
  return texts.reverse().join('\n');
}

function triple(value: Stated[string], otherwise: Vec3): Vec3 {
  if (!Array.isArray(value)) return otherwise;
  const [r = NaN, g = NaN, b = NaN] = value;
  if (Number.isNaN(r)) return otherwise;
  return Number.isNaN(g) || Number.isNaN(b) ? [r, r, r] : [r, g, b];
}

export function readObj(main: OpenedFile, files: ModelFiles): { root: Object3D; colours: (name: string) => StatedColours | null; notes: string[] } {
  const text = new TextDecoder().decode(main.bytes), library = librariesOf(text, files), reader = new OBJLoader(files.manager);
  let stated: Record<string, Stated> = {};
  if (library) {
    const creator = new MTLLoader(files.manager).parse(library, '');
    creator.preload();
    reader.setMaterials(creator);
    stated = creator.materialsInfo as unknown as Record<string, Stated>;
  }
  const root = reader.parse(text), notes: string[] = [];
  const shiny = Object.keys(stated).filter((name) => triple(stated[name]?.ks, [0, 0, 0]).some((x) => x > 0) && Number(stated[name]?.illum ?? 2) >= 2);
  if (shiny.length > 0) notes.push(`Highlights (Ks) of ${shiny.map((name) => `"${name}"`).join(', ')} are left out.`);
  notes.push('An OBJ file names no unit; its lengths are taken as metres.');
  return { root, notes, colours: (name) => {
    const m = stated[name];
    return m ? { albedo: triple(m.kd, m.map_kd ? [1, 1, 1] : unstated.albedo), emission: triple(m.ke, m.map_ke ? [1, 1, 1] : [0, 0, 0]) } : unstated;
  } };
}
