/** The form: native inputs with labels, each bound to one number or word of the state. */
import { axisDial } from './dial';
import { element } from './elements';
import { ranges, type State } from './state';

/** What shows a part of the state and follows it. */
export interface Bound {
  show(state: State): void;
}

export type Change = (edit: (state: State) => void) => void;

let ids = 0;

export class FormPart {
  readonly element = element('fieldset');
  readonly bound: Bound[] = [];

  constructor(legend: string, private readonly change: Change) {
    this.element.append(element('legend', { textContent: legend }));
  }

  add(node: Node): void {
    this.element.append(node);
  }

  slider(label: string, range: keyof typeof ranges, unit: string, digits: number, of: (s: State) => number, set: (s: State, x: number) => void, shown?: (s: State) => boolean): void {
    const [least, largest, step] = ranges[range], id = `control-${++ids}`;
    const input = element('input', { type: 'range', id, min: String(least), max: String(largest), step: String(step) });
    const output = element('output', { htmlFor: id as never });
    const row = element('div', { className: 'row' }, element('label', { htmlFor: id, textContent: label }), input, output);
    input.addEventListener('input', () => this.change((s) => set(s, Number(input.value))));
    this.add(row);
    this.bound.push({
      show(s) {
        const value = of(s);
        row.hidden = shown ? !shown(s) : false;
        input.value = String(value);
        output.textContent = `${signed(value, digits, least < 0)}${unit}`;
        input.setAttribute('aria-valuetext', output.textContent);
      },
    });
  }

  select<W extends string>(label: string, options: readonly (readonly [W, string])[], of: (s: State) => W, set: (s: State, word: W) => void, shown?: (s: State) => boolean): HTMLSelectElement {
    const id = `control-${++ids}`, select = element('select', { id });
    for (const [value, text] of options) select.append(element('option', { value, textContent: text }));
    const row = element('div', { className: 'row wide' }, element('label', { htmlFor: id, textContent: label }), select);
    select.addEventListener('change', () => this.change((s) => set(s, select.value as W)));
    this.add(row);
    this.bound.push({
      show(s) {
        row.hidden = shown ? !shown(s) : false;
        select.value = of(s);
      },
    });
    return select;
  }

  check(label: string, of: (s: State) => boolean, set: (s: State, on: boolean) => void, shown?: (s: State) => boolean): void {
    const input = element('input', { type: 'checkbox' }), row = element('label', { className: 'row check' }, input, label);
    input.addEventListener('change', () => this.change((s) => set(s, input.checked)));
    this.add(row);
    this.bound.push({
      show(s) {
        row.hidden = shown ? !shown(s) : false;
        input.checked = of(s);
      },
    });
  }

  dial(of: (s: State) => number, set: (s: State, x: number) => void, shown?: (s: State) => boolean): void {
    const dial = axisDial((x) => this.change((s) => set(s, x)));
    this.add(dial.element);
    this.bound.push({
      show(s) {
        dial.element.style.display = shown && !shown(s) ? 'none' : '';
        dial.show(of(s));
      },
    });
  }

  buttons(...list: [string, () => void][]): HTMLButtonElement[] {
    const made = list.map(([text, action]) => {
      const button = element('button', { type: 'button', textContent: text });
      button.addEventListener('click', action);
      return button;
    });
    this.add(element('div', { className: 'buttons' }, ...made));
    return made;
  }

  /** A text that is read on Enter and when the field is left; `read` throws what is wrong with it. */
  text(label: string, placeholder: string, read: (text: string) => void): void {
    const id = `control-${++ids}`, input = element('input', { type: 'text', id, placeholder, spellcheck: false });
    const error = element('p', { className: 'error', hidden: true, id: `${id}-error` });
    input.setAttribute('aria-describedby', error.id);
    const take = () => {
      error.hidden = true;
      input.removeAttribute('aria-invalid');
      if (input.value.trim() === '') return;
      try {
        read(input.value);
      } catch (problem) {
        error.textContent = (problem as Error).message;
        error.hidden = false;
        input.setAttribute('aria-invalid', 'true');
      }
    };
    input.addEventListener('change', take);
    this.add(element('div', { className: 'row wide' }, element('label', { htmlFor: id, textContent: label }), input));
    this.add(error);
  }
}

export function signed(value: number, digits: number, withSign: boolean): string {
  const text = Math.abs(value).toFixed(digits), zero = Number(text) === 0;
  return `${zero ? '' : value < 0 ? '−' : withSign ? '+' : ''}${text}`;
}
