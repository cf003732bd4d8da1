/** How much a frame may do, so that the page answers while pictures grow. */
export class Pace {
  private work = 1;
  private last = 0;
  frame_ms = 0;

  /** Called once a frame: units of work for it. `busy`: the last frame did some. */
  next(now: number, busy: boolean): number {
    const took = now - this.last;
    this.last = now;
    if (busy) {
      this.frame_ms = this.frame_ms === 0 ? took : 0.8 * this.frame_ms + 0.2 * took;
      if (took < 30) this.work = Math.min(64, 1.3 * this.work);
      else if (took > 60) this.work = Math.max(1, 0.6 * this.work);
    }
    return Math.ceil(this.work);
  }
}
