/** What the page gets from the part of it that is unpacked when somebody opens a file. Only types. */
import type { CoreWithReaders } from '../core_module';
import type { Picture, SceneData, Vec3 } from '../scene_file';

export interface OpenedFile { name: string; bytes: ArrayBuffer }

export interface OpenedModel {
  scene: SceneData;
  /** Where its first camera stands; null: it has none. */
  camera: { position_m: Vec3; look_at_m: Vec3; vfov_rad: number } | null;
  /** The element of `models` of a sturm.scene/1 document that names it. */
  document: { file: string } & Record<string, unknown>;
  /** Sentences on what is drawn otherwise or not at all. */
  notDrawn: string[];
}

export interface Opening {
  /** `all`: with the files that it names. Throws an Error that says what is wrong. */
  openModel(main: OpenedFile, all: OpenedFile[]): Promise<OpenedModel>;
  /** An HDR or EXR picture of all directions: linear, the upper row first. */
  openEnvironment(file: OpenedFile): Picture;
  /** The core with the command line's readers. */
  readers(): Promise<CoreWithReaders>;
}

/** The global function `sturmOpening`; it gets the WebAssembly module of the readers. */
export type OpeningFactory = (readersModule: Uint8Array) => Opening;
