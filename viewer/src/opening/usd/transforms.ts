/** Transformations of prims (OpenUSD, "UsdGeomXformable"): all operations of each as one matrix, the only one that three takes in any order. */
import { Euler, type EulerOrder, Matrix4, Quaternion } from 'three';
import { numbersOf, specType, type Specs } from './specs';

/** The first turn of USD's name acts first; three's name begins with the one that acts last. */
function turned(kind: string, degrees: number[]): Matrix4 {
  const axes = kind.slice('rotate'.length), radians = degrees.map((x) => (x * Math.PI) / 180), about: Record<string, number> = { X: 0, Y: 0, Z: 0 };
  if (axes.length === 1) about[axes] = radians[0] ?? 0;
  else ['X', 'Y', 'Z'].forEach((axis, k) => { about[axis] = radians[k] ?? 0; });
  const order = axes.length === 1 ? 'XYZ' : [...axes].reverse().join('');
  return new Matrix4().makeRotationFromEuler(new Euler(about.X, about.Y, about.Z, order as EulerOrder));
}

function matrixOf(kind: string, value: number[]): Matrix4 | null {
  const [x = 0, y = 0, z = 0, w = 0] = value;
  if (kind === 'translate') return new Matrix4().makeTranslation(x, y, z);
  if (kind === 'scale') return new Matrix4().makeScale(x, y, z);
  if (kind === 'orient') return new Matrix4().makeRotationFromQuaternion(new Quaternion(x, y, z, w).normalize());
  // USD's rows, of vectors before the matrix, are three's columns.
  if (kind === 'transform' && value.length === 16) return new Matrix4().fromArray(value);
  if (/^rotate(?:[XYZ]|XYZ|XZY|YXZ|YZX|ZXY|ZYX)$/.test(kind)) return turned(kind, value);
  return null;
}

/** Of `!invert!xformOp:KIND[:NAME]`. */
function operation(specs: Specs, path: string, stated: string): Matrix4 {
  const inverse = stated.startsWith('!invert!'), name = inverse ? stated.slice('!invert!'.length) : stated, kind = name.split(':')[1] ?? '', value = specs[`${path}.${name}`]?.fields.default;
  if (value === undefined) return new Matrix4();
  const matrix = matrixOf(kind, numbersOf(value));
  if (!matrix) throw new Error(`${path} is moved by ${name}, which is not known`);
  return inverse ? matrix.invert() : matrix;
}

/** States each prim's place as `xformOp:transform` alone. */
export function asOneMatrixEach(specs: Specs): void {
  for (const path of Object.keys(specs)) {
    if (specs[path]?.specType !== specType.prim) continue;
    const order = specs[`${path}.xformOpOrder`]?.fields ?? specs[path]?.fields, names = (order?.default ?? order?.xformOpOrder) as string[] | undefined;
    if (!Array.isArray(names) || names.length === 0) continue;
    if (names.includes('!resetXformStack!')) throw new Error(`${path} leaves the places of its parents (!resetXformStack!), which is not read`);
    const matrix = new Matrix4();
    for (const name of names) matrix.multiply(operation(specs, path, name));
    specs[`${path}.xformOp:transform`] = { specType: specType.attribute, fields: { typeName: 'matrix4d', default: matrix.toArray() } };
    specs[`${path}.xformOpOrder`] = { specType: specType.attribute, fields: { typeName: 'token[]', default: ['xformOp:transform'] } };
    delete specs[path]?.fields.xformOpOrder;
  }
}
