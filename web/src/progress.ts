// The line that shows the progress of long work.
import { element } from "./elements";
import { minutes } from "./run";

export interface Work {
  what: string;
  /** Downloaded bytes; `of` is null if the size is unknown. */
  bytes?: number;
  of?: number | null;
  /** Share of the work that is done, 0 to 1, if bytes are not counted. */
  share?: number;
}

/** Work shorter than this is not shown. */
const kPatienceMs = 250;
/** The time left is shown after this time, because earlier estimates are inaccurate. */
const kGuessMs = 800;

const megabytes = (bytes: number): string => (bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1e3))}\u2009kB` : `${(bytes / 1e6).toFixed(bytes < 1e7 ? 1 : 0)}\u2009MB`);

export class ProgressLine {
  private readonly works = new Map<string, Work & { since: number; from: number }>();
  private readonly status = element("span");
  private readonly bar = element("progress", { max: 1 });
  private timer = 0;

  constructor(private readonly parent: HTMLElement) {
    this.bar.setAttribute("aria-label", "Progress");
    parent.append(this.status, this.bar);
  }

  /** about: identifies the work. work: its progress, or null when it is done. */
  show(about: string, work: Work | null): void {
    const before = this.works.get(about);
    if (!work && !before) return;
    const share = work ? this.shareOf(work) : null;
    if (!work) this.works.delete(about);
    else if (before?.what === work.what && (share ?? 0) >= (this.shareOf(before) ?? 0)) this.works.set(about, { ...work, since: before.since, from: before.from });
    else this.works.set(about, { ...work, since: performance.now(), from: share ?? 0 });
    this.update();
  }

  private shareOf({ share, bytes, of }: Work): number | null {
    if (share !== undefined) return share;
    return of && bytes !== undefined ? bytes / of : null;
  }

  private update(): void {
    window.clearTimeout(this.timer);
    const [work] = this.works.values();
    const waited = work ? performance.now() - work.since : 0;
    this.parent.hidden = !work || waited < kPatienceMs;
    if (!work) return;
    if (waited < kPatienceMs) this.timer = window.setTimeout(() => this.update(), kPatienceMs - waited);
    const share = this.shareOf(work);
    const parts = [work.what];
    if (work.bytes !== undefined && work.of) parts.push(`${megabytes(work.bytes)} of ${megabytes(work.of)}`);
    else if (work.bytes) parts.push(megabytes(work.bytes));
    if (share !== null) parts.push(`${Math.round(100 * share)}\u2009%`);
    const done = (share ?? 0) - work.from;
    if (share !== null && waited > kGuessMs && done > 0.02 && share < 1) parts.push(`${minutes(((1 - share) * waited) / 1000 / done)} left`);
    this.status.textContent = parts.join(" \u00b7 ");
    if (share === null) this.bar.removeAttribute("value");
    else this.bar.value = share;
  }
}
