/** Mouse, touch and keys on the picture: they point, turn the head and move it. */
import type { State } from './state';
import type { Change } from './controls';

export interface Pointing {
  /** Place of the pointer in one panel, 0 … 1 from its upper left corner. */
  at: { x: number; y: number };
}

const turnStep_deg = 2, walkStep_m = 0.1;
const within = (x: number, least: number, largest: number) => Math.min(largest, Math.max(least, x));

function turn(state: State, right_deg: number, up_deg: number): void {
  const c = state.camera, wide = c.turn_deg + right_deg;
  c.turn_deg = wide - 360 * Math.round(wide / 360);
  c.tilt_deg = within(c.tilt_deg + up_deg, -89, 89);
}

function walk(state: State, right: number, ahead: number): void {
  const c = state.camera, a = (c.turn_deg * Math.PI) / 180, [x, y, z] = c.position_m;
  c.position_m = [x + walkStep_m * (right * Math.cos(a) + ahead * Math.sin(a)), y, z + walkStep_m * (right * Math.sin(a) - ahead * Math.cos(a))];
}

const keys: Record<string, (s: State) => void> = {
  ArrowLeft: (s) => turn(s, -turnStep_deg, 0), ArrowRight: (s) => turn(s, turnStep_deg, 0), ArrowUp: (s) => turn(s, 0, turnStep_deg), ArrowDown: (s) => turn(s, 0, -turnStep_deg),
  w: (s) => walk(s, 0, 1), s: (s) => walk(s, 0, -1), a: (s) => walk(s, -1, 0), d: (s) => walk(s, 1, 0),
};

/** `panels` says how many pictures stand side by side; `moved` hears of the pointer alone. */
export function pointOn(canvas: HTMLCanvasElement, change: Change, panels: () => number, moved: () => void): Pointing {
  const pointing: Pointing = { at: { x: 0.5, y: 0.5 } };
  let last: { x: number; y: number } | null = null;
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    last = { x: event.clientX, y: event.clientY };
  });
  canvas.addEventListener('pointerup', () => { last = null; });
  canvas.addEventListener('pointermove', (event) => {
    const box = canvas.getBoundingClientRect(), count = panels(), x = ((event.clientX - box.left) / box.width) * count;
    pointing.at = { x: within(x - Math.floor(within(x, 0, count - 1e-6)), 0, 1), y: within((event.clientY - box.top) / box.height, 0, 1) };
    if (last && event.buttons) {
      const from = last, to = { x: event.clientX, y: event.clientY }, scale = count / box.width;
      last = to;
      change((s) => {
        const aspect = (box.width / count) / box.height, wide = s.camera.field_deg * aspect;
        turn(s, (from.x - to.x) * scale * wide, (to.y - from.y) * scale * wide);
      });
    } else {
      moved();
    }
  });
  canvas.addEventListener('keydown', (event) => {
    const act = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];  // also with Caps Lock
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    change(act);
  });
  return pointing;
}
