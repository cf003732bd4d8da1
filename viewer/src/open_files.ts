/** Files that are chosen or dropped: models, surroundings, documents and prescriptions, each by the end of its name. */
import type { App } from './app';
import type { ReadDocument } from './core_module';
import { element } from './elements';
import { eyeNumbers } from './eye_optics';
import { documentShown, eyeShown, lensShown, modelShown, modeOf, surroundingsShown, type Surroundings } from './opened_view';
import type { OpenedFile } from './opening/opening_api';
import { prescribed } from './prescription';
import type { RealEye } from './real_eyes';
import type { Side, State } from './state';
import { cameraState, eyeState, startState } from './view_data';
import { loadOpening } from './unpack';

const models = /\.(gltf|glb|vrm|obj|usdz|usda|usdc|usd)$/i, surroundings = /\.(hdr|exr|pic)$/i, documents = /\.json$/i, notes = /\.(txt|rx)$/i;
const companions = /\.(bin|mtl|png|jpe?g|webp|avif|gif|bmp)$/i;
const mostBytes = 512 * 1024 * 1024;

async function read(file: File): Promise<OpenedFile> {
  return { name: file.name, bytes: await file.arrayBuffer() };
}

const textOf = (file: OpenedFile) => new TextDecoder().decode(file.bytes);
const painted = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));

export class FileOpener {
  readonly input = element('input', { type: 'file', multiple: true, hidden: true });

  constructor(private readonly app: App) {
    this.input.addEventListener('change', () => {
      const files = Array.from(this.input.files ?? []);
      this.input.value = '';
      void this.open(files);
    });
    const over = (on: boolean) => (event: DragEvent) => {
      if (!event.dataTransfer?.types.includes('Files')) return;
      event.preventDefault();
      document.body.classList.toggle('dropping', on);
    };
    document.addEventListener('dragover', over(true));
    document.addEventListener('dragleave', over(false));
    document.addEventListener('drop', (event) => {
      over(false)(event);
      void this.open(Array.from(event.dataTransfer?.files ?? []));
    });
  }

  /** All at once, since a model names others of them. What the page shows changes only if all can be read. */
  async open(chosen: File[]): Promise<void> {
    if (chosen.length === 0) return;
    const { app } = this, before = { view: app.view, data: app.data, state: app.state };
    app.say(`Opening ${chosen.map((f) => f.name).join(', ')} …`);
    await painted();
    try {
      if (chosen.reduce((sum, f) => sum + f.size, 0) > mostBytes) throw new Error(`These files have more than ${mostBytes / 2 ** 20} MiB together.`);
      const said = await this.take(await Promise.all(chosen.map(read)));
      app.say(said.join(' '));
    } catch (problem) {
      if (app.view !== before.view) app.show(before.view, app.data === before.data ? null : before.data, before.state);
      app.say((problem as Error).message, true);
    }
  }

  /** What was done, in sentences. */
  private async take(files: OpenedFile[]): Promise<string[]> {
    const of = (names: RegExp) => files.filter((f) => names.test(f.name));
    const main = of(models), sky = of(surroundings), unknown = files.filter((f) => ![models, surroundings, documents, notes, companions].some((names) => names.test(f.name)));
    if (unknown[0]) throw new Error(`${unknown[0].name} is of no kind that this page opens: glTF, OBJ, USD, HDR, EXR, documents of Sturm (.json) and prescriptions (.txt).`);
    if (main.length > 1 || sky.length > 1) throw new Error(`Open one ${main.length > 1 ? 'model' : 'picture of surroundings'} at a time: ${(main.length > 1 ? main : sky).map((f) => f.name).join(', ')}.`);
    if (files.every((f) => companions.test(f.name))) throw new Error(`${files.map((f) => f.name).join(', ')}: open the model that names ${files.length > 1 ? 'these files' : 'this file'} together with ${files.length > 1 ? 'them' : 'it'}.`);
    const said: string[] = [];
    if (main[0] || sky[0]) said.push(await this.takeScene(main[0] ?? null, sky[0] ?? null, files));
    for (const file of of(notes)) said.push(this.takePrescription(file));
    for (const file of of(documents).filter((f) => !this.belongsToModel(f, main[0]))) said.push(await this.takeDocument(textOf(file), file.name));
    return said;
  }

  private belongsToModel(file: OpenedFile, main: OpenedFile | undefined): boolean {
    return main !== undefined && /\.gltf$/i.test(main.name) && textOf(main).includes(`"${file.name}"`);
  }

  private async takeScene(main: OpenedFile | null, sky: OpenedFile | null, files: OpenedFile[]): Promise<string> {
    const { app } = this, opening = await loadOpening(), around: Surroundings | null = sky && { name: sky.name, picture: opening.openEnvironment(sky) };
    if (!main) {
      const shown = surroundingsShown(app.view, app.data, around as Surroundings);
      app.show(shown.view, shown.scene, app.state);
      return `The surroundings are those of ${sky?.name ?? ''}.`;
    }
    const model = await opening.openModel(main, files), { view, scene } = modelShown(app.view, main.name, model, around, app.width, app.height);
    app.show(view, scene, { ...app.state, camera: { ...cameraState(view.camera), gaze: app.state.camera.gaze } });
    const size = Math.max(...scene.upper.map((x, k) => x - (scene.lower[k] ?? 0)));
    return `${main.name}: ${scene.triangles.length / 3} triangles, ${Number(size.toPrecision(3))} m across.${view.notDrawn.length > 0 ? ' What is left out of it stands below the picture.' : ''}`;
  }

  private takePrescription(file: OpenedFile): string {
    try {
      this.app.change(prescribed(this.app.core, textOf(file)));
    } catch (problem) {
      throw new Error(`${file.name}: ${(problem as Error).message}`);
    }
    return `The eye is that of ${file.name}.`;
  }

  /** By the command line's readers. */
  async takeDocument(text: string, name: string): Promise<string> {
    const { app } = this, side = app.state.side, readers = await (await loadOpening()).readers();
    const found = readers.readDocument(text, name, eyeNumbers(app.state.eyes[side], app.view.worn[side].eye));
    if (found.format === 'eye') return this.takeEye(found, name);
    if (found.format === 'spectacles') {
      const state = structuredClone(app.state);
      state.glasses[side].kind = 'view';
      app.show(lensShown(app.view, side, found.document, found.lens), null, state);
      return `The ${side} eye wears the spectacles of ${name}.`;
    }
    return this.takeView(found, name);
  }

  private takeEye(found: ReadDocument & { format: 'eye' }, name: string): string {
    const { app } = this, wave = found.document.wavefront as { eye?: string; mirror_to?: string } | undefined;
    const side: Side = ((wave?.mirror_to ?? wave?.eye) as Side | undefined) ?? app.state.side, state: State = structuredClone(app.state);
    state.side = side;
    state.eyes[side] = eyeState(found.eye);
    if (wave) Object.assign(state, { rayModel: 'zernike', modes: ['path'] });
    app.show(eyeShown(app.view, side, found.document, found.eye), null, state);
    return `The ${side} eye is that of ${name}${wave ? ', traced by its wavefront' : ''}.`;
  }

  private takeView(found: ReadDocument & { format: 'render' }, name: string): string {
    const { app } = this, { view, sceneIsAnother } = documentShown(app.view, name, found), { mode, passes } = modeOf(found.document.method as object);
    app.show(view, null, { ...startState(view), modes: [mode], passes });
    return sceneIsAnother ? `Eye, spectacles and camera are those of ${name}. Its scene is not in this page, which keeps its own; "sturm view ${name} -o page.html" makes a page with it.` : `This is the view ${name}.`;
  }

  async takeRealEye(eye: RealEye): Promise<void> {
    this.app.say(`Reading ${eye.title} …`);
    await painted();
    try {
      this.app.say(await this.takeDocument(JSON.stringify(eye.document), eye.file));
    } catch (problem) {
      this.app.say((problem as Error).message, true);
    }
  }
}
