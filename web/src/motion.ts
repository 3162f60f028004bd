// Moves the eye until the user touches the page: it sways slowly, and follows the mouse over the picture. Users who
// prefer reduced motion see neither.

/** Position in the viewing zone: shares (across, up), from 0 to 1. */
type Shares = [number, number];

const kSwing: Shares = [0.34, 0.22];
const kPeriodsMs: Shares = [7000, 9500];
/** Time without motion before the sway begins, and time in which it grows to its full width. */
const kWaitMs = 900;
const kRampMs = 1500;
/** time constant of the eye's motion towards its target */
const kEaseMs = 140;
const kMargin = 0.03;

export class Motion {
  private readonly isReduced = window.matchMedia?.("(prefers-reduced-motion: reduce)").matches ?? false;
  private isTouched = false;
  private pointer: Shares | null = null;
  private began = 0;
  private last = 0;
  private offset: Shares = [0, 0];

  /** home: returns the eye's position without the motion. changed: is called when the motion ends. */
  constructor(
    private readonly home: () => Shares,
    private readonly changed: () => void,
  ) {}

  /** Whether the eye moves or is about to. */
  get isOn(): boolean {
    return !this.isTouched && !this.isReduced;
  }

  get canMove(): boolean {
    return !this.isReduced;
  }

  get isOver(): boolean {
    return this.isTouched;
  }

  end(): void {
    if (this.isTouched) return;
    this.isTouched = true;
    this.changed();
  }

  restart(): void {
    this.isTouched = false;
    this.began = 0;
    this.changed();
  }

  /** Sets the position of the mouse as shares of the picture, from the bottom left; null if the mouse is outside the
   *  picture. */
  hover(at: Shares | null): void {
    if (this.pointer && !at) this.began = 0;
    this.pointer = at;
  }

  /** Returns the eye's position, and resets its offset from home. */
  settle(): Shares {
    const shares = this.shares();
    this.offset = [0, 0];
    return shares;
  }

  shares(): Shares {
    const home = this.home();
    return [0, 1].map((i) => Math.min(Math.max(home[i] + this.offset[i], Math.min(home[i], kMargin)), Math.max(home[i], 1 - kMargin))) as Shares;
  }

  get isAway(): boolean {
    return this.offset[0] !== 0 || this.offset[1] !== 0;
  }

  /** Advances by one frame of the screen. Returns whether the eye has moved. may: whether the eye may move now. */
  step(now: number, may: boolean): boolean {
    const past = Math.min(now - this.last, 100);
    this.last = now;
    const isMoving = this.isOn && may;
    if (!isMoving && !this.isAway) {
      this.began = 0;
      return false;
    }
    if (this.began === 0) this.began = now;
    const goal = isMoving ? this.goal(now) : ([0, 0] as Shares);
    const by = 1 - Math.exp(-past / kEaseMs);
    const next = this.offset.map((offset, i) => (Math.abs(goal[i] - offset) < 1e-4 ? goal[i] : offset + by * (goal[i] - offset))) as Shares;
    const moved = next[0] !== this.offset[0] || next[1] !== this.offset[1];
    this.offset = next;
    return moved;
  }

  private goal(now: number): Shares {
    const home = this.home();
    if (this.pointer) return [this.pointer[0] - home[0], this.pointer[1] - home[1]];
    const time = Math.max(0, now - this.began - kWaitMs);
    const ramp = Math.min(1, time / kRampMs);
    return [0, 1].map((i) => ramp * kSwing[i] * Math.sin((2 * Math.PI * time) / kPeriodsMs[i])) as Shares;
  }
}
