/** Converts a USD scene to a binary glTF file. */
import { existsSync, readFileSync, renameSync, statSync, unlinkSync, writeFileSync } from 'node:fs';
import { basename, dirname, resolve } from 'node:path';
import { LoadingManager } from 'three';
import { readUsd } from '../src/opening/usd/usd_file';
import { GlbOfScene } from './glb_of_scene';
import { PictureKeeper } from './kept_pictures';

const usage = 'Usage: scripts/convert_usd SCENE.usdz SCENE.glb';

class UserError extends Error {}

function paths(): [string, string] {
  const [source, target, ...more] = process.argv.slice(2);
  if (source === '--help' || source === '-h') {
    console.log(`${usage}\n\nConverts a USD scene (.usd, .usda, .usdc, .usdz) to a binary glTF file, which Sturm reads. docs/formats/scene.md says what of it arrives.`);
    process.exit(0);
  }
  if (!source || !target || more.length > 0 || !target.toLowerCase().endsWith('.glb')) throw new UserError(usage);
  return [source, target];
}

function bytesOf(path: string): ArrayBuffer {
  const bytes = readFileSync(path);
  return bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
}

async function convert(source: string, target: string): Promise<string[]> {
  if (!existsSync(source) || !statSync(source).isFile()) throw new UserError(`${source}: no such file`);
  const folder = dirname(resolve(source)), pictures = new PictureKeeper(), glb = new GlbOfScene();
  const find = (key: string) => (existsSync(resolve(folder, key)) && statSync(resolve(folder, key)).isFile() ? bytesOf(resolve(folder, key)) : null);
  const scene = readUsd(basename(source), bytesOf(source), find, new LoadingManager(), pictures);
  if (scene.missing.length > 0) throw new Error(`it names the file ${scene.missing.join(', ')}, which is not there`);
  await scene.settled;
  pictures.requireAll();
  glb.add(scene.root);
  if (glb.triangles === 0) throw new Error('there is no surface in it');
  const parts = `${target}.part`;
  try {
    writeFileSync(parts, await glb.bytes());
    renameSync(parts, target);
  } catch (problem) {
    if (existsSync(parts)) unlinkSync(parts);
    throw new UserError(`${target}: cannot be written (${(problem as Error).message})`);
  }
  return [...scene.notes, ...glb.notes];
}

let source = '';
try {
  const [from, to] = paths();
  source = from;
  for (const note of await convert(from, to)) console.error(`note: ${note}`);
} catch (problem) {
  console.error(`error: ${problem instanceof UserError ? '' : `${source}: `}${(problem as Error).message}`);
  process.exit(2);
}
