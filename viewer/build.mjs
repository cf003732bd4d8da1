// Builds the page: one HTML file with everything inside. `node build.mjs [--core FILE.js] [--out FILE.html]`.
import { readFile, writeFile, mkdir } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const { values } = parseArgs({ options: {
  core: { type: 'string', default: join(here, '../build/wasm/sturm_core.js') },
  out: { type: 'string', default: join(here, '../build/viewer/viewer.html') },
} });

async function bundle(file) {
  const built = await build({
    entryPoints: [join(here, 'src', file)], bundle: true, minify: true, write: false, format: 'iife', target: 'es2022', loader: { '.glsl': 'text' }, legalComments: 'none', charset: 'utf8',
  });
  return built.outputFiles[0].text;
}

async function licence(name) {
  const { version, license } = JSON.parse(await readFile(join(here, 'node_modules', name, 'package.json'), 'utf8'));
  return `${name} ${version} (${license})\n\n${await readFile(join(here, 'node_modules', name, 'LICENSE'), 'utf8')}`;
}

// A closing tag inside of a script would end it.
const script = (text, attributes = '') => `<script${attributes}>\n${text.replaceAll('</script', '<\\/script')}\n</script>`;
const put = (page, place, text) => {
  if (page.split(place).length !== 2) throw new Error(`page.html: expected ${place} once`);
  return page.replace(place, () => text);
};

const licences = (await Promise.all(['three', 'three-mesh-bvh'].map(licence))).join('\n\n').replaceAll('-->', '');
let page = await readFile(join(here, 'src/page.html'), 'utf8');
page = put(page, '/* style.css */', await readFile(join(here, 'src/style.css'), 'utf8'));
page = put(page, '<!-- scripts -->', [`<!--\nParts of this page are by others.\n\n${licences}\n-->`, script(await readFile(values.core, 'utf8'), ' id="sturm-core"'),
  script(await bundle('lens_worker.ts'), ' id="lens-worker" type="text/plain"'), script(await bundle('main.ts'))].join('\n'));
await mkdir(dirname(values.out), { recursive: true });
await writeFile(values.out, page);
console.log(`${values.out}: ${page.length} characters`);
