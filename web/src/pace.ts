// How finely pictures are drawn. Graphics that run on the processor take a tenth of a second for an eye that sees by depth: while
// what is shown moves, its pictures are then coarser, so that it moves smoothly, and fine again once it rests.

/** Milliseconds between pictures that are drawn in every frame of the screen: what is aimed at, what is too slow (more than on a
 *  screen of 24 pictures a second), and what leaves time for finer ones. */
const kGoal = 33;
const kSlow = 45;
const kFast = 20;
const kCoarsest = 4;
/** Frames of the screen in which nothing has moved, until it rests. A video has some between its own. */
const kRest = 8;
/** As many pictures that came fast say that finer ones may be tried. */
const kProof = 20;

export class Pace {
  /** What the sides of the picture drawn last were divided by. */
  divisor = 1;
  private needed = 1;
  /** The finest that is known to be too slow, in this movement. */
  private tooFine = 0;
  private quiet = kRest;
  private at = 0;
  private intervals: number[] = [];

  /** A frame of the screen in which nothing is drawn. Whether a coarse picture has rested, and is to be drawn again. */
  rests(): boolean {
    this.quiet = Math.min(this.quiet + 1, kRest);
    return this.quiet === kRest && this.divisor > 1;
  }

  /** A picture is drawn at a time in ms, because what is shown moves or for another reason; what its sides are to be divided by.
   *  The first of a movement is as fine as one at rest. */
  draws(now: number, moves: boolean): number {
    const isFirst = this.quiet === kRest;
    if (!moves) {
      this.quiet = Math.min(this.quiet + 1, kRest);
    } else {
      if (isFirst) this.tooFine = 0;
      else if (this.quiet === 0 && this.divisor === this.needed) this.learn(now - this.at);
      this.quiet = 0;
      this.at = now;
    }
    if (isFirst) this.divisor = 1;
    else if (moves) this.divisor = this.needed;
    return this.divisor;
  }

  private learn(interval: number): void {
    this.intervals.push(interval);
    const last = this.intervals.slice(-2);
    if (last.length === 2 && Math.min(...last) > kSlow) this.coarser(Math.min(...last));
    else if (this.intervals.length >= kProof) this.finer();
  }

  /** The time is taken to go with the picture's area. */
  private coarser(interval: number): void {
    this.tooFine = Math.max(this.tooFine, this.needed);
    this.needed = Math.min(Math.ceil(this.needed * Math.sqrt(interval / kGoal)), kCoarsest);
    this.intervals = [];
  }

  private finer(): void {
    if (Math.max(...this.intervals) < kFast && this.needed - 1 > this.tooFine) this.needed--;
    this.intervals = [];
  }
}
