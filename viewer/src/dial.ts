/** A TABO dial: the AXIS as an examiner who faces the wearer writes it, counter-clockwise from his right, the upper half of a circle. */
import { svg } from './elements';

export interface Dial {
  element: SVGSVGElement;
  show(axis_deg: number): void;
}

const radius = 62, centre = { x: 90, y: 84 };

export function axisDial(changed: (axis_deg: number) => void): Dial {
  const line = svg('line', { class: 'axis', x1: centre.x, y1: centre.y, x2: centre.x, y2: centre.y });
  const knob = svg('circle', { class: 'knob', r: 8 });
  const at = (deg: number, r: number) => ({ x: centre.x + r * Math.cos((deg * Math.PI) / 180), y: centre.y - r * Math.sin((deg * Math.PI) / 180) });
  const numbers = [0, 30, 60, 90, 120, 150, 180].map((deg) => {
    const { x, y } = at(deg, radius + 18);
    return svg('text', { x, y: y + 3 }, String(deg));
  });
  // The slider beside it is what keyboards and screen readers use.
  const drawing = svg('svg', { class: 'dial', viewBox: '0 0 180 104', 'aria-hidden': 'true' },
    svg('path', { class: 'scale', d: `M ${centre.x - radius} ${centre.y} A ${radius} ${radius} 0 0 1 ${centre.x + radius} ${centre.y} Z` }), ...numbers, line, knob);
  const drag = (event: PointerEvent) => {
    const box = drawing.getBoundingClientRect(), scale = 180 / box.width;
    const x = (event.clientX - box.left) * scale - centre.x, y = centre.y - (event.clientY - box.top) * scale;
    const deg = Math.round((Math.atan2(Math.max(0, y), x) * 180) / Math.PI);
    changed(deg === 0 ? 180 : deg);
  };
  drawing.addEventListener('pointerdown', (event) => {
    drawing.setPointerCapture(event.pointerId);
    drag(event);
  });
  drawing.addEventListener('pointermove', (event) => {
    if (drawing.hasPointerCapture(event.pointerId)) drag(event);
  });
  return {
    element: drawing,
    show(axis_deg) {
      const end = at(axis_deg, radius);
      line.setAttribute('x2', String(end.x));
      line.setAttribute('y2', String(end.y));
      knob.setAttribute('cx', String(end.x));
      knob.setAttribute('cy', String(end.y));
    },
  };
}
