/** A USD text as the specs of a layer (OpenUSD, "USDA file format"). */
import { type Arc, type Fields, keyOf, type Layer, specType, type Specs } from './specs';
import { UsdaWords } from './usda_words';

type Value = number | boolean | string | null | Value[] | { [name: string]: Value };

const listEdits = new Set(['prepend', 'append', 'add', 'delete', 'reorder']), arcKinds = new Set(['references', 'payload', 'inherits', 'specializes']);
const mostDepth = 500;

/** Numbers of vectors, matrices and lists of them, in a row. */
function inARow(value: Value): Value {
  return Array.isArray(value) ? ((value as unknown[]).flat(Infinity) as Value[]) : value;
}

function attributeValue(value: Value, type: string): Value {
  const row = inARow(value);
  if (!type.startsWith('quat') || !Array.isArray(row)) return type === 'bool' ? row === 1 || row === true : row;
  for (let i = 0; i + 3 < row.length; i += 4) row.splice(i, 4, ...[1, 2, 3, 0].map((k) => row[i + k] as Value));
  return row;
}

class UsdaReader {
  readonly specs: Specs = { '/': { specType: specType.prim, fields: {} } };
  readonly sublayers: string[] = [];
  private readonly words: UsdaWords;
  private depth = 0;

  constructor(text: string, private readonly key: string) {
    this.words = new UsdaWords(text);
  }

  layer(): Layer {
    const root = this.specs['/'] as { fields: Fields };
    if (this.words.takes('(')) this.metadata(root.fields, (name) => name === 'subLayers' ? this.arcs().forEach(({ file }) => { if (file) this.sublayers.push(file); }) : (root.fields[name] = this.value()));
    while (this.words.peek().kind !== 'end') this.prim('');
    return { specs: this.specs, sublayers: this.sublayers };
  }

  /** Up to the closing bracket; `take` reads the value of one entry. */
  private metadata(fields: Fields, take: (name: string, edit: string | null) => unknown): void {
    while (!this.words.takes(')')) {
      if (this.words.takes(';') || this.words.takes(',')) continue;
      if (this.words.peek().kind === 'string') {
        fields.documentation = this.words.next().text;
        continue;
      }
      let name = this.words.nameOrString(), edit = null;
      if (listEdits.has(name)) [edit, name] = [name, this.words.nameOrString()];
      this.words.expect('=');
      take(name, edit);
    }
  }

  private prim(parent: string): void {
    const specifier = this.words.nameOrString();
    if (specifier !== 'def' && specifier !== 'over' && specifier !== 'class') this.words.fail('def, over or class', { kind: 'name', text: specifier });
    const typeName = this.words.peek().kind === 'name' ? this.words.next().text : '', path = `${parent}/${this.words.nameOrString()}`;
    const fields: Fields = { typeName, specifier };
    this.specs[path] = { specType: specType.prim, fields };
    if (this.words.takes('(')) this.metadata(fields, (name, edit) => this.primMetadata(fields, name, edit));
    this.body(path);
  }

  private primMetadata(fields: Fields, name: string, edit: string | null): void {
    if (arcKinds.has(name)) {
      const arcs = this.arcs();
      if (edit !== 'delete' && edit !== 'reorder') fields.arcs = [...(fields.arcs ?? []), ...arcs];
    } else if (name === 'variants') fields.variantSelection = this.value() as Record<string, string>;
    else fields[name] = this.value();
  }

  private body(path: string): void {
    if (++this.depth > mostDepth) throw new Error(`its prims are nested more than ${mostDepth} deep`);
    this.words.expect('{');
    while (!this.words.takes('}')) {
      const { text } = this.words.peek();
      if (this.words.takes(';')) continue;
      if (text === 'def' || text === 'over' || text === 'class') this.prim(path);
      else if (this.words.takes('variantSet')) this.variantSet(path);
      else this.property(path);
    }
    --this.depth;
  }

  private variantSet(path: string): void {
    const name = this.words.nameOrString(), variants: string[] = [], { fields: own } = this.specs[path] as { fields: Fields };
    own.variantSetChildren = [...(own.variantSetChildren ?? []), name];
    this.words.expect('=');
    this.words.expect('{');
    while (!this.words.takes('}')) {
      const variant = this.words.nameOrString(), at = `${path}/{${name}=${variant}}`, fields: Fields = { typeName: '', specifier: 'def' };
      variants.push(variant);
      this.specs[at] = { specType: specType.prim, fields };
      if (this.words.takes('(')) this.metadata(fields, (word, edit) => this.primMetadata(fields, word, edit));
      this.body(at);
    }
    this.specs[`${path}/{${name}=}`] = { specType: specType.prim, fields: { typeName: '', specifier: 'over', variantChildren: variants } };
  }

  private property(path: string): void {
    let word = this.words.nameOrString();
    while (word === 'custom' || word === 'uniform' || word === 'varying' || word === 'config' || listEdits.has(word)) {
      if (word === 'reorder') return this.reorder();
      word = this.words.nameOrString();
    }
    if (word === 'rel') return this.relationship(path);
    if (this.words.takes('[')) {
      this.words.expect(']');
      word += '[]';
    }
    this.attribute(path, word, this.words.nameOrString());
  }

  private reorder(): void {
    this.words.nameOrString();
    this.words.expect('=');
    this.value();
  }

  private relationship(path: string): void {
    const name = this.words.nameOrString(), fields: Fields = { targetPaths: [] };
    if (this.words.takes('=')) fields.targetPaths = ([this.value()].flat() as Value[]).filter((target) => target !== null).map(String);
    this.ownMetadata(fields);
    this.specs[`${path}.${name}`] = { specType: specType.relationship, fields };
  }

  private attribute(path: string, typeName: string, stated: string): void {
    const [, name, part] = /^(.*?)(?:\.(connect|timeSamples|spline))?$/.exec(stated) as unknown as [string, string, string | undefined];
    const at = `${path}.${name}`, fields: Fields = this.specs[at]?.fields ?? { typeName };
    this.specs[at] = { specType: specType.attribute, fields };
    if (this.words.takes('=')) {
      const value = this.value();
      if (part === 'connect') fields.connectionPaths = ([value].flat() as Value[]).filter((target) => target !== null).map(String);
      else if (part === undefined && value !== null) fields.default = attributeValue(value, typeName);
      else if (part === 'timeSamples') this.firstSample(fields, value, typeName);
    }
    this.ownMetadata(fields);
  }

  /** A scene that moves stands as its first sample says. */
  private firstSample(fields: Fields, samples: Value, typeName: string): void {
    const [first] = Object.entries(samples ?? {}).sort(([a], [b]) => Number(a) - Number(b));
    fields.moves = true;
    if (first && fields.default === undefined) fields.default = attributeValue(first[1], typeName);
  }

  private ownMetadata(fields: Fields): void {
    if (this.words.takes('(')) this.metadata(fields, (name) => { fields[name] = this.value(); });
  }

  /** One or a list of @file@, @file@</Prim> and </Prim>, each with an offset in time, which a still picture does not need. */
  private arcs(): Arc[] {
    const result: Arc[] = [], list = this.words.takes('[');
    while (!(list && this.words.takes(']'))) {
      const word = this.words.next();
      if (word.kind === 'file') result.push({ file: keyOf(word.text, this.key), prim: this.words.peek().kind === 'path' ? this.words.next().text : null });
      else if (word.kind === 'path') result.push({ file: null, prim: word.text });
      else if (word.text !== 'None') this.words.fail('a file or a path', word);
      if (this.words.takes('(')) this.metadata({}, () => this.value());
      if (!list) break;
      this.words.takes(',');
    }
    return result;
  }

  private value(): Value {
    const word = this.words.next();
    if (word.kind === 'number') return word.value;
    if (word.kind === 'file') return keyOf(word.text, this.key);
    if (word.kind === 'string' || word.kind === 'path') return word.text;
    if (word.kind === 'name') return word.text === 'None' ? null : word.text === 'true' || word.text === 'True' ? true : word.text === 'false' || word.text === 'False' ? false : word.text;
    if (word.text === '(' || word.text === '[') return this.list(word.text === '(' ? ')' : ']');
    if (word.text === '{') return this.dictionary();
    return this.words.fail('a value', word);
  }

  private list(end: string): Value[] {
    if (++this.depth > mostDepth) throw new Error(`its lists are nested more than ${mostDepth} deep`);
    const values: Value[] = [];
    while (!this.words.takes(end)) {
      values.push(this.value());
      if (!this.words.takes(',') && this.words.peek().text !== end) this.words.fail(`"," or "${end}"`);
    }
    --this.depth;
    return values;
  }

  /** { type name = value … } or { number: value, … }. */
  private dictionary(): Value {
    if (++this.depth > mostDepth) throw new Error(`its dictionaries are nested more than ${mostDepth} deep`);
    const values: Record<string, Value> = {};
    while (!this.words.takes('}')) {
      if (this.words.takes(',') || this.words.takes(';')) continue;
      const first = this.words.next();
      if (this.words.takes(':')) values[first.text] = this.value();
      else {
        if (this.words.takes('[')) this.words.expect(']');
        const name = this.words.nameOrString();
        this.words.expect('=');
        values[name] = this.value();
      }
    }
    --this.depth;
    return values;
  }
}

/** Throws an Error that names the line. `key`: the file, to which the names in it are relative. */
export function usdaLayer(text: string, key: string): Layer {
  if (!/^\uFEFF?#usda 1\.\d/.test(text)) throw new Error('it does not begin with "#usda 1.0"');
  return new UsdaReader(text.replace(/^\uFEFF/, ''), key).layer();
}
