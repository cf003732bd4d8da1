/** What the loaders would write to the console; build.mjs puts `remark` in place of its warnings and errors. */
export const said = new Set<string>();

export function remark(...parts: unknown[]): void {
  said.add(parts.map((part) => (part instanceof Error ? part.message : String(part))).join(' ').replace(/^THREE\./, ''));
}
