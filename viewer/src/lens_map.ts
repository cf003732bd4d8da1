/** A map of the lens: how far what lies at one distance is out of focus through each of its places, for an eye that turns to it. */
import type { Optics } from './core_module';
import { byId, element } from './elements';

const nodes = 45, widest = 1.5;
/** Errors up to so many dioptres have the colour beside them. */
const bands: readonly (readonly [number, string])[] = [[0.125, '#fff7c2'], [0.25, '#fed976'], [0.5, '#fd9f44'], [1, '#e5552b'], [2, '#a3174f'], [Infinity, '#41104f']];
const names = ['to ⅛ D', '¼', '½', '1', '2', 'more'];

const colourOf = (error: number) => bands.find(([most]) => error <= most)?.[1] ?? '';

/** Azimuth and elevation of slopes from straight ahead, over a square. */
function gazes(): Float64Array {
  const list = new Float64Array(2 * nodes * nodes);
  for (let j = 0; j < nodes; ++j)
    for (let i = 0; i < nodes; ++i) {
      const x = widest * ((2 * i) / (nodes - 1) - 1), y = widest * (1 - (2 * j) / (nodes - 1));
      list.set([Math.atan(x), Math.asin(y / Math.hypot(x, y, 1))], 2 * (j * nodes + i));
    }
  return list;
}

export class LensMap {
  private readonly canvas = byId<HTMLCanvasElement>('lens-map-picture');
  private readonly caption = byId('lens-map-words');
  private readonly gazes = gazes();
  private key = '';
  private timer = 0;

  constructor() {
    byId('lens-map-key').append(...bands.map(([, colour], k) => {
      const swatch = element('span', { className: 'swatch' });
      swatch.style.background = colour;
      return element('li', {}, swatch, names[k] ?? '');
    }));
  }

  hide(): void {
    byId('lens-map').hidden = true;
    this.key = '';
  }

  /** `worn` says what eye and lens they are; the map follows a little later, since it takes as long as some frames. */
  show(optics: Optics, worn: string, distance_m: number): void {
    byId('lens-map').hidden = false;
    const vergence = Math.round(20 / distance_m) / 20, key = `${worn} ${vergence}`;
    if (key === this.key) return;
    this.key = key;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => { if (key === this.key) this.draw(optics.errors(this.gazes, 1 / vergence), 1 / vergence); }, 120);
  }

  private draw(errors: Float32Array, distance_m: number): void {
    const { canvas } = this, context = canvas.getContext('2d');
    if (!context) return;
    let reach = 0, area = 0, clear = 0, worst = 0;
    for (let k = 0; k < errors.length; k += 4) if (errors[k + 3]) reach = Math.max(reach, Math.hypot(errors[k] ?? 0, errors[k + 1] ?? 0));
    const scale = (0.48 * canvas.width) / (reach || 1), place = (k: number): [number, number] => [0.5 * canvas.width + scale * (errors[k] ?? 0), 0.5 * canvas.height - scale * (errors[k + 1] ?? 0)];
    context.clearRect(0, 0, canvas.width, canvas.height);
    for (let j = 0; j + 1 < nodes; ++j)
      for (let i = 0; i + 1 < nodes; ++i) {
        const corners = [j * nodes + i, j * nodes + i + 1, (j + 1) * nodes + i + 1, (j + 1) * nodes + i].map((n) => 4 * n).filter((k) => errors[k + 3]);
        if (corners.length < 3) continue;
        const error = corners.reduce((sum, k) => sum + (errors[k + 2] ?? 0), 0) / corners.length, points = corners.map(place), size = areaOf(points);
        area += size;
        if (error <= 0.125) clear += size;
        worst = Math.max(worst, error);
        context.beginPath();
        points.forEach(([x, y], n) => (n ? context.lineTo(x, y) : context.moveTo(x, y)));
        context.closePath();
        context.fillStyle = context.strokeStyle = colourOf(error);
        context.fill();
        context.stroke();
      }
    const where = Number.isFinite(distance_m) ? `${distance_m.toFixed(2)} m` : 'infinity';
    this.caption.textContent = `The lens as its wearer sees it. What lies at ${where} is clear to ⅛ D through ${((100 * clear) / (area || 1)).toFixed(0)} % of it; the largest error is ${worst.toFixed(2)} D.`;
  }
}

function areaOf(points: [number, number][]): number {
  return Math.abs(points.reduce((sum, [x, y], k) => {
    const [u, v] = points[(k + 1) % points.length] ?? [0, 0];
    return sum + 0.5 * (x * v - u * y);
  }, 0));
}
