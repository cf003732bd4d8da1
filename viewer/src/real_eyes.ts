/** Measured eyes that come with the program (configs/eyes). */
import hofer from '../../configs/eyes/hofer_5.json';
import jaekenRight from '../../configs/eyes/jaeken_36_right.json';
import jaekenLeft from '../../configs/eyes/jaeken_4_left.json';
import polans from '../../configs/eyes/polans_5.json';

export interface RealEye {
  title: string;
  file: string;
  /** A sturm.eye/1 document. */
  document: { wavefront: { coefficients_um: Record<string, number> } };
}

export const realEyes: readonly RealEye[] = [
  { title: 'Coma and trefoil (Hofer 5)', file: 'hofer_5.json', document: hofer },
  { title: 'Oblique astigmatism (Jaeken 36)', file: 'jaeken_36_right.json', document: jaekenRight },
  { title: 'Left eye with coma (Jaeken 4)', file: 'jaeken_4_left.json', document: jaekenLeft },
  { title: 'Myopia and coma (Polans 5)', file: 'polans_5.json', document: polans },
];

/** Whether a wavefront is that of the eye: its coefficients are those of the file. */
export function isOf(eye: RealEye, coefficients_m: readonly number[]): boolean {
  return Object.entries(eye.document.wavefront.coefficients_um).every(([j, c]) => Math.abs(1e6 * (coefficients_m[Number(j)] ?? 0) - c) < 1e-9);
}
