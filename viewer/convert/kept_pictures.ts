/** Pictures of textures outside of a browser: their files as they are, decoded only for a mean. */
import { resolveObjectURL } from 'node:buffer';
import jpeg from 'jpeg-js';
import { PNG } from 'pngjs';

export interface KeptPicture { bytes: Uint8Array; mimeType: 'image/png' | 'image/jpeg' }

function kept(bytes: Uint8Array): KeptPicture {
  if (bytes[0] === 0x89 && bytes[1] === 0x50) return { bytes, mimeType: 'image/png' };
  if (bytes[0] === 0xff && bytes[1] === 0xd8) return { bytes, mimeType: 'image/jpeg' };
  throw new Error('a picture of it is neither PNG nor JPEG, the two kinds that glTF has');
}

/** In the place of three's loader of images; the first failure is thrown by `requireAll`. */
export class PictureKeeper {
  private problem: unknown = null;

  load(url: string, onLoad: (picture: KeptPicture) => void, _: unknown, onError: () => void): void {
    const bytes = resolveObjectURL(url)?.arrayBuffer();
    Promise.resolve(bytes).then((found) => onLoad(kept(new Uint8Array(found ?? [])))).catch((problem: unknown) => {
      this.problem ??= problem;
      onError();
    });
  }

  requireAll(): void {
    if (this.problem !== null) throw this.problem;
  }
}

/** Of the stored values 0 … 1 of red, green and blue. */
export function meanOf({ bytes, mimeType }: KeptPicture): [number, number, number] {
  const { data } = mimeType === 'image/png' ? PNG.sync.read(Buffer.from(bytes)) : jpeg.decode(bytes, { useTArray: true }), sum: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < data.length; i += 4) for (let c = 0; c < 3; ++c) sum[c] = (sum[c] ?? 0) + (data[i + c] ?? 0);
  return sum.map((x) => x / 255 / (data.length / 4)) as [number, number, number];
}
