/** The shaders, put together and compiled when they are first needed. */
import aTrous from '../shaders/a_trous.frag.glsl';
import add from '../shaders/add.frag.glsl';
import bake from '../shaders/bake.frag.glsl';
import common from '../shaders/common.glsl';
import displace from '../shaders/displace.frag.glsl';
import environment from '../shaders/environment.glsl';
import eye from '../shaders/eye.frag.glsl';
import fill from '../shaders/fill.vert.glsl';
import illumination from '../shaders/illumination.frag.glsl';
import intersect from '../shaders/intersect.glsl';
import light from '../shaders/light.glsl';
import meshFragment from '../shaders/mesh.frag.glsl';
import meshVertex from '../shaders/mesh.vert.glsl';
import panelFragment from '../shaders/panel.frag.glsl';
import panelVertex from '../shaders/panel.vert.glsl';
import random from '../shaders/random.glsl';
import rayModels from '../shaders/ray_models.glsl';
import scatter from '../shaders/scatter.glsl';
import show from '../shaders/show.frag.glsl';
import sight from '../shaders/sight.glsl';
import slopes from '../shaders/slopes.frag.glsl';
import smooth from '../shaders/smooth.frag.glsl';
import surfaces from '../shaders/surfaces.glsl';
import surroundings from '../shaders/surroundings.frag.glsl';
import trace from '../shaders/trace.glsl';
import type { Gpu, Program } from './gpu';

const version = '#version 300 es\n';
const tracing = [intersect, surfaces, environment, random, scatter, light, trace];
const seeing = [rayModels, sight];
const sources = {
  eye: [[fill], [...seeing, ...tracing, eye]],
  bake: [[fill], [...tracing, bake]],
  smooth: [[fill], [smooth]],
  displace: [[fill], [...seeing, displace]],
  mesh: [[...seeing, meshVertex], [intersect, surfaces, meshFragment]],
  surroundings: [[fill], [...seeing, intersect, surfaces, environment, surroundings]],
  add: [[fill], [sight, add]],
  illumination: [[fill], [illumination]],
  a_trous: [[fill], [aTrous]],
  show: [[fill], [show]],
  slopes: [[fill], [...seeing, slopes]],
  panel: [[panelVertex], [panelFragment]],
} as const;
export type ProgramName = keyof typeof sources;

export class Programs {
  private readonly compiled = new Map<ProgramName, Program>();

  constructor(private readonly gpu: Gpu) {}

  use(name: ProgramName): Program {
    let program = this.compiled.get(name);
    if (!program) {
      const [vertex, fragment] = sources[name].map((parts) => version + [common, ...parts].join('\n')) as [string, string];
      program = this.gpu.program(name, vertex, fragment);
      this.compiled.set(name, program);
    }
    return program.use();
  }
}
