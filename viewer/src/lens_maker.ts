/** Fronts of progressive lenses, made in a worker: each takes a tenth of a second or more, and pages must answer meanwhile. */
import type { EyeNumbers, ProgressiveNumbers, SplineNumbers } from './core_module';
import { byId } from './elements';

export interface LensOrder { key: string; eye: EyeNumbers; lens: ProgressiveNumbers }
export interface LensAnswer { key: string; front: SplineNumbers | null; refusal: string }

/** So many are kept: those of two eyes, and what they were made for before. */
const kept = 4;

/** The core's script and the worker's own, as the page holds them. */
function workerOfPage(): Worker {
  const address = URL.createObjectURL(new Blob([byId('sturm-core').textContent ?? '', '\n', byId('lens-worker').textContent ?? ''], { type: 'text/javascript' }));
  const worker = new Worker(address);
  URL.revokeObjectURL(address);
  return worker;
}

export class LensMaker {
  private readonly made = new Map<string, LensAnswer>();
  private worker: Worker | null = null;
  /** What the worker is at. */
  private now: LensOrder | null = null;
  private next: LensOrder | null = null;

  /** `changed` hears when a lens is made, and when one is begun. */
  constructor(private readonly changed: () => void) {}

  get isMaking(): boolean {
    return this.now !== null;
  }

  /** Null while it is being made; of several orders meanwhile only the last is kept. Throws the core's message where it refuses. */
  front(key: string, eye: EyeNumbers, lens: ProgressiveNumbers): SplineNumbers | null {
    const answer = this.made.get(key);
    if (answer?.refusal) throw new Error(answer.refusal);
    if (answer) return answer.front;
    this.next = { key, eye, lens };
    if (!this.now) this.begin();
    return null;
  }

  private begin(): void {
    [this.now, this.next] = [this.next, null];
    if (this.now) {
      this.worker ??= this.hired();
      this.worker.postMessage(this.now);
    }
    this.changed();
  }

  private hired(): Worker {
    const worker = workerOfPage();
    worker.addEventListener('message', ({ data }: MessageEvent<LensAnswer>) => this.take(data));
    worker.addEventListener('error', ({ message }) => this.take({ key: this.now?.key ?? '', front: null, refusal: `The lens could not be made: ${message}` }));
    return worker;
  }

  private take(answer: LensAnswer): void {
    this.made.set(answer.key, answer);
    for (const key of this.made.keys()) if (this.made.size > kept) this.made.delete(key);
    if (this.next?.key === answer.key) this.next = null;
    this.begin();
  }
}
