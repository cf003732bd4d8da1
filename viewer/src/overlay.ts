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

  /** `panels` copies beside each other, each `width` × `height` picture pixels. */
  show(width: number, height: number, panels: number, pointer: PlacedEllipse | null, field: PlacedEllipse[], rim: [number, number][]): void {
    this.element.setAttribute('viewBox', `0 0 ${width * panels} ${height}`);
    const shapes: SVGElement[] = [];
    for (let k = 0; k < panels; ++k) {
      const moved = (e: PlacedEllipse) => ({ ...e, x: e.x + k * width });
      if (rim.length > 0) shapes.push(svg('polygon', { class: 'rim', points: rim.map(([x, y]) => `${(x + k * width).toFixed(1)},${y.toFixed(1)}`).join(' ') }));
      for (const e of field) shapes.push(drawn(moved(e), 'field'));
      if (pointer) shapes.push(drawn(moved(pointer), 'under'), drawn(moved(pointer), 'pointer'));
    }
    this.element.replaceChildren(...shapes);
  }
}
