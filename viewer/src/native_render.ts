/** "Render this natively": the same view by the program, where `sturm serve` is what serves the page. */
import { byId, element } from './elements';

interface Comparison { ssim: number; flip: number; rmse_display: number; flip_map?: string }
interface Line { progress?: number; seconds?: number; picture?: string; notes?: string[]; comparison?: Comparison | null; error?: string }

export interface Request { view: unknown; picture: string | null }

/** Whether a program answers where the page came from. */
export async function programAnswers(): Promise<boolean> {
  if (location.protocol !== 'http:') return false;
  try {
    const answer = await fetch('status');
    return answer.ok && (await answer.json()).program === 'sturm';
  } catch {
    return false;
  }
}

async function* linesOf(body: ReadableStream<Uint8Array>): AsyncGenerator<Line> {
  const reader = body.pipeThrough(new TextDecoderStream() as ReadableWritablePair<string, Uint8Array>).getReader();
  let text = '';
  for (;;) {
    const { value, done } = await reader.read();
    text += value ?? '';
    const lines = text.split('\n');
    text = lines.pop() ?? '';
    for (const line of done ? [...lines, text] : lines) if (line.trim() !== '') yield JSON.parse(line) as Line;
    if (done) return;
  }
}

function resultOf(line: Line): HTMLElement[] {
  const shown: HTMLElement[] = [element('img', { src: line.picture ?? '', alt: 'The program’s picture of this view' })];
  const c = line.comparison;
  if (c) {
    shown.push(element('p', { className: 'note', textContent: `The page against the program: SSIM ${c.ssim.toFixed(4)}, FLIP ${c.flip.toFixed(4)}, RMSE ${c.rmse_display.toFixed(4)} (display values).` }));
    if (c.flip_map) shown.push(element('img', { src: c.flip_map, alt: 'Where they differ, by FLIP' }));
  }
  shown.push(...(line.notes ?? []).map((text) => element('p', { className: 'note', textContent: text })));
  return shown;
}

/** The button's work; a second press ends it. */
export class NativeRender {
  private running: AbortController | null = null;
  private readonly place = byId('native');

  constructor(private readonly button: HTMLButtonElement, private readonly request: () => Request) {
    button.addEventListener('click', () => void this.pressed());
  }

  private async pressed(): Promise<void> {
    if (this.running) {
      this.running.abort();
      return;
    }
    this.running = new AbortController();
    this.button.textContent = 'Stop';
    const bar = element('progress', { max: 1, value: 0, ariaLabel: 'Progress of the program' }), words = element('p', { className: 'note' });
    this.place.replaceChildren(bar, words);
    try {
      await this.follow(this.running.signal, bar, words);
    } catch (problem) {
      this.place.replaceChildren(element('p', { className: 'error', textContent: this.running.signal.aborted ? 'Stopped.' : (problem as Error).message }));
    }
    this.running = null;
    this.button.textContent = 'Render this natively';
  }

  private async follow(signal: AbortSignal, bar: HTMLProgressElement, words: HTMLElement): Promise<void> {
    const answer = await fetch('render', { method: 'POST', signal, headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(this.request()) });
    if (!answer.ok || !answer.body) {
      const problem = await answer.json().catch(() => null) as { error?: string } | null;
      throw new Error(problem?.error ?? `The program answers ${answer.status}.`);
    }
    for await (const line of linesOf(answer.body)) {
      if (line.error) throw new Error(line.error);
      if (line.progress !== undefined) {
        bar.value = line.progress;
        words.textContent = `${Math.round(100 * line.progress)} %, ${(line.seconds ?? 0).toFixed(1)} s`;
      }
      if (line.picture) {
        this.place.replaceChildren(...resultOf(line));
        return;
      }
    }
    throw new Error('The program ended without a picture.');
  }
}
