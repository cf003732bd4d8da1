/** A model file of any kind that is read, as a scene. */
import { type AnimationClip, type Object3D, type PerspectiveCamera, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import type { Vec3 } from '../scene_file';
import { checkGltf } from './gltf_check';
import { MaterialsOfModel, type StatedColours } from './materials_of_model';
import { ModelFiles, suffixOf } from './model_files';
import type { OpenedFile, OpenedModel } from './opening_api';
import { PicturesOfModel } from './pictures_of_model';
import { said } from './said';
import { sceneOfModel } from './scene_of_model';
import { readObj } from './obj_file';
import { readUsd } from './usd/usd_file';

interface Loaded { root: Object3D; animations: AnimationClip[]; notes: string[]; colours?: (name: string) => StatedColours | null }

async function loadGltf(main: OpenedFile, files: ModelFiles): Promise<Loaded> {
  checkGltf(main.bytes, (uri) => files.find(uri)?.bytes.byteLength ?? null);
  const { scene, animations } = await new GLTFLoader(files.manager).parseAsync(main.bytes, '');
  return { root: scene, animations, notes: [] };
}

async function loadUsd(main: OpenedFile, files: ModelFiles): Promise<Loaded> {
  const { root, settled, missing, notes } = readUsd(main.name, main.bytes, (key) => files.find(key)?.bytes ?? null, files.manager);
  for (const name of missing) files.missing.add(name);
  await settled;
  return { root, animations: root.animations, notes };
}

function load(main: OpenedFile, files: ModelFiles): Promise<Loaded> | Loaded {
  const suffix = suffixOf(main.name);
  if (suffix === 'obj') return { animations: [], ...readObj(main, files) };
  return suffix.startsWith('usd') ? loadUsd(main, files) : loadGltf(main, files);
}

/** The first camera, and what else is in the tree besides surfaces. */
function others(loaded: Loaded): { camera: OpenedModel['camera']; notes: string[] } {
  let camera: OpenedModel['camera'] = null;
  const counts = { lights: 0, lines: 0, cameras: 0, hidden: 0 };
  loaded.root.updateMatrixWorld(true);
  loaded.root.traverse((object) => {
    const is = object as Object3D & Record<'isLight' | 'isLine' | 'isPoints' | 'isSprite' | 'isPerspectiveCamera' | 'isCamera', boolean | undefined>;
    if (is.isLight) ++counts.lights;
    if (is.isLine || is.isPoints || is.isSprite) ++counts.lines;
    if (!object.visible) ++counts.hidden;
    if (is.isCamera) ++counts.cameras;
    if (!is.isPerspectiveCamera || camera) return;
    const position = object.getWorldPosition(new Vector3()), ahead = object.getWorldDirection(new Vector3());
    camera = { position_m: position.toArray() as Vec3, look_at_m: position.clone().add(ahead).toArray() as Vec3, vfov_rad: ((object as PerspectiveCamera).fov * Math.PI) / 180 };
  });
  const notes: string[] = [];
  if (counts.lights > 0) notes.push(`Lights of the file are left out (${counts.lights}).`);
  if (counts.lines > 0) notes.push(`Points and lines are not drawn (${counts.lines} objects).`);
  if (counts.cameras > 1) notes.push(`Of ${counts.cameras} cameras the first is used.`);
  if (loaded.animations.length > 0) notes.push(`Animations stand still (${loaded.animations.length}).`);
  return { camera, notes };
}

/** What a document of the program says of the file; it reads no USD but has a script that makes glTF of it. */
function documentOf(name: string): OpenedModel['document'] {
  const suffix = suffixOf(name);
  if (suffix.startsWith('usd')) return { file: name.replace(/\.[^.]*$/, '.glb') };
  return suffix === 'obj' ? { file: name, texture_wrap: 'repeat' } : { file: name };
}

export async function openModel(main: OpenedFile, all: OpenedFile[]): Promise<OpenedModel> {
  const files = new ModelFiles(all);
  said.clear();
  try {
    const loaded = await files.settled(() => load(main, files));
    const pictures = new PicturesOfModel(), materials = new MaterialsOfModel(pictures, loaded.colours ?? (() => null));
    const shape = sceneOfModel(loaded.root, materials), { camera, notes } = others(loaded);
    const scene = { ...shape, materials: materials.facts, textures: pictures.pictures(), lights: [], environment: null };
    return { scene, camera, document: documentOf(main.name), notDrawn: [...loaded.notes, ...notes, ...materials.notes, ...pictures.notes(), ...Array.from(said, (text) => `The file was read with the remark: ${text}`)] };
  } catch (problem) {
    throw new Error(`${main.name} cannot be opened: ${(problem as Error).message ?? String(problem)}.`);
  }
}
