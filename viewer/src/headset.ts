/** The picture in a headset: passes for each eye with its own prescription, from where the headset says that it is, and a panel of controls. */
import type { App } from './app';
import type { Pose } from './camera';
import { EyeOptics, type FocusTable, type Sights } from './eye_optics';
import type { Uniform } from './gpu';
import { HeadsetPanel } from './headset_panel';
import { PanelPlace, PanelPointing } from './headset_pointing';
import type { Panel } from './pictures';
import { sides, type Side, type State } from './state';

/** Of each eye in each frame: a headset shows the next one before a picture could converge. */
const passes = 8;
/** Of the headset's own resolution along each side. */
const scale = 0.7;

interface EyeView { optics: EyeOptics; panel: Panel | null; state: State; uniforms: Record<string, Uniform>; sights: Sights | null; focus: FocusTable | null; edges: string; pose: Pose | null }

export async function headsetIsThere(): Promise<boolean> {
  try {
    return (await navigator.xr?.isSessionSupported('immersive-vr')) ?? false;
  } catch {
    return false;
  }
}

/** Head, slopes and middle of one of the headset's views, in the world of the page. */
function poseOfView(view: XRView, width: number, height: number, start: Pose): Pose {
  const m = view.projectionMatrix, at = view.transform.matrix, turn = start.head;
  const turned = (v: number[]) => [0, 1, 2].map((k) => (turn[k] ?? 0) * (v[0] ?? 0) + (turn[3 + k] ?? 0) * (v[1] ?? 0) + (turn[6 + k] ?? 0) * (v[2] ?? 0));
  const column = (k: number) => turned(Array.from(at.subarray(4 * k, 4 * k + 3)));
  const position = column(3).map((x, k) => x + (start.position[k] ?? 0)) as [number, number, number];
  return {
    head: [...column(0), ...column(1), ...column(2)], position,
    pixelSlope: [2 / ((m[0] ?? 1) * width), 2 / ((m[5] ?? 1) * height)], center: [0.5 * width * (1 - (m[8] ?? 0)), 0.5 * height * (1 + (m[9] ?? 0))], width, height,
  };
}

export class Headset {
  readonly eyes: Record<Side, EyeView>;
  readonly panel: HeadsetPanel;
  readonly pointing: PanelPointing;
  frames = 0;
  private painted: WebGLTexture | null = null;
  /** What the eyes wear and the panel shows. */
  private shown: State | null = null;
  private spaceIsDown = false;

  /** `start` is where the head is and which way ahead is when the session begins. */
  private constructor(private readonly app: App, private readonly session: XRSession, private readonly layer: XRWebGLLayer, private readonly space: XRReferenceSpace, private readonly start: Pose) {
    const eye = (): EyeView => ({ optics: new EyeOptics(app.core), panel: null, state: app.state, uniforms: {}, sights: null, focus: null, edges: '', pose: null });
    this.eyes = { right: eye(), left: eye() };
    this.panel = new HeadsetPanel(() => app.state, (edit) => app.change(edit), () => this.leave());
    this.pointing = new PanelPointing(session, space, this.panel);
    this.wear();
    addEventListener('keydown', this.key);
    addEventListener('keyup', this.key);
    session.requestAnimationFrame((_, frame) => this.frame(frame));
  }

  /** Throws where the headset or the core refuses. `ended` is called once. */
  static async enter(app: App, start: Pose, ended: () => void): Promise<Headset> {
    const xr = navigator.xr, { gl } = app.gpu;
    if (!xr) throw new Error('This browser knows no headset.');
    const session = await xr.requestSession('immersive-vr');
    session.addEventListener('end', ended);
    await gl.makeXRCompatible();
    const layer = new XRWebGLLayer(session, gl, { antialias: false, alpha: false, depth: false });
    await session.updateRenderState({ baseLayer: layer });
    return new Headset(app, session, layer, await session.requestReferenceSpace('local'), start);
  }

  leave(): void {
    void this.session.end();
  }

  release(): void {
    removeEventListener('keydown', this.key);
    removeEventListener('keyup', this.key);
    this.app.gpu.gl.deleteTexture(this.painted);
    for (const side of sides) {
      const { panel, optics } = this.eyes[side];
      if (panel) this.app.gpu.release(panel.sum);
      optics.optics.delete();
    }
  }

  private readonly key = (event: KeyboardEvent) => {
    if (event.key === ' ') this.spaceIsDown = event.type === 'keydown';
  };

  private get isSharp(): boolean {
    return this.panel.sharp || this.pointing.isHeld || this.spaceIsDown;
  }

  /** Both eyes as the page's state says, and the panel; while a progressive lens is being made an eye keeps what it wore. */
  private wear(): void {
    const { app } = this;
    let done = true;
    for (const side of sides) {
      const eye = this.eyes[side], state: State = { ...app.state, side };
      if (!eye.optics.wear(state, app.view, app.lenses)) {
        done = false;
        continue;
      }
      Object.assign(eye, { state, uniforms: eye.optics.uniforms(state, app.view) });
      if (eye.pose) this.tabulate(side, eye.pose);
    }
    if (done) this.shown = app.state;
    this.panel.isStale = true;
  }

  /** What the core refuses is said on the page; the eyes keep what they wore. */
  private follow(frame: XRFrame): void {
    this.pointing.follow(frame);
    try {
      if (this.shown !== this.app.state) this.wear();
    } catch (problem) {
      this.shown = this.app.state;
      this.app.say((problem as Error).message);
    }
    if (!this.panel.isStale) return;
    this.panel.paint();
    this.painted = this.app.gpu.painted(this.painted, this.panel.canvas);
  }

  private frame(frame: XRFrame): void {
    this.session.requestAnimationFrame((_, next) => this.frame(next));
    const pose = frame.getViewerPose(this.space);
    if (!pose) return;
    this.pointing.place ??= new PanelPlace(pose.transform, this.panel.canvas.width / this.panel.canvas.height);
    this.follow(frame);
    this.app.pictures.setPasses(passes);
    for (const view of pose.views) {
      const port = this.layer.getViewport(view);
      if (!port) continue;
      this.draw(view.eye === 'left' ? 'left' : 'right', view, port);
      this.drawPanel(view);
    }
    ++this.frames;
  }

  /** What depends on where the picture's edges are, and not on the head. */
  private tabulate(side: Side, pose: Pose): void {
    const eye = this.eyes[side], { optics, state } = eye;
    eye.sights = optics.sights(state, pose);
    eye.focus = state.eyes[side].accommodation === 'best' ? optics.focusTable(pose) : null;
  }

  private draw(side: Side, view: XRView, port: XRViewport): void {
    const { pictures, gpu, state } = this.app, eye = this.eyes[side], width = Math.max(1, Math.round(scale * port.width)), height = Math.max(1, Math.round(scale * port.height));
    eye.pose = poseOfView(view, width, height, this.start);
    const edges = [width, height, ...eye.pose.pixelSlope, ...eye.pose.center].join();
    if (edges !== eye.edges) {
      eye.edges = edges;
      this.tabulate(side, eye.pose);
      if (eye.panel) gpu.release(eye.panel.sum);
      eye.panel = pictures.panel('raster', width, height);
    }
    const panel = eye.panel as Panel;
    this.lookThrough(side);
    panel.mode = this.isSharp ? 'sharp' : 'raster';
    pictures.restart(panel);
    for (let k = 0; k < (this.isSharp ? 1 : passes); ++k) pictures.step(panel, 0);
    pictures.showIn(this.layer.framebuffer, panel.sum, port, state.exposure);
  }

  /** Pictures are those of this eye from now on, as it was when it was drawn last; its pose, null before the first frame. */
  lookThrough(side: Side): Pose | null {
    const { uniforms, sights, focus, pose } = this.eyes[side], { pictures } = this.app;
    if (!pose || !sights) return null;
    pictures.setEye({ ...uniforms }, sights, focus);
    pictures.setPose(pose);
    return pose;
  }

  /** Over the picture and without its blur, in the part of the framebuffer that was drawn last. */
  private drawPanel(view: XRView): void {
    const { place, pointed } = this.pointing;
    if (!place || !this.painted) return;
    this.app.pictures.programs.use('panel').texture('u_painted', this.painted).set({
      u_projection: view.projectionMatrix, u_view: view.transform.inverse.matrix, u_middle: place.middle, u_right: place.right, u_up: place.up,
      u_pointed: pointed ?? [-1, -1], u_aspect: this.panel.canvas.width / this.panel.canvas.height,
    });
    this.app.gpu.rectangle();
  }
}
