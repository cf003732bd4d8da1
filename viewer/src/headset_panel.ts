/** What stands on the panel in the headset: sliders with a button at each end, and buttons. It is painted, and says what a press at a place does. */
import { signed, type Change } from './controls';
import { element } from './elements';
import { ranges, type EyeState, type Side, type State } from './state';

interface Slider { label: string; range: keyof typeof ranges; unit: string; digits: number; of(eye: EyeState): number; set(eye: EyeState, x: number): void }
interface Choice { text: string; isOn: boolean; press(): void }

/** Follows a press while it is held: the place along the panel, 0 … 1. */
export type Drag = (x: number) => void;

const width = 640, rowHeight = 72, less = 150, track = 210, trackEnd = 460, more = 470, value = 530;
const ink = '#f2f4f7', ground = '#15181d', field = '#343b46', chosen = '#0b5c9e';

const sliders: readonly Slider[] = [
  { label: 'SPH', range: 'sphere_D', unit: ' D', digits: 2, of: (e) => e.sphere_D, set: (e, x) => { e.sphere_D = x; } },
  { label: 'CYL', range: 'cylinder_D', unit: ' D', digits: 2, of: (e) => e.cylinder_D, set: (e, x) => { e.cylinder_D = x; } },
  { label: 'AXIS', range: 'axis_deg', unit: '°', digits: 0, of: (e) => e.axis_deg, set: (e, x) => { e.axis_deg = x; } },
  { label: 'Pupil', range: 'pupil_mm', unit: ' mm', digits: 1, of: (e) => e.pupil_mm, set: (e, x) => { e.pupil_mm = x; } },
];
const focus: Slider = { label: 'Focus', range: 'focus_D', unit: ' D', digits: 2, of: (e) => e.focus_D, set: (e, x) => { e.focus_D = x; e.accommodation = 'fixed'; } };
const amplitude: Slider = { label: 'Amplitude', range: 'amplitude_D', unit: ' D', digits: 2, of: (e) => e.amplitude_D, set: (e, x) => { e.amplitude_D = x; } };

export class HeadsetPanel {
  readonly canvas = element('canvas', { width, height: 8 * rowHeight });
  side: Side = 'right';
  /** What is painted is not what is so. */
  isStale = true;
  /** The picture without blur until this is pressed again. */
  sharp = false;

  constructor(private readonly state: () => State, private readonly change: Change, private readonly leave: () => void) {}

  /** Row by row from the top. */
  private rows(): (Slider | Choice[])[] {
    const state = this.state(), eye = state.eyes[this.side], glasses = state.glasses[this.side];
    const wear = (text: string, kind: typeof glasses.kind): Choice => ({ text, isOn: glasses.kind === kind, press: () => this.change((s) => { s.glasses[this.side].kind = kind; }) });
    const look = (text: string, side: Side): Choice => ({ text, isOn: this.side === side, press: () => { this.side = side; } });
    return [
      [look('Left eye', 'left'), look('Right eye', 'right')], ...sliders, eye.accommodation === 'best' ? amplitude : focus,
      [wear('No glasses', 'none'), wear('Single vision', 'single'), wear('Progressive', 'progressive')],
      [{ text: 'See sharply', isOn: this.sharp, press: () => { this.sharp = !this.sharp; } }, { text: 'Leave', isOn: false, press: this.leave }],
    ];
  }

  /** Of a place 0 … 1 from the upper left corner; a press on a slider's track can be dragged. */
  press(x: number, y: number): Drag | null {
    const row = this.rows()[Math.floor((y * this.canvas.height) / rowHeight)], at = x * width;
    if (!row) return null;
    this.isStale = true;
    if (Array.isArray(row)) {
      row[Math.floor(x * row.length)]?.press();
      return null;
    }
    const [least, largest, step] = ranges[row.range];
    const set = (number: number) => this.change((s) => row.set(s.eyes[this.side], Math.min(largest, Math.max(least, Number((step * Math.round(number / step)).toFixed(6))))));
    if (at >= less && at < track) set(row.of(this.state().eyes[this.side]) - step);
    else if (at >= more && at < value) set(row.of(this.state().eyes[this.side]) + step);
    else if (at >= track && at < more) {
      const drag = (along: number) => set(least + ((largest - least) * (along * width - track)) / (trackEnd - track));
      drag(x);
      return drag;
    }
    return null;
  }

  paint(): void {
    const context = this.canvas.getContext('2d');
    if (!context) return;
    this.isStale = false;
    context.fillStyle = ground;
    context.fillRect(0, 0, width, this.canvas.height);
    context.font = '28px system-ui, sans-serif';
    context.textBaseline = 'middle';
    this.rows().forEach((row, k) => {
      const top = k * rowHeight;
      if (Array.isArray(row)) row.forEach(({ text, isOn }, n) => button(context, (n * width) / row.length, top, width / row.length, text, isOn));
      else this.paintSlider(context, row, top);
    });
  }

  private paintSlider(context: CanvasRenderingContext2D, row: Slider, top: number): void {
    const [least, largest] = ranges[row.range], number = row.of(this.state().eyes[this.side]), middle = top + rowHeight / 2;
    button(context, less, top, track - less - 10, '−', false);
    button(context, more, top, value - more - 6, '+', false);
    context.fillStyle = field;
    context.fillRect(track, middle - 5, trackEnd - track, 10);
    context.fillStyle = ink;
    context.beginPath();
    context.arc(track + ((trackEnd - track) * (number - least)) / (largest - least), middle, 12, 0, 2 * Math.PI);
    context.fill();
    context.textAlign = 'left';
    context.fillText(row.label, 12, middle, less - 18);
    context.textAlign = 'right';
    context.fillText(`${signed(number, row.digits, least < 0)}${row.unit}`, width - 10, middle, width - value - 12);
  }
}

function button(context: CanvasRenderingContext2D, left: number, top: number, wide: number, text: string, isOn: boolean): void {
  context.fillStyle = isOn ? chosen : field;
  context.fillRect(left + 4, top + 8, wide - 8, rowHeight - 16);
  context.fillStyle = ink;
  context.textAlign = 'center';
  context.fillText(text, left + wide / 2, top + rowHeight / 2, wide - 16);
}
