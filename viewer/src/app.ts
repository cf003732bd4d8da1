/** The page: state in, pictures and numbers out. */
import { numbersOf, poseOf } from './camera';
import type { Core } from './core_module';
import type { Bound } from './controls';
import { byId } from './elements';
import { EyeOptics } from './eye_optics';
import { fillForm, modeNames } from './form';
import { Gpu } from './gpu';
import { GpuScene } from './gpu_scene';
import { hashOf, stateOfHash } from './hash_state';
import { Headset, headsetIsThere } from './headset';
import { LensMaker } from './lens_maker';
import { LensMap } from './lens_map';
import { showLeftOut } from './left_out';
import { rimOf } from './lens_rim';
import { lessons } from './lessons';
import { NativeRender, programAnswers } from './native_render';
import { FileOpener } from './open_files';
import { Overlay, type PlacedEllipse } from './overlay';
import { Pace } from './pace';
import { Pictures, type Panel } from './pictures';
import { pointOn, type Pointing } from './pointing';
import { Readout } from './readout';
import { download, filesOf, viewDocument } from './save';
import type { SceneData, Vec3 } from './scene_file';
import { SceneTree } from './scene_tree';
import { isTraced, sides, type Mode, type State } from './state';
import { startState, type ViewData } from './view_data';

const modeWords: Record<Mode, string> = { sharp: 'sharp', raster: 'passes', gather: 'traced passes', path: 'samples', sphere: 'samples' };

export class App {
  state: State;
  readonly canvas = byId<HTMLCanvasElement>('picture');
  readonly eye: EyeOptics;
  tree: SceneTree;
  width: number;
  height: number;
  gpu!: Gpu;
  scene!: GpuScene;
  pictures!: Pictures;
  panels: Panel[] = [];
  private readonly bound: Bound[];
  private readonly opener: FileOpener;
  /** What the page came with. */
  private readonly shipped: ViewData;
  private readonly pointing: Pointing;
  private readonly readout = new Readout();
  private readonly overlay = new Overlay();
  private readonly lensMap = new LensMap();
  private rim: [number, number][] = [];
  private readonly pace = new Pace();
  readonly lenses = new LensMaker(() => this.lensMade());
  private changed = true;
  /** What the pictures are of; what is laid over them, and how brightly they are shown, does not begin them anew. */
  private drawn = '';
  private pointed = true;
  private busy = false;
  private lost = false;
  /** Nothing is drawn on its own while a script measures. */
  held = false;
  headset: Headset | null = null;
  /** After the page was asked for. */
  firstPicture_ms = 0;
  private hashTimer = 0;

  constructor(readonly core: Core, public view: ViewData, public data: SceneData) {
    this.state = startState(view);
    this.width = view.camera.width;
    this.height = view.camera.height;
    this.tree = new SceneTree(data);
    this.eye = new EyeOptics(core);
    this.shipped = view;
    this.opener = new FileOpener(this);
    this.showTitle();
    this.readHash();
    this.setUpGpu();
    this.bound = fillForm(byId<HTMLFormElement>('controls'), (edit) => this.change(edit), core, () => this.view, {
      lesson: (k) => this.lesson(k), reset: () => { this.adopt(startState(this.view), ''); this.teach(''); }, files: this.opener.input, realEye: (eye) => void this.opener.takeRealEye(eye), saveView: () => this.saveView(), savePicture: () => this.savePicture(), copyLink: () => void this.copyLink(), native: (button) => void this.offerNative(button), headset: (button) => this.offerHeadset(button),
    });
    this.pointing = pointOn(this.canvas, (edit) => this.change(edit), () => this.panels.length, () => { this.pointed = true; });
    this.canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.lost = true;
      this.say('The graphics context was lost; the picture returns when the browser gives it back.', true);
    });
    this.canvas.addEventListener('webglcontextrestored', () => {
      this.lost = false;
      this.setUpGpu();
      this.changed = true;
      this.say('');
    });
    addEventListener('hashchange', () => { if (location.hash !== hashOf(this.state)) this.readHash(); });
    requestAnimationFrame((now) => this.frame(now));
  }

  /** Above the picture; `isProblem`: something went wrong. */
  say(text: string, isProblem = false): void {
    const message = byId('message');
    message.textContent = text;
    message.classList.toggle('problem', isProblem);
    message.hidden = text === '';
  }

  change(edit: (state: State) => void): void {
    const next = structuredClone(this.state);
    edit(next);
    this.adopt(next, '');
  }

  /** Another view; `data`: with another scene. Throws where the scene does not fit the graphics card. */
  show(view: ViewData, data: SceneData | null, next: State): void {
    if (data) {
      const tree = new SceneTree(data), scene = new GpuScene(this.gpu, data, tree, view.camera.position_m);
      this.scene.release();
      [this.data, this.tree, this.scene] = [data, tree, scene];
    }
    this.view = view;
    [this.width, this.height] = [view.camera.width, view.camera.height];
    this.pictures.showScene(this.scene, view.maxBounces);
    this.panels.forEach((p) => this.gpu.release(p.sum));
    this.panels = [];
    this.showTitle();
    this.adopt(next, '');
  }

  private showTitle(): void {
    byId('title').textContent = this.view.title;
    document.title = `${this.view.title} · Sturm`;
    showLeftOut(this.view.notDrawn);
  }

  private adopt(next: State, message: string): void {
    this.state = next;
    this.changed = true;
    this.say(message);
    clearTimeout(this.hashTimer);
    this.hashTimer = window.setTimeout(() => history.replaceState(null, '', hashOf(this.state)), 300);
  }

  private readHash(): void {
    try {
      const state = stateOfHash(location.hash);
      if (!state) return;
      const bare = sides.find((side) => state.glasses[side].kind === 'view' && !this.view.worn[side].lens);
      if (bare) throw new Error(`The ${bare} eye of the link wears spectacles of a file: open that file first.`);
      this.adopt(state, '');
    } catch (problem) {
      this.say((problem as Error).message, true);
    }
  }

  private lesson(k: number): void {
    const lesson = lessons[k];
    if (!lesson) return;
    const next = { ...structuredClone(this.state), camera: startState(this.view).camera };
    lesson.set(next);
    this.adopt(next, '');
    this.teach(lesson.text);
  }

  /** What a lesson says stays while its reader does what it asks for. */
  private teach(text: string): void {
    const place = byId('lesson');
    place.textContent = text;
    place.hidden = text === '';
    place.scrollIntoView({ block: 'nearest' });  // its button may stand far below
  }

  private setUpGpu(): void {
    this.gpu = new Gpu(this.canvas);
    this.scene = new GpuScene(this.gpu, this.data, this.tree, this.view.camera.position_m as Vec3);
    this.pictures = new Pictures(this.gpu, this.core, this.scene, this.view.maxBounces);
    this.panels = [];
  }

  private lensMade(): void {
    byId('making').hidden = !this.lenses.isMaking;
    this.changed = true;
  }

  /** Optics and panels as the state says; false, with a message, where the core refuses them, and while a lens is being made unless `atOnce`. */
  prepare(atOnce = false): boolean {
    const { state } = this;
    try {
      if (!this.eye.wear(state, this.view, atOnce ? undefined : this.lenses)) return false;
      const pose = poseOf(state.camera, this.width, this.height);
      const uniforms = this.eye.uniforms(state, this.view);
      this.pictures.setPasses(state.passes);
      this.pictures.setEye(uniforms, this.eye.sights(state, pose), state.eyes[state.side].accommodation === 'best' ? this.eye.focusTable(pose) : null);
      this.pictures.setPose(pose);
      this.rim = state.rimOverlay && this.eye.lens ? rimOf(this.eye.optics, state.camera.gaze, pose) : [];
    } catch (problem) {
      this.say((problem as Error).message, true);
      return false;
    }
    if (this.panels.map((p) => p.mode).join() !== state.modes.join()) {
      this.panels.forEach((p) => this.gpu.release(p.sum));
      this.panels = state.modes.map((mode) => this.pictures.panel(mode, this.width, this.height));
      this.canvas.width = this.width * this.panels.length;
      this.canvas.height = this.height;
    }
    const drawn = JSON.stringify({ ...state, exposure: 1, filter: false, fieldOverlay: false, rimOverlay: false, lensMap: false }) + this.eye.worn;
    if (drawn !== this.drawn) this.panels.forEach((p) => this.pictures.restart(p));
    else this.showPanels();
    this.drawn = drawn;
    return true;
  }

  private frame(now: number): void {
    requestAnimationFrame((later) => this.frame(later));
    if (this.lost || this.held || document.hidden) return;
    const allowed = this.pace.next(now, this.busy);
    if (this.changed) {
      this.changed = false;
      this.pointed = true;
      this.bound.forEach((b) => b.show(this.state));
      if (!this.prepare()) return;
    }
    this.busy = this.draw(allowed);
    if (this.pointed) {
      this.pointed = false;
      this.showNumbers();
    }
  }

  /** Some passes of every panel that has not enough; true if there were any. */
  private draw(allowed: number): boolean {
    const open = this.panels.filter((p) => p.passes < this.pictures.goal(p.mode));
    const drawnModes = this.panels.some((p) => p.mode === 'sharp' || p.mode === 'raster');
    const settles = drawnModes && !this.scene.lightIsSettled;
    if (!settles && open.length === 0) return false;
    // The first picture has no light yet: what gathers it takes long to compile.
    if (settles && this.firstPicture_ms > 0) this.settleLight(allowed);
    for (const p of open) {
      // A unit of work is a pass of the rasteriser or four rows of rays, of the light too.
      if (isTraced(p.mode)) this.pictures.step(p, 4 * allowed);
      else for (let k = 0; k < allowed && p.passes < this.pictures.goal(p.mode); ++k) this.pictures.step(p, 0);
    }
    // The filter takes as long as many rows of rays, so it waits for whole passes.
    if (!this.state.filter || open.every((p) => p.rows === 0 || p.passes === 0)) this.showPanels();
    if (this.firstPicture_ms === 0) {
      this.panels.forEach((p) => this.gpu.finish(p.sum));
      this.firstPicture_ms = performance.now();
    }
    this.showStatus();
    return true;
  }

  /** Light at the vertices of the drawn mesh, the first sample at once; pictures begin anew when it has doubled its samples. */
  private settleLight(allowed: number): void {
    const rows = this.scene.bakedSamples === 0 ? 64 : 4 * allowed;
    if (!this.scene.gatherLight(this.pictures.programs, rows, this.view.maxBounces)) return;
    const n = this.scene.bakedSamples;
    if ((n & (n - 1)) === 0) this.panels.filter((p) => p.mode === 'sharp' || p.mode === 'raster').forEach((p) => this.pictures.restart(p));
  }

  private showPanels(): void {
    this.pictures.show(this.panels, this.canvas, this.state.exposure, this.state.filter);
  }

  private showStatus(): void {
    const counts = this.panels.map((p) => `${modeWords[p.mode]} ${p.passes} of ${this.pictures.goal(p.mode)}`);
    const light = this.scene.lightIsSettled || this.panels.every((p) => isTraced(p.mode)) ? '' : ` · light ${this.scene.bakedSamples} of 64`;
    byId('status').textContent = `${counts.join(' | ')} · ${this.pace.frame_ms.toFixed(0)} ms a frame${light}`;
  }

  private distanceTo(x: number, y: number): { gaze: { azimuth_rad: number; elevation_rad: number }; distance: number } {
    const camera = numbersOf(this.state.camera, this.width, this.height), pose = poseOf(this.state.camera, this.width, this.height);
    const gaze = this.eye.optics.gazeAt(camera, x, y), chief = this.eye.optics.ellipse(gaze.azimuth_rad, gaze.elevation_rad, 1).chief_ray;
    const world = (v: readonly number[]) => [0, 1, 2].map((k) => (pose.head[k] ?? 0) * (v[0] ?? 0) + (pose.head[3 + k] ?? 0) * (v[1] ?? 0) + (pose.head[6 + k] ?? 0) * (v[2] ?? 0)) as Vec3;
    if (!chief) return { gaze, distance: Infinity };
    const origin = world(chief.origin_m).map((q, k) => q + (pose.position[k] ?? 0)) as Vec3;
    return { gaze, distance: this.tree.distance(origin, world(chief.direction)) };
  }

  private placed(x: number, y: number): PlacedEllipse | null {
    const camera = numbersOf(this.state.camera, this.width, this.height), { distance } = this.distanceTo(x, y);
    const ellipse = this.eye.optics.pictureEllipse(camera, x, y, 1 / distance);
    return ellipse && { x, y, ellipse };
  }

  private showNumbers(): void {
    const flat = !this.state.modes.includes('sphere');  // on a sphere the pointer names no place of the picture that is drawn upon
    const x = (flat ? this.pointing.at.x : 0.5) * this.width, y = (flat ? this.pointing.at.y : 0.5) * this.height, { gaze, distance } = this.distanceTo(x, y);
    this.readout.show(this.eye.optics, this.state, gaze, distance);
    const field: PlacedEllipse[] = [];
    if (this.state.fieldOverlay && flat)
      for (let j = 0; j < 5; ++j) for (let i = 0; i < 7; ++i) {
        const e = this.placed(((i + 0.5) * this.width) / 7, ((j + 0.5) * this.height) / 5);
        if (e) field.push(e);
      }
    this.overlay.show(this.width, this.height, this.panels.map((p) => new Map(modeNames).get(p.mode) ?? ''), flat ? this.placed(x, y) : null, field, this.rim);
    if (this.state.lensMap && this.eye.lens) this.lensMap.show(this.eye.optics, this.eye.worn, distance);
    else this.lensMap.hide();
  }

  private saveView(): void {
    const document = viewDocument(this.state, this.view, this.width, this.height), files = filesOf(document);
    download('view.json', new Blob([`${JSON.stringify(document, null, 2)}\n`], { type: 'application/json' }));
    this.say(files.length > 0 ? `view.json is saved. It names ${files.join(', ')} and is rendered where these names lead to the files.` : 'view.json is saved and needs no other file.');
  }

  private savePicture(): void {
    this.showPanels();
    this.canvas.toBlob((blob) => { if (blob) download('picture.png', blob); });
  }

  private async offerNative(button: HTMLButtonElement): Promise<void> {
    if (!(await programAnswers())) return;
    button.hidden = false;
    new NativeRender(button, () => {
      this.showPanels();
      const picture = this.panels.length === 1 && this.state.exposure === 1 && !this.state.filter ? this.canvas.toDataURL('image/png') : null;
      return { view: viewDocument(this.state, this.view, this.width, this.height), picture };
    });
  }

  private offerHeadset(button: HTMLButtonElement): void {
    const look = async () => { button.hidden = !(await headsetIsThere()); };
    navigator.xr?.addEventListener('devicechange', () => void look());
    void look();
    button.addEventListener('click', () => void this.enterHeadset());
  }

  async enterHeadset(): Promise<void> {
    const start = poseOf({ ...this.state.camera, tilt_deg: 0 }, 1, 1);
    this.held = true;
    const back = () => {
      this.headset?.release();
      this.headset = null;
      this.held = false;
      this.changed = true;
      this.say('');
    };
    try {
      this.headset = await Headset.enter(this, start, back);
      this.say('The picture is in the headset. Hold the trigger, or pinch, to see sharply.');
    } catch (problem) {
      back();
      this.say((problem as Error).message, true);
    }
  }

  private async copyLink(): Promise<void> {
    const link = location.href.replace(/#.*$/, '') + hashOf(this.state);
    history.replaceState(null, '', hashOf(this.state));
    try {
      await navigator.clipboard.writeText(link);
      this.say(`The link is in the clipboard.${this.view === this.shipped ? '' : ' It does not hold what was opened: open the same files where it is followed.'}`);
    } catch {
      this.say('The browser does not give the clipboard; the link stands in its address bar.');
    }
  }
}
