// Chooses the resolution of pictures. Software graphics take a tenth of a second to draw an eye's view with depth, so pictures
// are coarser while the view moves, and fine again once it rests.

/** Milliseconds between pictures: the goal, too slow (below 24 pictures a second), and fast enough to try a finer resolution. */
const kGoal = 33;
const kSlow = 45;
const kFast = 20;
const kCoarsest = 4;
/** Frames of the screen without motion after which the view rests. A video has a few between its own frames. */
const kRest = 8;
/** Number of fast pictures after which a finer resolution is tried. */
const kProof = 20;

export class Pace {
  /** Divisor of the width and height of the last picture. */
  divisor = 1;
  private needed = 1;
  /** The smallest divisor known to be too slow in this movement. */
  private tooFine = 0;
  private quiet = kRest;
  private at = 0;
  private intervals: number[] = [];

  /** Counts a frame of the screen without a picture. Returns whether the view has rested and a coarse picture must be redrawn. */
  rests(): boolean {
    this.quiet = Math.min(this.quiet + 1, kRest);
    return this.quiet === kRest && this.divisor > 1;
  }

  /** Returns the divisor for a picture drawn at `now` (ms); `moves`: the view is moving. The first picture of a movement has full
   *  resolution. */
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

  /** Chooses a coarser divisor, assuming that time is proportional to the picture's area. */
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
