/** Traced pictures without their noise, for the eye that looks; what is measured and saved for comparisons is not filtered. */
import type { Gpu, Target } from './gpu';
import type { Programs } from './programs';

const steps = [1, 2, 4, 8, 16];

export class NoiseFilter {
  private targets: [Target, Target] | null = null;

  constructor(private readonly gpu: Gpu, private readonly programs: Programs) {}

  /** The mean of what a traced panel has summed, filtered; belongs to the filter until it is next asked. */
  filtered(sum: Target): Target {
    const [first, second] = this.targetsFor(sum), [colours, normals] = sum.more;
    if (!colours || !normals) throw new Error('This picture has not been traced.');
    const asked = (name: 'illumination' | 'a_trous') => this.programs.use(name).texture('u_sum', sum.texture).texture('u_colours', colours).texture('u_normals', normals);
    asked('illumination');
    this.gpu.into(first);
    this.gpu.fill(false);
    let from = first, into = second;
    steps.forEach((step, k) => {
      asked('a_trous').texture('u_light', from.texture).set({ u_step: step, u_last: k + 1 === steps.length });
      this.gpu.into(into);
      this.gpu.fill(false);
      [from, into] = [into, from];
    });
    return from;
  }

  private targetsFor({ width, height }: Target): [Target, Target] {
    const [known] = this.targets ?? [];
    if (this.targets && known?.width === width && known.height === height) return this.targets;
    this.targets?.forEach((target) => this.gpu.release(target));
    this.targets = [this.gpu.target(width, height), this.gpu.target(width, height)];
    return this.targets;
  }
}
