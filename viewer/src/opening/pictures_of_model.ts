/** Pictures of a model's textures as the scene has them: linear, the upper row first, together not too large. */
import { ClampToEdgeWrapping, MirroredRepeatWrapping, NearestFilter, type Texture } from 'three';
import type { Picture, TextureMap } from '../scene_file';
import { mostPixels, mostTexels } from './limits';

/** `alpha`: its fourth channel alone. */
export type Reading = 'colour' | 'alpha';
interface Source { image: CanvasImageSource & { width: number; height: number }; reading: Reading }

export function linearOf(stored: number): number {
  return stored <= 0.04045 ? stored / 12.92 : ((stored + 0.055) / 1.055) ** 2.4;
}

const linearOfByte = Float32Array.from({ length: 256 }, (_, k) => linearOf(k / 255));

function bytesOf(image: Source['image'], width: number, height: number): Uint8ClampedArray {
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true, colorSpace: 'srgb' });
  if (!context) throw new Error('a picture could not be read');
  context.imageSmoothingQuality = 'high';
  context.drawImage(image, 0, 0, width, height);
  return context.getImageData(0, 0, width, height).data;
}

/** Of stored values 0 … 1, on at most 256 × 256 places. */
export function meanOf(texture: Texture, decoded: boolean): [number, number, number] {
  const image = imageOf(texture), width = Math.min(256, image.width), height = Math.min(256, image.height), bytes = bytesOf(image, width, height), sum: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < width * height; ++i) for (let c = 0; c < 3; ++c) sum[c] = (sum[c] ?? 0) + (decoded ? linearOfByte[bytes[4 * i + c] ?? 0] ?? 0 : (bytes[4 * i + c] ?? 0) / 255);
  return sum.map((x) => x / (width * height)) as [number, number, number];
}

function imageOf(texture: Texture): Source['image'] {
  const image = texture.image as Source['image'] | null;
  if (!image || !(image.width > 0) || !(image.height > 0)) throw new Error(`the picture ${texture.name || 'of a texture'} cannot be decoded`);
  if (image.width * image.height > mostPixels) throw new Error(`the picture ${texture.name} has ${image.width} × ${image.height} pixels; this page takes up to ${mostPixels}`);
  return image;
}

const wrapOf = (wrapping: number) => (wrapping === ClampToEdgeWrapping ? 'clamp' : wrapping === MirroredRepeatWrapping ? 'mirror' : 'repeat');

export class PicturesOfModel {
  private readonly sources: Source[] = [];
  /** Of each side, so that all fit. */
  private get scale(): number {
    const texels = this.sources.reduce((sum, s) => sum + s.image.width * s.image.height, 0);
    return Math.min(1, Math.sqrt(mostTexels / texels));
  }

  private numberOf(image: Source['image'], reading: Reading): number {
    const known = this.sources.findIndex((s) => s.image === image && s.reading === reading);
    return known >= 0 ? known : this.sources.push({ image, reading }) - 1;
  }

  /** Coordinates of the scene run upwards, those of a texture that is not flipped run downwards. */
  map(texture: Texture | null, reading: Reading): TextureMap | null {
    if (!texture) return null;
    if (texture.matrixAutoUpdate) texture.updateMatrix();
    const [a, b, , c, d, , e, f] = texture.matrix.elements as unknown as number[] as [number, number, number, number, number, number, number, number];
    // Columns (a, b), (c, d), (e, f); with v and the result's v turned about for a picture that is not flipped.
    const matrix = texture.flipY ? [a, c, e, b, d, f] : [a, -c, c + e, -b, d, 1 - d - f];
    return { texture: this.numberOf(imageOf(texture), reading), matrix, wrap: [wrapOf(texture.wrapS), wrapOf(texture.wrapT)] };
  }

  static isNearest(texture: Texture | null): boolean {
    return texture?.magFilter === NearestFilter;
  }

  pictures(): Picture[] {
    const { scale } = this;
    return this.sources.map(({ image, reading }) => {
      const width = Math.max(1, Math.floor(scale * image.width)), height = Math.max(1, Math.floor(scale * image.height)), bytes = bytesOf(image, width, height);
      const channels = reading === 'alpha' ? 1 : 3, values = new Float32Array(channels * width * height);
      for (let i = 0; i < width * height; ++i)
        if (reading === 'alpha') values[i] = (bytes[4 * i + 3] ?? 0) / 255;
        else for (let k = 0; k < 3; ++k) values[3 * i + k] = linearOfByte[bytes[4 * i + k] ?? 0] ?? 0;
      return { width, height, channels, values };
    });
  }

  notes(): string[] {
    const { scale } = this;
    return scale < 1 ? [`Textures are drawn at ${(100 * scale).toFixed(0)} % of their size along each side.`] : [];
  }
}
