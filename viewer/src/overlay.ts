/** Blur ellipses over the picture at their true size. */
import type { PictureEllipse } from './core_module';
import { byId, svg } from './elements';

export interface PlacedEllipse { x: number; y: number; ellipse: PictureEllipse }

function drawn({ x, y, ellipse }: PlacedEllipse, kind: string): SVGElement {
  const [major, minor] = ellipse.semi_axes_px, turn = -(ellipse.orientation_deg ?? 0);
  return svg('ellipse', { class: kind, cx: x, cy: y, rx: Math.max(major, 0.2), ry: Math.max(minor, 0.2), transform: `rotate(${turn} ${x} ${y})` });
}

export class Overlay {
  private readonly element = byId<SVGSVGElement>('overlay');

  /** A copy for each panel, which stand beside each other, each `width` × `height` picture pixels; several have their names in a corner. */
  show(width: number, height: number, names: readonly string[], pointer: PlacedEllipse | null, field: PlacedEllipse[], rim: [number, number][]): void {
    this.element.setAttribute('viewBox', `0 0 ${width * names.length} ${height}`);
    const shapes: SVGElement[] = [];
    for (let k = 0; k < names.length; ++k) {
      const moved = (e: PlacedEllipse) => ({ ...e, x: e.x + k * width });
      if (rim.length > 0) shapes.push(svg('polygon', { class: 'rim', points: rim.map(([x, y]) => `${(x + k * width).toFixed(1)},${y.toFixed(1)}`).join(' ') }));
      for (const e of field) shapes.push(drawn(moved(e), 'field'));
      if (pointer) shapes.push(drawn(moved(pointer), 'under'), drawn(moved(pointer), 'pointer'));
      if (k > 0) shapes.push(svg('line', { class: 'seam', x1: k * width, x2: k * width, y1: 0, y2: height }));
      if (names.length > 1) shapes.push(svg('text', { x: (k + 0.015) * width, y: 0.06 * height, 'font-size': 0.045 * height }, names[k] ?? ''));
    }
    this.element.replaceChildren(...shapes);
  }
}
