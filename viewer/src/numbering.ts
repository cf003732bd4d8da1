/** Equal lists of numbers as one: a table with open addresses, as keys of text would take most of the time that a scene's mesh takes. */

/** Numbers lists of as many numbers as `size` in the order in which they first come: equal lists get the same number. */
export class Numbering {
  count = 0;
  private lists: Float64Array;
  /** Of each slot the number of its list, or −1. At most half of the slots are taken. */
  private slots = new Int32Array(1 << 12).fill(-1);
  private readonly asked: Float64Array;
  private readonly bits: Int32Array;

  constructor(private readonly size: number) {
    this.lists = new Float64Array(size << 11);
    this.asked = new Float64Array(size);
    this.bits = new Int32Array(this.asked.buffer);
  }

  /** A list that is new gets what `count` was. */
  numberOf(list: readonly number[]): number {
    for (let k = 0; k < this.size; ++k) this.asked[k] = (list[k] ?? 0) + 0;  // −0 is 0
    let slot = this.firstSlot();
    for (let known = this.slots[slot] ?? -1; known >= 0; known = this.slots[slot] ?? -1) {
      if (this.asked.every((x, k) => x === this.lists[this.size * known + k])) return known;
      slot = (slot + 1) & (this.slots.length - 1);
    }
    this.slots[slot] = this.count;
    this.lists.set(this.asked, this.size * this.count);
    if (2 * ++this.count === this.slots.length) this.grow();
    return this.count - 1;
  }

  private firstSlot(): number {
    let hash = 0;
    for (const word of this.bits) hash = Math.imul(hash ^ word ^ (hash >>> 15), 0x2c1b3c6d);
    return (hash ^ (hash >>> 13)) & (this.slots.length - 1);
  }

  private grow(): void {
    const lists = new Float64Array(2 * this.lists.length);
    lists.set(this.lists);
    this.lists = lists;
    this.slots = new Int32Array(2 * this.slots.length).fill(-1);
    for (let number = 0; number < this.count; ++number) {
      this.asked.set(lists.subarray(this.size * number, this.size * (number + 1)));
      let slot = this.firstSlot();
      while ((this.slots[slot] ?? -1) >= 0) slot = (slot + 1) & (this.slots.length - 1);
      this.slots[slot] = number;
    }
  }
}
