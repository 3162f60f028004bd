// The time line: plays, pauses, steps and scrubs, marks key frames, and plots the PSNR of each frame.
import type { Frame } from "./field";
import type { Store } from "./state";

const kSvg = "http://www.w3.org/2000/svg";
const kHeight = 40;

function svg(name: string, attributes: Record<string, string | number>): SVGElement {
  const made = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  return made;
}

const kIcons = {
  play: "M4 2.5v11l9-5.5z",
  pause: "M4 3h3v10H4zM9 3h3v10H9z",
  back: "M11.5 3v10L5 8zM3.5 3H5v10H3.5z",
  forward: "M4.5 3v10L11 8zM11 3h1.5v10H11z",
  loop: "M4 4.5h6.5A2.5 2.5 0 0 1 13 7v2a2.5 2.5 0 0 1-2.5 2.5H5.2L6.7 13l-.9.9L2.7 11l3.1-3 .9.9-1.5 1.4h5.3A1.3 1.3 0 0 0 11.8 9V7a1.3 1.3 0 0 0-1.3-1.3H4z",
};

function iconButton(label: string, icon: keyof typeof kIcons): HTMLButtonElement {
  const button = document.createElement("button");
  button.type = "button";
  button.className = "icon";
  setIcon(button, label, icon);
  return button;
}

function setIcon(button: HTMLButtonElement, label: string, icon: keyof typeof kIcons): void {
  if (button.getAttribute("aria-label") === label) return;
  button.setAttribute("aria-label", label);
  button.title = label;
  const picture = svg("svg", { viewBox: "0 0 16 16", "aria-hidden": "true" });
  picture.append(svg("path", { d: kIcons[icon] }));
  button.replaceChildren(picture);
}

/** Returns the first and the last index of each range of unfinished frames. */
function pendingRanges(frames: Frame[]): [number, number][] {
  const ranges: [number, number][] = [];
  frames.forEach((frame, i) => {
    if (!frame.pending) return;
    if (i > 0 && frames[i - 1].pending) ranges[ranges.length - 1][1] = i;
    else ranges.push([i, i]);
  });
  return ranges;
}

export class Timeline {
  playing = false;
  /** PSNR of each frame in dB, if known. */
  readonly psnr: (number | undefined)[];
  private readonly play: HTMLButtonElement;
  private readonly loop: HTMLButtonElement;
  private readonly scrub = document.createElement("input");
  private readonly label = document.createElement("output");
  private readonly speed = document.createElement("select");
  private readonly marks: SVGElement;
  private startedAt = 0;
  private startFrame = 0;

  constructor(
    private readonly parent: HTMLElement,
    private readonly store: Store,
    private readonly isReady: (frame: number) => boolean,
  ) {
    const { frames } = store.fields[0];
    this.psnr = frames.map((frame) => frame.psnr_db);
    this.play = iconButton("Play", "play");
    this.loop = iconButton("Loop", "loop");
    this.marks = svg("svg", { class: "marks", role: "img" });
    if (frames.length < 2) return;
    this.build(frames.length);
    store.listen(() => this.update());
    this.update();
  }

  private build(count: number): void {
    const back = iconButton("Previous frame", "back");
    const forward = iconButton("Next frame", "forward");
    Object.assign(this.scrub, { type: "range", min: "0", max: String(count - 1), step: "1" });
    this.scrub.setAttribute("aria-label", "Frame");
    this.speed.setAttribute("aria-label", "Speed");
    for (const speed of [0.1, 0.25, 0.5, 1, 2, 4]) this.speed.append(new Option(`${speed}\u00d7`, String(speed)));
    this.play.addEventListener("click", () => this.toggle());
    back.addEventListener("click", () => this.step(-1));
    forward.addEventListener("click", () => this.step(1));
    this.loop.addEventListener("click", () => this.store.set({ loop: !this.store.state.loop }));
    this.speed.addEventListener("change", () => this.store.set({ speed: Number(this.speed.value) }));
    this.scrub.addEventListener("input", () => this.goTo(Number(this.scrub.value)));
    this.marks.addEventListener("click", (event) => {
      const box = this.marks.getBoundingClientRect();
      this.goTo(Math.round((((event as MouseEvent).clientX - box.left) / box.width) * (count - 1)));
    });
    const track = document.createElement("div");
    track.className = "track";
    track.append(this.marks, this.scrub);
    const heading = document.createElement("h2");
    heading.textContent = "Time";
    this.parent.append(heading, this.play, back, forward, track, this.label, this.loop, this.speed);
    this.parent.hidden = false;
  }

  toggle(): void {
    if (this.store.fields[0].frames.length < 2) return;
    this.playing = !this.playing;
    this.start();
    this.update();
  }

  pause(): void {
    if (this.playing) this.toggle();
  }

  step(by: number): void {
    const count = this.store.fields[0].frames.length;
    this.playing = false;
    this.store.set({ frame: this.finishedFrom((this.store.state.frame + by + count) % count, by) });
    this.update();
  }

  /** Returns the nearest finished frame from `frame` in steps of `by`, or `frame` if there is none. */
  private finishedFrom(frame: number, by: number): number {
    const { frames } = this.store.fields[0];
    const at = (steps: number) => (((frame + steps * by) % frames.length) + frames.length) % frames.length;
    const found = frames.findIndex((_, steps) => !frames[at(steps)].pending);
    return found < 0 ? frame : at(found);
  }

  takeFrames(): void {
    this.store.fields[0].frames.forEach((frame, i) => (this.psnr[i] = frame.psnr_db));
    if (this.psnr.length > 1) this.update();
  }

  goTo(frame: number): void {
    this.store.set({ frame });
    this.start();
  }

  private start(): void {
    this.startedAt = performance.now();
    this.startFrame = this.store.state.frame;
  }

  /** Advances to the frame that is due, but not beyond frames that are not loaded. now: time stamp of the animation frame,
   *  which may be earlier than the click on Play. */
  tick(now: number): void {
    if (!this.playing) return;
    const { state, fields } = this.store;
    const count = fields[0].frames.length;
    const seconds = Math.max(now - this.startedAt, 0) / 1000;
    let frame = this.startFrame + Math.floor(seconds * fields[0].frames_per_second * state.speed);
    if (frame === state.frame) return;
    if (frame >= count && !state.loop) {
      this.playing = false;
      frame = count - 1;
      this.store.set({ frame });
      this.update();
      return;
    }
    frame %= count;
    if (fields[0].frames[frame].pending) {
      const next = this.finishedFrom(frame, 1);
      if (next !== state.frame) this.store.set({ frame: next });
      this.start();
      return;
    }
    if (!this.isReady(frame)) {
      const next = (state.frame + 1) % count;
      if (this.isReady(next)) this.store.set({ frame: next });
      this.start();
      return;
    }
    this.store.set({ frame });
  }

  update(): void {
    const { state, fields } = this.store;
    const { frames } = fields[0];
    setIcon(this.play, this.playing ? "Pause" : "Play", this.playing ? "pause" : "play");
    this.loop.setAttribute("aria-pressed", String(state.loop));
    this.scrub.value = String(state.frame);
    const kind = frames[state.frame].kind;
    const psnr = this.psnr[state.frame];
    const decibels = psnr !== undefined && Number.isFinite(psnr) ? `\n${psnr.toFixed(1)} dB` : "";
    this.label.value = `${frames[state.frame].label} / ${frames[frames.length - 1].label}${decibels}`;
    this.scrub.setAttribute("aria-valuetext", `frame ${frames[state.frame].label}${kind ? `, ${kind}` : ""}${psnr !== undefined ? `, ${psnr.toFixed(1)} dB` : ""}`);
    this.label.title = [kind && `${kind} frame`, psnr !== undefined && `${psnr.toFixed(2)} dB`].filter(Boolean).join(", ");
    const speed = String(state.speed);
    if (![...this.speed.options].some((option) => option.value === speed)) this.speed.append(new Option(`${speed}\u00d7`, speed));
    this.speed.value = speed;
    this.drawMarks();
  }

  private drawMarks(): void {
    const { frames } = this.store.fields[0];
    const known = this.psnr.filter((psnr): psnr is number => psnr !== undefined && Number.isFinite(psnr));
    const curve = known.length > 1;
    const height = curve ? kHeight : 8;
    const last = frames.length - 1;
    this.marks.setAttribute("viewBox", `0 0 ${last} ${height}`);
    this.marks.setAttribute("preserveAspectRatio", "none");
    this.marks.style.height = `${height}px`;
    const parts: SVGElement[] = [];
    frames.forEach((frame, i) => {
      if (frame.kind === "key") parts.push(svg("line", { x1: i, x2: i, y1: height - 6, y2: height, class: "key" }));
    });
    const pending = frames.filter((frame) => frame.pending).length;
    let text = parts.length > 0 ? `${parts.length} key frames are marked.` : "Frames.";
    if (curve) {
      const least = Math.min(...known);
      const most = Math.max(...known, least + 1);
      const y = (psnr: number) => 3 + (1 - (psnr - least) / (most - least)) * (height - 12);
      const points = this.psnr.map((psnr, i) => (psnr === undefined || !Number.isFinite(psnr) ? null : `${i},${y(psnr).toFixed(2)}`));
      parts.push(svg("polyline", { points: points.filter(Boolean).join(" "), class: "curve" }));
      text += ` PSNR from ${least.toFixed(1)} to ${Math.max(...known).toFixed(1)} dB.`;
    }
    if (pending > 0) {
      parts.unshift(...pendingRanges(frames).map(([from, to]) => svg("rect", { x: Math.max(from - 0.5, 0), y: 0, width: Math.min(to + 0.5, last) - Math.max(from - 0.5, 0), height, class: "pending" })));
      text += ` ${frames.length - pending} of ${frames.length} frames are rendered.`;
    }
    const now = this.store.state.frame;
    if (curve) parts.push(svg("line", { x1: now, x2: now, y1: 0, y2: height, class: "now" }));
    const title = svg("title", {});
    title.textContent = text;
    this.marks.replaceChildren(title, ...parts);
    this.marks.setAttribute("aria-label", text);
  }
}
