/** What the page shows after a file was opened: the view and the scene that were there, with what the file has. */
import type { EyeNumbers, LensNumbers, ReadDocument } from './core_module';
import type { OpenedModel } from './opening/opening_api';
import type { Picture, SceneData, Vec3 } from './scene_file';
import { modes, rayModels, type Side } from './state';
import type { ViewData } from './view_data';

type Json = Record<string, unknown>;

export interface Surroundings { picture: Picture; name: string }

const field_deg = 40;

const length = (v: Vec3) => Math.hypot(...v);
const scaled = (s: number, v: Vec3) => v.map((x) => s * x) as Vec3;
const sum = (a: Vec3, b: Vec3) => a.map((x, k) => x + (b[k] ?? 0)) as Vec3;

function middleOf(scene: SceneData): { middle: Vec3; radius: number } {
  const middle = scaled(0.5, sum(scene.lower, scene.upper));
  return { middle, radius: Math.max(1e-4, length(sum(scene.upper, scaled(-1, middle)))) };
}

/** Where all of a scene is seen, a little from above and from the right. */
export function cameraBefore(scene: SceneData, aspect: number): Pick<ViewData['camera'], 'position_m' | 'look_at_m' | 'vfov_rad'> {
  const { middle, radius } = middleOf(scene), half = (0.5 * field_deg * Math.PI) / 180, narrower = Math.atan(Math.tan(half) * Math.min(1, aspect));
  const toEye: Vec3 = [0.4, 0.3, 1], distance = radius / Math.sin(narrower);
  return { position_m: sum(middle, scaled(distance / length(toEye), toEye)), look_at_m: middle, vfov_rad: 2 * half };
}

const grey = (x: number): Vec3 => [x, x, x];

/** Light for a scene that brings none: a bright point above the viewer's left, in grey surroundings. */
function lightOf(scene: SceneData, surroundings: Surroundings | null): Pick<SceneData, 'lights' | 'environment'> {
  if (surroundings) return { lights: [], environment: { radiance: grey(1), texture: scene.textures.length, rotation_rad: 0 } };
  if (scene.materials.some((m) => m.emission.some((x) => x > 0))) return { lights: [], environment: { radiance: grey(0.1), texture: null, rotation_rad: 0 } };
  const { middle, radius } = middleOf(scene), at: Vec3 = [-1.5 * radius, 2.5 * radius, 2 * radius];
  // A white surface across the light gets the radiance 0.7 from it.
  return { lights: [{ position_m: sum(middle, at), intensity: grey(0.7 * Math.PI * length(at) ** 2) }], environment: { radiance: grey(0.3), texture: null, rotation_rad: 0 } };
}

/** A model in place of the scene. */
export function modelShown(view: ViewData, name: string, model: OpenedModel, surroundings: Surroundings | null, width: number, height: number): { view: ViewData; scene: SceneData } {
  const light = lightOf(model.scene, surroundings), scene: SceneData = { ...model.scene, ...light, textures: surroundings ? [...model.scene.textures, surroundings.picture] : model.scene.textures };
  const camera = { ...view.camera, ...(model.camera ?? cameraBefore(scene, width / height)), up: [0, 1, 0] as Vec3 };
  const document: Json = {
    format: 'sturm.scene/1', models: [model.document], lights: light.lights.map((l) => ({ type: 'point', ...l })),
    environment: surroundings ? { file: surroundings.name } : { radiance: light.environment?.radiance },
  };
  const noUsd = model.document.file === name ? [] : [`sturm render reads no USD: view.json names ${model.document.file}, which scripts/convert_usd makes of this file.`];
  return { scene, view: { ...view, title: name, document: { ...view.document, scene: document }, camera, notDrawn: [...model.notDrawn, ...noUsd] } };
}

/** Other surroundings for the scene that is there. */
export function surroundingsShown(view: ViewData, scene: SceneData, { picture, name }: Surroundings): { view: ViewData; scene: SceneData } {
  const given = view.document.scene, isFile = typeof given === 'string';
  const kept = isFile ? [`view.json keeps the surroundings of ${given}: a scene in a file of its own is not changed.`] : [];
  const document = isFile ? view.document : { ...view.document, scene: { ...(given as Json), environment: { file: name } } };
  return {
    view: { ...view, document, notDrawn: [...view.notDrawn, ...kept] },
    scene: { ...scene, textures: [...scene.textures, picture], environment: { radiance: grey(1), texture: scene.textures.length, rotation_rad: 0 } },
  };
}

/** Parts of a document's left eye are what it has of its own. */
function withPart(view: ViewData, side: Side, key: 'eye' | 'spectacles', value: unknown): Json {
  const document = view.document as Record<string, any>, left = { [key]: document[key] ?? null, ...document.left };
  return side === 'right' ? { ...document, [key]: value, left } : { ...document, left: { ...left, [key]: value } };
}

export function eyeShown(view: ViewData, side: Side, document: Json, eye: EyeNumbers): ViewData {
  return { ...view, document: withPart(view, side, 'eye', document), worn: { ...view.worn, [side]: { ...view.worn[side], eye } } };
}

export function lensShown(view: ViewData, side: Side, document: Json, lens: LensNumbers): ViewData {
  return { ...view, document: withPart(view, side, 'spectacles', document), worn: { ...view.worn, [side]: { ...view.worn[side], lens } } };
}

/** Which files a scene is made of, and what it states itself. */
function substanceOf(scene: unknown): string {
  if (typeof scene !== 'object' || scene === null) return JSON.stringify(scene);
  const { models = [], meshes = [], spheres = [] } = scene as Record<string, any>;
  return JSON.stringify([models.map((m: Json) => m.file), meshes, spheres]);
}

/** A render document; the scene stays, and `sceneIsAnother` where the document has another one. */
export function documentShown(view: ViewData, name: string, read: ReadDocument & { format: 'render' }): { view: ViewData; sceneIsAnother: boolean } {
  const { camera, right, left, ray_model } = read.view, sceneIsAnother = substanceOf(read.document.scene) !== substanceOf(view.document.scene);
  const method = read.document.method as { max_bounces?: number };
  return {
    sceneIsAnother,
    view: {
      ...view, title: name.replace(/\.json$/, ''), document: { ...read.document, scene: view.document.scene }, camera, worn: { right, left: left ?? right }, maxBounces: method.max_bounces ?? 16,
      rayModel: rayModels.find((m) => m === ray_model) ?? 'power_matrix',
    },
  };
}

/** How the page shows what a document's method makes. */
export function modeOf(method: { type?: string; ray_model?: string; passes?: number }): { mode: (typeof modes)[number]; passes: number } {
  const mode = method.type === 'predict' ? 'gather' : method.ray_model === 'pinhole' ? 'sharp' : 'path';
  return { mode, passes: [16, 64, 256].includes(method.passes ?? 0) ? (method.passes as number) : 64 };
}

