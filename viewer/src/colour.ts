/** Linear colours with Rec. 709 primaries. */
export function luminance(colour: ArrayLike<number>): number {
  return 0.2126 * (colour[0] ?? 0) + 0.7152 * (colour[1] ?? 0) + 0.0722 * (colour[2] ?? 0);
}
