// Chooses the resolution of pictures. Without a GPU, drawing an eye's view takes a tenth of a second, so pictures have
// fewer pixels while the view moves.

/** Times between two pictures, in ms: the goal; the limit above which motion is too slow; and the limit below which a finer
 *  resolution is tried. */
const kGoal = 33;
const kSlow = 45;
const kFast = 20;
const kCoarsest = 4;
/** Frames of the screen without motion after which the view rests. While a video plays, a few frames of the screen show
 *  no new picture. */
const kRest = 8;
/** Number of fast pictures after which a finer resolution is tried. */
const kProof = 20;

export class Pace {
  /** The width and the height of the last picture were divided by this. */
  divisor = 1;
  private needed = 1;
  /** Largest divisor at which pictures were too slow in the current movement. */
  private tooFine = 0;
  private quiet = kRest;
  private at = 0;
  private intervals: number[] = [];

  /** Counts a frame of the screen without a picture. Returns whether a coarse picture must be redrawn because the view rests. */
  rests(): boolean {
    this.quiet = Math.min(this.quiet + 1, kRest);
    return this.quiet === kRest && this.divisor > 1;
  }

  /** Returns the divisor for the next picture; the first picture of a movement has full resolution. now: in ms. moves:
   *  whether the view is moving. */
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

  /** Assumes that the drawing time is proportional to the area of the picture. */
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
