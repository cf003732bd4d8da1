// Builds the page: one HTML file with everything inside. `node build.mjs [--core FILE.js] [--readers FILE.js] [--out FILE.html]`.
import { readFile, writeFile, mkdir } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const { values } = parseArgs({ options: {
  core: { type: 'string', default: join(here, '../build/wasm/sturm_core.js') },
  readers: { type: 'string', default: join(here, '../build/wasm/sturm_readers.js') },
  out: { type: 'string', default: join(here, '../build/viewer/viewer.html') },
} });

const bundled = async (entry, options = {}) => (await build({
  entryPoints: [join(here, entry)], bundle: true, minify: true, write: false, format: 'iife', target: 'es2022', loader: { '.glsl': 'text' }, legalComments: 'none', charset: 'utf8', ...options,
})).outputFiles[0].text;

async function licence(name) {
  const { version, license } = JSON.parse(await readFile(join(here, 'node_modules', name, 'package.json'), 'utf8'));
  return `${name} ${version} (${license})\n\n${await readFile(join(here, 'node_modules', name, 'LICENSE'), 'utf8')}`;
}

/** Notices within files of a library that hold other people's work. */
async function notice(file, pattern) {
  const found = pattern.exec(await readFile(join(here, 'node_modules', file), 'utf8'));
  if (!found) throw new Error(`${file}: expected its notice`);
  return `In ${file}\n\n${found[0].replace(/^(\/\/ ?)+/gm, '')}`;
}

/** Libraries of the WebAssembly modules, as Debian's packages state them. */
const debian = async (name) => `${name}\n\n${await readFile(`/usr/share/doc/${name}/copyright`, 'utf8')}`;

// A closing tag inside of a script would end it.
const script = (text, attributes = '') => `<script${attributes}>\n${text.replaceAll('</script', '<\\/script')}\n</script>`;
const put = (page, place, text) => {
  if (page.split(place).length !== 2) throw new Error(`page.html: expected ${place} once`);
  return page.replace(place, () => text);
};

const licences = (await Promise.all([
  ...['three', 'three-mesh-bvh'].map(licence), ...['libeigen3-dev', 'nlohmann-json3-dev', 'libvalijson-dev'].map(debian),
  notice('three/examples/jsm/loaders/EXRLoader.js', /\/\/ Copyright[^]*End of OpenEXR license/), notice('three/examples/jsm/libs/fflate.module.js', /\/\*![^]*?\*\//),
])).join('\n\n').replaceAll('-->', '').replaceAll('<!--', '');
let page = await readFile(join(here, 'src/page.html'), 'utf8');
page = put(page, '/* style.css */', await readFile(join(here, 'src/style.css'), 'utf8'));
// What opens files is large, and most readers never need it.
// WebAssembly in base64 packs badly, so it goes beside its script.
const inBase64 = /data:application\/octet-stream;base64,([A-Za-z0-9+/=]+)/, readers = await readFile(values.readers, 'utf8'), [, module] = inBase64.exec(readers) ?? [];
if (!module) throw new Error(`${values.readers}: expected a module in base64`);
const openingScript = Buffer.from(`${readers.replace(inBase64, 'readers.wasm')}\n${await bundled('src/opening/opening.ts', { inject: [join(here, 'src/opening/said.ts')], define: { 'console.warn': 'remark', 'console.error': 'remark' } })}`);
const scriptLength = Buffer.alloc(4);
scriptLength.writeUInt32LE(openingScript.length);
const opening = Buffer.concat([scriptLength, openingScript, Buffer.from(module, 'base64')]);
page = put(page, '<!-- opening -->', gzipSync(opening, { level: 9 }).toString('base64'));
page = put(page, '<!-- scripts -->', [`<!--\nParts of this page are by others.\n\n${licences}\n-->`, script(await readFile(values.core, 'utf8'), ' id="sturm-core"'),
  script(await bundled('src/lens_worker.ts'), ' id="lens-worker" type="text/plain"'), script(await bundled('src/main.ts'))].join('\n'));
await mkdir(dirname(values.out), { recursive: true });
await writeFile(values.out, page);
console.log(`${values.out}: ${page.length} characters`);
