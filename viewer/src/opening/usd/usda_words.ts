/** Words of a USD text. */
export type Word = { kind: 'end' | 'string' | 'file' | 'path' | 'name' | 'sign'; text: string } | { kind: 'number'; text: string; value: number };

const pattern = /(?:\s|#[^\n]*|\/\*[^]*?\*\/)*(?:("""[^]*?"""|'''[^]*?'''|"(?:\\[^]|[^"\\\n])*"|'(?:\\[^]|[^'\\\n])*')|(@@@[^]*?@@@|@[^@\n]*@)|(<[^>\n]*>)|([-+]?(?:(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|inf\b|nan\b))|([\p{L}_][\p{L}\p{N}_:.]*)|([()[\]{}=,;:&]))/uy;
const blank = /(?:\s|#[^\n]*|\/\*[^]*?\*\/)*/uy;
const escapes: Record<string, string> = { n: '\n', t: '\t', r: '\r' };

function unquoted(text: string): string {
  const quotes = /^("""|''')/.test(text) ? 3 : 1;
  return text.slice(quotes, -quotes).replace(/\\([^])/g, (_, c: string) => escapes[c] ?? c);
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
    pattern.lastIndex = this.at;
    const found = pattern.exec(this.text);
    if (!found) {
      blank.lastIndex = this.at;
      blank.exec(this.text);
      if (blank.lastIndex < this.text.length) {
        this.at = blank.lastIndex;
        this.fail('a word of a USD text', { kind: 'sign', text: this.text[this.at] ?? '' });
      }
      return { kind: 'end', text: 'the end' };
    }
    this.at = pattern.lastIndex;
    const [, string, file, path, number, name, sign] = found;
    if (number !== undefined) return { kind: 'number', text: number, value: numberOf(number) };
    if (string !== undefined) return { kind: 'string', text: unquoted(string) };
    if (file !== undefined) return { kind: 'file', text: file.replace(/^@+|@+$/g, '') };
    if (path !== undefined) return { kind: 'path', text: path.slice(1, -1) };
    return name !== undefined ? { kind: 'name', text: name } : { kind: 'sign', text: sign ?? '' };
  }
}
