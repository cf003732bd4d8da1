/** Words of a USD text. */
export type Word = { kind: 'end' | 'string' | 'file' | 'path' | 'name' | 'sign'; text: string } | { kind: 'number'; text: string; value: number };

// Each repeats one class of characters: a repeated choice would take room for each character of a long text.
const blanks = /\s+/y, number = /[-+]?(?:(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|inf\b|nan\b)/y, name = /[\p{L}_][\p{L}\p{N}_:.]*/uy;
const quotes = ['"""', "'''", '"', "'", '@@@', '@', '<'], signs = '()[]{}=,;:&';
const escapes: Record<string, string> = { n: '\n', t: '\t', r: '\r' };

function unescaped(text: string): string {
  return text.replace(/\\([^])/g, (_, c: string) => escapes[c] ?? c);
}

function numberOf(text: string): number {
  if (text.endsWith('inf')) return text.startsWith('-') ? -Infinity : Infinity;
  return text.endsWith('nan') ? NaN : Number(text);
}

export class UsdaWords {
  private at = 0;
  private ahead: Word | null = null;

  constructor(private readonly text: string) {}

  peek(): Word {
    this.ahead ??= this.read();
    return this.ahead;
  }

  next(): Word {
    const word = this.peek();
    this.ahead = null;
    return word;
  }

  /** Whether the next word is this sign or name, which then is taken. */
  takes(text: string): boolean {
    const word = this.peek();
    if ((word.kind !== 'sign' && word.kind !== 'name') || word.text !== text) return false;
    this.ahead = null;
    return true;
  }

  expect(text: string): void {
    if (!this.takes(text)) this.fail(`"${text}"`);
  }

  nameOrString(): string {
    const word = this.next();
    if (word.kind !== 'name' && word.kind !== 'string') this.fail('a name', word);
    return word.text;
  }

  fail(expected: string, word = this.peek()): never {
    const line = this.text.slice(0, this.at).split('\n').length;
    throw new Error(`line ${line} has "${word.text}", expected ${expected}`);
  }

  private read(): Word {
    this.skip();
    if (this.at >= this.text.length) return { kind: 'end', text: 'the end' };
    const quote = quotes.find((own) => this.text.startsWith(own, this.at));
    if (quote) return this.quoted(quote);
    const digits = this.match(number);
    if (digits !== null) return { kind: 'number', text: digits, value: numberOf(digits) };
    const letters = this.match(name), sign = this.text[this.at] ?? '';
    if (letters !== null) return { kind: 'name', text: letters };
    if (!signs.includes(sign)) this.fail('a word of a USD text', { kind: 'sign', text: sign });
    ++this.at;
    return { kind: 'sign', text: sign };
  }

  /** What matches here, which is passed by. */
  private match(pattern: RegExp): string | null {
    pattern.lastIndex = this.at;
    const found = pattern.exec(this.text)?.[0] ?? null;
    if (found !== null) this.at = pattern.lastIndex;
    return found;
  }

  /** Passes by spaces and remarks. */
  private skip(): void {
    for (let before = -1; before !== this.at;) {
      before = this.at;
      this.match(blanks);
      const end = this.text[this.at] === '#' ? '\n' : this.text.startsWith('/*', this.at) ? '*/' : null;
      if (end === null) continue;
      const found = this.text.indexOf(end, this.at + 1);
      this.at = found < 0 ? this.text.length : found + end.length;
    }
  }

  private quoted(quote: string): Word {
    const end = quote === '<' ? '>' : quote, isString = quote.startsWith('"') || quote.startsWith("'");
    let close = this.at + quote.length;
    for (; close < this.text.length && !this.text.startsWith(end, close); ++close) {
      if (quote.length === 1 && this.text[close] === '\n') break;
      if (isString && this.text[close] === '\\') ++close;
    }
    const inside = this.text.slice(this.at + quote.length, close);
    if (!this.text.startsWith(end, close)) this.fail(`${end} at its end`, { kind: 'sign', text: `${quote}${inside.slice(0, 30)}` });
    this.at = close + end.length;
    if (isString) return { kind: 'string', text: unescaped(inside) };
    return { kind: quote === '<' ? 'path' : 'file', text: inside };
  }
}
