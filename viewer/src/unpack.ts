/** The second part of the page (src/opening), unpacked when it is first needed. */
import { element } from './elements';
import type { Opening, OpeningFactory } from './opening/opening_api';
import { textOf, unzipped } from './view_data';

let unpacked: Promise<Opening> | null = null;

async function unpack(): Promise<Opening> {
  const packed = textOf('sturm-opening');
  if (!packed) throw new Error('This page was built without what opens files.');
  // A script's length, the script, and the WebAssembly module of the readers (build.mjs).
  const bytes = await unzipped(packed), length = new DataView(bytes).getUint32(0, true);
  // A script in the page itself is what its content security policy allows.
  document.head.append(element('script', { textContent: new TextDecoder().decode(new Uint8Array(bytes, 4, length)) }));
  const { sturmOpening } = globalThis as { sturmOpening?: OpeningFactory };
  if (!sturmOpening) throw new Error('What opens files could not be started.');
  return sturmOpening(new Uint8Array(bytes, 4 + length));
}

export function loadOpening(): Promise<Opening> {
  return (unpacked ??= unpack());
}
