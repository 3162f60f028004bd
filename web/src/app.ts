// The page of a light field: connects its parts, and redraws the picture when the state changes.
import { makeControls } from "./controls";
import type { PanelDisplay } from "./display";
import { depthOfDisparity, naturalSize, Refusal, shareOfZone, shareOutOfZone, slopeInZone, slopeWithinZone, type Field } from "./field";
import { send, type pictures } from "./drop";
import { canSavePage, download, isLocalPage, loadBytes } from "./data";
import { Frames } from "./frames";
import { Hands } from "./hands";
import { toggleKeyList } from "./keys";
import { Live, type Choices } from "./live";
import { planeRange, setPlaneDistance } from "./live_controls";
import { Motion } from "./motion";
import { codeFromLinear, openGl } from "./gl";
import { Pace } from "./pace";
import { Player } from "./player";
import type { Placed } from "./pair";
import { Print, type PrintChoices } from "./print";
import { ProgressLine, type Work } from "./progress";
import { showLegend } from "./provenance";
import { Run, type RunState } from "./run";
import { magnified, Renderer, useOf } from "./renderer";
import { Store, type State } from "./state";
import { Tilt } from "./tilt";
import { Timeline } from "./timeline";
import { Headset, type HeadsetView } from "./xr";

const byId = <Kind extends HTMLElement = HTMLElement>(id: string): Kind => document.getElementById(id) as Kind;

/** Bytes of frames to keep on the GPU: fewer on phones and small machines, whose GPU shares the main memory. */
function frameBudget(): number {
  const gigabytes = (navigator as { deviceMemory?: number }).deviceMemory ?? 4;
  return Math.min(Math.max(gigabytes * 64, 128), 512) * 1024 * 1024;
}

export function fail(error: unknown): void {
  const section = byId("failure");
  const text = error instanceof Refusal ? error.message : `The page failed: ${error instanceof Error ? error.message : String(error)}`;
  const heading = document.createElement("h2");
  heading.textContent = "This light field cannot be shown";
  const paragraph = document.createElement("p");
  paragraph.textContent = text;
  section.replaceChildren(heading, paragraph);
  section.hidden = false;
}

function describe(field: Field): string {
  const { across, up, view_size: size } = field;
  const views = across.views * up.views;
  const grid = up.views > 1 ? `${across.views}\u00d7${up.views} views` : `${views} view${views === 1 ? "" : "s"}`;
  return `${grid} of ${size[0]}\u00d7${size[1]}${field.depth ? ", with depth" : ""}`;
}

export class App {
  readonly store: Store;
  readonly canvas = byId<HTMLCanvasElement>("canvas");
  readonly frames: Frames;
  readonly renderer: Renderer;
  readonly timeline: Timeline;
  readonly player: Player;
  readonly tilt: Tilt;
  readonly headset: Headset;
  readonly live: Live | null;
  readonly run: Run | null;
  readonly print: Print | null;
  readonly motion: Motion;
  private readonly hands: Hands;
  private wanted = true;
  private moved = false;
  private readonly pace = new Pace();
  private notices = new Map<string, string>();
  private prefetching = false;
  private hasDrawn = false;
  private readonly progressLine = new ProgressLine(byId("progress"));
  private eyeHome = "";
  /** The background of the page: red, green and blue from 0 to 1. */
  private ground: number[] = [0, 0, 0];
  private updateControls: () => void = () => {};

  constructor(
    readonly fields: Field[],
    display: PanelDisplay | null,
    about: Choices | null,
    run: RunState | null,
    { prints, drops }: { prints: PrintChoices | null; drops: boolean },
  ) {
    this.run = run && new Run(run, fields[0], () => this.runChanged(), (topic, text) => this.notify(topic, text));
    this.store = new Store(fields, display !== null, display !== null && (about?.plays ?? true), about !== null);
    const gl = openGl(this.canvas);
    this.frames = new Frames(gl, fields, frameBudget(), () => this.redraw(), (text) => this.notify("size", text), () => this.redraw());
    this.renderer = new Renderer(gl, fields, this.frames);
    this.timeline = new Timeline(byId("time"), this.store, (frame) => this.isThere(frame));
    this.live = about && new Live(about, fields[0], this.frames, (picture) => this.sceneChanged(picture), (topic, text) => this.notify(topic, text));
    this.print = prints && new Print(prints, fields[0], this.frames, () => this.store.state, (facts) => this.takeFacts(facts), (picture) => this.printChanged(picture), (topic, text) => this.notify(topic, text));
    this.player = new Player(gl, this.store, this.frames, byId("stage"), (about, text) => this.notify(about, text), (dropped) => void this.takePictures(dropped, drops));
    if (display) this.beginPlaying(display);
    this.motion = new Motion(() => this.shares(), () => this.motionChanged());
    // An address that states what to show must not be overridden by the swaying eye.
    if (/[#&](eye|frame|line|aperture)=/.test(location.hash)) this.motion.end();
    this.tilt = new Tilt(
      () => [0, 1].map((axis) => this.store.state.eye[axis] / this.store.state.eye[2]) as [number, number],
      ([x, y]) => this.moveEye(shareOfZone(fields[0].across, x), shareOfZone(fields[0].up, y)),
      () => this.store.touch(),
      (text) => this.notify("tilt", text),
    );
    this.headset = new Headset(
      gl,
      fields[0],
      (now, framebuffer, views) => this.drawHeadset(now, framebuffer, views),
      () => this.headsetChanged(),
      (text) => this.notify("headset", text),
    );
    this.updateControls = makeControls(byId("controls"), this.store, {
      savePicture: () => this.savePicture(),
      copyLink: () => void this.copyLink(),
      savePage: canSavePage() ? { save: () => void this.savePage(), whyNot: () => this.whyNotSaved() } : null,
      isLocal: isLocalPage(),
      focusRange: () => this.focusRange(),
      player: this.player,
      tilt: this.tilt,
      headset: this.headset,
      live: this.live,
      run: this.run,
      print: this.print,
      motion: this.motion,
      zoom: { fit: () => this.hands.fit(), trueSize: () => this.hands.showTrueSize() },
      savePrint: () => this.print?.save(fields[0].title),
    });
    this.store.listen(() => {
      this.moved = true;
      if (document.documentElement.dataset.theme !== this.store.state.theme) this.applyTheme();
      this.outdate();
    });
    this.store.listen(() => this.live?.setFrame(this.store.state.frame));
    this.store.listen(() => this.print?.follow());
    this.hands = new Hands(this);
    this.listen();
    this.applyTheme();
    this.head();
    this.motionChanged();
    if (this.run) this.beginRun();
    if (this.player.isPlaying && !this.live) this.timeline.toggle();
    requestAnimationFrame((now) => this.tick(now));
  }

  private async takePictures(dropped: ReturnType<typeof pictures>, isAllowed: boolean): Promise<void> {
    try {
      const found = await dropped;
      if (!isAllowed) throw new Refusal("To drop pictures, start `lippmann view` without a name.");
      await send(found, (share) => this.notify("drop", `The pictures are being read: ${Math.round(100 * share)}\u2009%`));
    } catch (error) {
      this.notify("drop", error instanceof Refusal ? error.message : String(error));
    }
  }

  private beginPlaying(display: PanelDisplay): void {
    if (this.live) this.player.follow(display);
    else this.player.playOn(display);
  }

  redraw(): void {
    this.wanted = true;
  }

  /** Tests read data-drawn: it is false from a change until the picture is drawn. */
  private outdate(): void {
    byId("stage").dataset.drawn = "false";
    this.redraw();
  }

  private sceneChanged(picture: boolean): void {
    const [field] = this.fields;
    this.followOthers();
    if (this.eyeHome !== field.eye_mm.join()) {
      this.eyeHome = field.eye_mm.join();
      this.store.set({ eye: field.eye_mm });
    }
    byId("facts").textContent = `${describe({ ...field, depth: false })}${this.settingsBefore()}`;
    this.showProgress("scene", this.workOnScene());
    byId("facts").title = this.live?.state?.depth.summary ?? "";
    byId("stage").dataset.rest = String(this.live?.isAtRest);
    byId("stage").dataset.outdated = String(this.live?.isOutdated);
    if (picture) this.outdate();
    this.updateControls();
  }

  /** Adopts the frame and the panel that another page chose for the same scene. The server chooses the initial frame, unless
   *  the address states one. */
  private followOthers(): void {
    const frame = this.live?.othersFrame ?? null;
    if (this.live?.isNew && this.store.state.frame > 0) this.live.setFrame(this.store.state.frame);
    else if (frame !== null && !this.timeline.playing) this.store.set({ frame });
    if (this.live?.state) this.player.follow(this.live.state.display);
  }

  /** If the selected frame is not finished, selects a finished one. */
  private beginRun(): void {
    const { frames } = this.fields[0];
    if (frames[this.store.state.frame].pending) this.store.set({ frame: Math.max(frames.findIndex((frame) => !frame.pending), 0) });
    this.runChanged();
  }

  /** Called when frames are finished, and when the render is stopped or resumed. */
  private runChanged(): void {
    const isOver = this.run?.state.state === "finished";
    byId("facts").textContent = isOver ? describe(this.fields[0]) : (this.run?.describe() ?? "");
    this.notify("run", this.run?.state.error ?? "");
    this.timeline.takeFrames();
    this.updateControls();
    this.redraw();
  }

  /** Replaces properties of the light field. The eye keeps its relative position in the viewing zone. */
  private takeFacts(facts: Partial<Field>): void {
    const [field] = this.fields;
    const [across, up] = this.shares();
    Object.assign(field, facts);
    const [, y, z] = field.eye_mm;
    this.store.set({ eye: [slopeInZone(field.across, across) * z, field.up.views > 1 ? slopeInZone(field.up, up) * z : y, z] });
  }

  /** Called while a print is made, and when the print replaces the views. */
  private printChanged(picture: boolean): void {
    const stage = byId("stage");
    stage.dataset.print = this.print?.isBusy ? "making" : this.print?.isSeen ? "shown" : "";
    this.canvas.style.cursor = this.print?.awaitsClick ? "crosshair" : "";
    if (picture) {
      this.timeline.pause();
      this.noticeOfAssumption();
      byId("facts").textContent = this.print?.isSeen ? "seen through the lenses of the print" : describe(this.fields[0]);
      this.outdate();
    }
    this.updateControls();
  }

  private settingsBefore(): string {
    if (this.live?.isAtRest) return ", as rendered";
    return this.live?.isOutdated ? ", with the previous settings" : "";
  }

  private workOnScene(): Work | null {
    const state = this.live?.state;
    if (!state || this.live?.isAtRest || state.error) return null;
    if (state.render?.state === "running") return { what: "Coarse pictures while the job is rendered" };
    if (state.pass === "") return { what: "Setting up the scene" };
    return { what: state.pass === "final" ? "Rendering" : "Rendering a first look", share: state.share };
  }

  private head(): void {
    const titles = this.fields.map((field) => field.title);
    document.title = `${titles.join(" and ")} \u2013 Lippmann`;
    byId("title").textContent = byId("title").title = titles.join(" and ");
    byId("facts").textContent = describe(this.fields[0]);
    this.noticeOfShapes();
    this.noticeOfAssumption();
  }

  /** Tells the user if camera positions are assumed. Prints need no such notice, because their lenses are known. */
  private noticeOfAssumption(): void {
    const isAssumed = this.fields.some((field) => field.assumption) && !this.print?.isSeen;
    this.notify("assumption", isAssumed ? "The positions of the cameras are unknown: angles and depths are assumed." : "");
  }

  /** Warns if two compared displays have different aspects, because the second picture is then distorted. */
  private noticeOfShapes(): void {
    const [first, second] = this.fields.map((field) => field.window_mm.size[0] / field.window_mm.size[1]);
    if (second !== undefined && Math.abs(first / second - 1) > 0.02)
      this.notify("shapes", "Their displays differ in shape: the second is stretched to the first.");
  }

  private notify(about: string, text: string): void {
    if (text) this.notices.set(about, text);
    else this.notices.delete(about);
    const all = [...this.notices.values()].join(" ");
    const notice = byId("notice");
    if (notice.textContent !== all) notice.textContent = all;
  }

  private notifyBriefly(about: string, text: string): void {
    this.notify(about, text);
    window.setTimeout(() => this.notify(about, ""), 5000);
  }

  shown(): number[] {
    return this.renderer.shownFields(this.store.state);
  }

  private isThere(frame: number): boolean {
    if (this.live) return this.live.shownFrame === this.store.state.frame;
    const use = useOf(this.store.state);
    try {
      return this.shown().every((field) => this.frames.get(field, this.renderer.frameOf(field, frame), use) !== null);
    } catch {
      return true;
    }
  }

  private tick(now: number): void {
    requestAnimationFrame((next) => this.tick(next));
    if (this.headset.isOn) return;
    this.timeline.tick(now);
    if (this.fitCanvas()) this.wanted = true;
    if (this.motion.step(now, this.maySway())) this.wanted = true;
    if (!this.wanted && !this.pace.rests()) return;
    this.wanted = false;
    const divisor = this.pace.draws(now, this.moved);
    this.moved = false;
    this.draw(this.store.state.show === "eye" ? divisor : 1);
  }

  /** The eye sways only if the light field has parallax and nothing else moves. */
  private maySway(): boolean {
    const [field] = this.fields;
    const isThere = byId("stage").dataset.drawn === "true" && (!this.live || this.live.isAtRest);
    return isThere && !this.isPending && field.across.views * field.up.views > 1 && this.store.state.show === "eye" && !this.timeline.playing && !this.tilt.isOn && !this.print?.isWanted;
  }

  private motionChanged(): void {
    const [field] = this.fields;
    const hint = byId("hint");
    const isFirstLook = !this.motion.isOver && !this.player.isPlaying && field.across.views * field.up.views > 1;
    hint.textContent = isFirstLook ? (this.live ? "Drag to turn the scene" : "Drag to look around") : "";
    this.updateControls();
    this.redraw();
  }

  /** Draws at the headset's frame rate. The page's own picture is not drawn meanwhile. */
  private drawHeadset(now: number, framebuffer: WebGLFramebuffer | null, views: HeadsetView[]): void {
    this.timeline.tick(now);
    const { state } = this.store;
    this.frames.pin(this.shown(), state.frame);
    this.renderer.drawHeadset(state, framebuffer, views, this.ground);
    void this.prefetch();
  }

  private headsetChanged(): void {
    const isOn = this.headset?.isOn ?? false;
    byId("stage").dataset.headset = String(isOn);
    this.notify("in headset", isOn ? "The headset shows the light field. Leave VR returns to this page." : "");
    this.updateControls();
    this.redraw();
  }

  /** Applies the colour scheme, and draws the canvas on the page's background. */
  private applyTheme(): void {
    document.documentElement.dataset.theme = this.store.state.theme;
    const colour = getComputedStyle(document.body).backgroundColor;
    this.ground = (colour.match(/[\d.]+/g) ?? []).slice(0, 3).map((code) => Number(code) / 255);
    this.redraw();
  }

  private fitCanvas(): boolean {
    document.body.classList.toggle("plays", this.player.isPlaying);
    if (this.player.isPlaying) {
      const changed = this.player.fit(this.canvas);
      this.renderer.screen = [this.canvas.width, this.canvas.height];
      return changed;
    }
    this.canvas.style.width = this.canvas.style.height = "";
    this.notify("screen", "");
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    const [before, above] = this.renderer.screen;
    this.renderer.screen = [width, height];
    return before !== width || above !== height;
  }

  /** divisor: the factor by which the picture has fewer columns and rows than the screen. */
  private draw(divisor = 1): void {
    const state = this.seen;
    this.frames.pin(this.shown(), state.frame);
    this.renderer.loupe = state.show === "panel" ? this.hands.pointer : null;
    let drawn = false;
    try {
      drawn = this.renderer.draw(state, this.ground, divisor);
      this.notify("frame", "");
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      this.notify("frame", error.message);
      if (this.isPending) this.renderer.drawBlank(state, this.ground);
      drawn = true;
    }
    const isWhole = drawn && !this.isPreview();
    this.hasDrawn ||= drawn && !this.isPending;
    const stage = byId("stage");
    this.showProgress("frame", isWhole || this.live ? null : { what: "Loading", ...(this.frames.progress ?? { bytes: 0, of: null }) });
    if (!this.live) stage.dataset.outdated = String(!drawn && this.hasDrawn);
    stage.dataset.show = state.show;
    stage.dataset.empty = String(!this.hasDrawn && !this.isPending);
    stage.dataset.pending = String(this.isPending);
    stage.dataset.preview = String(drawn && !isWhole);
    stage.dataset.drawn = String(isWhole && divisor === 1 && !this.frames.isAsking);
    stage.dataset.divisor = String(divisor);
    stage.dataset.frame = isWhole ? String(this.live?.shownFrame ?? state.frame) : "";

    this.canvas.setAttribute("aria-label", this.spoken());
    if (!drawn) return;
    this.showZone();
    this.showValues();
    this.showScale();
    this.showOrigins();
    this.showLine();
    this.showCaptions();
    if (isWhole) void this.prefetch();
  }

  /** Whether the selected frame is not rendered yet. */
  private get isPending(): boolean {
    return this.fields[0].frames[this.store.state.frame].pending ?? false;
  }

  private isPreview(): boolean {
    const { state } = this.store;
    const isThere = (field: number): boolean => {
      const frame = this.renderer.frameOf(field, state.frame);
      return this.frames.peek(field, frame, useOf(state)) !== null || this.frames.getPreview(field, frame, useOf(state)) === null;
    };
    return !this.shown().every(isThere);
  }

  /** Updates the progress line, which shows the work that began first. about: identifies the work. */
  private showProgress(about: string, now: Work | null): void {
    this.progressLine.show(about, now);
  }

  private spoken(): string {
    const { state } = this.store;
    return `${this.fields[0].title}, frame ${this.fields[0].frames[state.frame].label}: ${this.shownText()}`;
  }

  private shownText(): string {
    const { state } = this.store;
    if (state.show === "display") return `played on ${this.player.describe()}. F fills the screen, ${this.live ? "arrow keys do what dragging does, " : ""}space plays.`;
    const eye = state.eye.map((x) => x.toFixed(0)).join(", ");
    return `${state.show === "panel" ? "what the panel shows" : `seen from ${eye} millimetres`}. Arrow keys move the eye, space plays.`;
  }

  /** Loads the next frames, one at a time, until the memory for frames is full. */
  private async prefetch(): Promise<void> {
    if (this.prefetching || this.live) return;
    this.prefetching = true;
    const { state } = this.store;
    const use = useOf(state);
    const count = this.fields[0].frames.length;
    const room = Math.min(count, this.frames.roomFor(0, use));
    const from = state.frame;
    for (let i = 1; i < room && state.frame === from; i++)
      for (const field of this.shown()) await (await this.frames.load(field, this.renderer.frameOf(field, (from + i) % count), use))?.whole;
    this.prefetching = false;
    if (state.frame !== from) this.redraw();
  }

  private showLine(): void {
    const { state } = this.store;
    const line = byId("line");
    line.hidden = state.line < 0 || state.show !== "eye";
    if (line.hidden) return;
    const { left, top, width, height } = this.renderer.place;
    const ratio = this.canvas.clientWidth / this.renderer.screen[0];
    line.style.left = `${this.canvas.offsetLeft + left * ratio}px`;
    line.style.top = `${this.canvas.offsetTop + (top + state.line * height) * ratio}px`;
    line.style.width = `${width * ratio}px`;
  }

  private showCaptions(): void {
    const { pair, screen } = this.renderer;
    const ratio = this.canvas.clientWidth / screen[0];
    const { magnify, pan } = this.store.state;
    const name = (id: string, text: string, placed: Placed | undefined) => {
      const caption = byId(id);
      caption.hidden = !placed;
      if (!placed) return;
      const { room } = placed;
      const shown = magnified(placed, magnify, pan);
      const bottom = Math.min(room.top + room.height, shown.top + shown.height);
      const middle = Math.min(Math.max(shown.left + shown.width / 2, room.left), room.left + room.width);
      caption.textContent = text;
      const half = caption.offsetWidth / 2;
      const stage = byId("stage").clientWidth;
      caption.style.left = `${Math.max(half, Math.min(this.canvas.offsetLeft + middle * ratio, stage - half))}px`;
      caption.style.top = `${this.canvas.offsetTop + bottom * ratio}px`;
    };
    name("eye-caption", "What an eye sees", pair?.eye);
    const scale = pair ? pair.scale * magnify : 0;
    name("panel-caption", `The panel behind the lenses${Number.isInteger(scale) ? `, ${scale}:1` : ""}`, pair?.panel);
  }

  private showZone(): void {
    const state = this.seen;
    const field = this.fields[this.shown()[0]];
    const share = state.show === "eye" ? shareOutOfZone(field, state.eye) : 0;
    const beyond = { stays: "the outermost views", repeats: "the views of the next cone", "next lens": "the pictures of neighbouring lenses" }[field.across.beyond];
    this.notify("zone", share > 0 ? `This eye is outside the viewing zone of ${Math.max(1, Math.round(100 * share))}\u2009% of the display: there it sees ${beyond}.` : "");
  }

  private showScale(): void {
    const { state } = this.store;
    const scale = byId("scale");
    scale.hidden = this.shown().length < 2 || state.compare !== "difference";
    if (scale.hidden) return;
    const errors = this.difference();
    scale.textContent = "";
    const ends = document.createElement("span");
    ends.textContent = `0 to ${Math.round(state.scale)} codes`;
    const psnr = document.createElement("span");
    psnr.textContent = errors === Infinity ? "identical" : `${errors.toFixed(2)} dB`;
    const strip = document.createElement("i");
    scale.append(strip, ends, psnr);
    if (this.fields[0].frames[state.frame].psnr_db === undefined && this.timeline.psnr[state.frame] !== errors) {
      this.timeline.psnr[state.frame] = errors;
      this.timeline.update();
    }
  }

  private showOrigins(): void {
    const { state } = this.store;
    const overlay = state.show === "display" ? "none" : state.overlay;
    showLegend(byId("legend"), this.fields[this.shown()[0]], overlay, overlay === "none" ? null : this.renderer.originShares(state));
  }

  /** PSNR in dB of the second light field's picture against the first, computed on the displayed 8-bit codes. */
  private difference(): number {
    const [first, second] = [0, 1].map((field) => this.renderer.picture({ ...this.store.state, overlay: "none" }, field, naturalSize(this.fields[0])));
    if (!first || !second) return NaN;
    let sum = 0;
    for (let i = 0; i < first.length; i++) sum += (first[i] - second[i]) ** 2;
    return sum === 0 ? Infinity : 10 * Math.log10((255 ** 2 * 0.75 * first.length) / sum);
  }

  private showValues(): void {
    const state = this.seen;
    const values = byId<HTMLOutputElement>("values");
    const { pointer } = this.hands;
    const share = pointer && this.renderer.shareAt(state, pointer.x, pointer.y);
    if (!share || state.show === "display" || this.isPending) {
      values.value = "";
      return;
    }
    const field = this.fields[this.shown()[0]];
    const size = state.show === "panel" ? field.panel.size : naturalSize(field);
    const parts = [`${Math.floor(share[0] * size[0])}, ${Math.floor(share[1] * size[1])}`];
    this.shown().forEach((_, i) => {
      const linear = this.renderer.valueAt(i as 0 | 1, share);
      parts.push(linear.map((v) => String(codeFromLinear(v * 2 ** state.exposure)).padStart(3, "\u2007")).join(" "));
      if (this.shown().length === 1) parts.push(linear.map((v) => v.toFixed(3)).join(" "));
    });
    if (field.depth && state.show === "eye" && this.shown().length === 1) {
      const depth = this.renderer.depthAt(state, share);
      if (depth !== null && Math.abs(depth) < 1e4) parts.push(`z ${depth.toFixed(1)} mm`);
    }
    values.value = parts.join("   ");
  }

  private focusRange(): [number, number] {
    const field = this.fields[0];
    const { state } = this.store;
    const known = this.frames.peek(0, state.frame, useOf(state));
    if (!known) return [-50, 50];
    const nearest = field.vergence_per_mm > 0 ? 0.8 / field.vergence_per_mm : Infinity;
    const farthest = field.vergence_per_mm > 0 ? -2 / field.vergence_per_mm : -Infinity;
    const [least, most] = known.disparities.map((w) => {
      const z = 1 + w * field.vergence_per_mm > 0.02 ? depthOfDisparity(field, w) : -Infinity;
      return Math.min(Math.max(z, farthest), nearest);
    });
    return [Math.min(least, state.focus), Math.max(most, state.focus, least + 1)];
  }

  // ---- Actions of the mouse and the keyboard (hands.ts) -----------------------------------------------------------------

  shares(): [number, number] {
    const { eye } = this.store.state;
    const field = this.fields[0];
    return [shareOfZone(field.across, eye[0] / eye[2]), shareOfZone(field.up, eye[1] / eye[2])];
  }

  /** Position of the eye at these shares of the viewing zone, clamped to the zone. */
  private eyeAt(across: number, up: number): State["eye"] {
    const { eye } = this.store.state;
    const field = this.fields[0];
    const x = field.across.views > 1 ? slopeWithinZone(field.across, across) * eye[2] : eye[0];
    const y = field.up.views > 1 ? slopeWithinZone(field.up, up) * eye[2] : eye[1];
    return [x, y, eye[2]];
  }

  moveEye(across: number, up: number): void {
    this.store.set({ eye: this.eyeAt(across, up) });
  }

  /** The state to draw, in which the eye may sway or follow the mouse. */
  get seen(): State {
    const state = { ...this.store.state, ...this.print?.preview };
    return this.motion.isAway ? { ...state, eye: this.eyeAt(...this.motion.shares()) } : state;
  }

  /** Ends the automatic motion. stays: the eye stays where it was drawn; otherwise it returns to the position in the state. */
  touched(stays: boolean): void {
    if (stays && this.motion.isAway) this.moveEye(...this.motion.settle());
    this.motion.end();
  }

  /** Moves the display's plane from the distance `from` by a share of its range. Positive shares move it away from the
   *  viewer. */
  movePlane(from: number, share: number): void {
    if (!this.live?.state?.plane) return;
    const [nearest, farthest] = planeRange(this.live);
    setPlaneDistance(this.live, Math.min(Math.max(from + share * (farthest - nearest), nearest), farthest));
  }

  /** Moves the display's plane to the depth of a point. share: the point, as shares of the picture's size. */
  putPlaneAt(share: [number, number]): void {
    const depth = this.renderer.depthAt(this.seen, share);
    if (depth !== null && Number.isFinite(depth)) this.live?.setPlane(depth);
  }

  /** Sets the print's zero plane to the depth of a point. share: the point, as shares of the picture's size. */
  putZeroPlaneAt(share: [number, number]): void {
    const depth = this.renderer.depthAt(this.seen, share);
    if (depth !== null && Number.isFinite(depth)) this.print?.setPlane(depth);
  }

  /** Focuses on a point, and opens the aperture if it is closed. share: the point, as shares of the picture's size. */
  focusAt(share: [number, number]): void {
    const { state } = this.store;
    const depth = this.renderer.depthAt(this.seen, share);
    if (depth === null) return;
    this.store.set({ focus: depth, aperture: state.aperture > 0 ? state.aperture : 0.5 });
  }

  private listen(): void {
    this.canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      fail(new Refusal("The browser has stopped the graphics, perhaps for lack of memory. Reload the page."));
    });
    window.addEventListener("hashchange", () => this.store.readAddress());
    matchMedia("(prefers-color-scheme: light)").addEventListener("change", () => this.applyTheme());
    byId("toggle").addEventListener("click", () => this.toggleControls());
    byId("help").addEventListener("click", () => toggleKeyList(this.live !== null));
    byId("full").addEventListener("click", () => void this.player.toggleFullScreen());
    byId("full").hidden = !document.fullscreenEnabled;
  }

  private toggleControls(): void {
    const open = document.body.classList.toggle("open");
    byId("toggle").setAttribute("aria-expanded", String(open));
  }

  // ---- Saving and sharing -----------------------------------------------------------------------------------------------

  /** Picture of a light field for the eye as RGBA codes, top row first. size: width and height in pixels. */
  async picture(size: [number, number], field = 0): Promise<Uint8ClampedArray> {
    const { state } = this.store;
    const frame = await this.frames.load(field, this.renderer.frameOf(field, state.frame), useOf({ ...state, show: "eye" }));
    await frame?.whole;
    const codes = this.renderer.picture(state, field, size);
    if (!codes) throw new Refusal("The frame is not loaded yet.");
    return codes;
  }

  /** RGBA codes of the panel, top row first, read from the canvas of the same size. */
  panelCodes(): Uint8ClampedArray {
    this.fitCanvas();
    this.draw();
    return this.renderer.canvasCodes();
  }

  private savePicture(): void {
    this.touched(true);
    this.draw();
    this.canvas.toBlob((blob) => {
      if (blob) download(blob, `${this.fields[0].title}-${this.fields[0].frames[this.store.state.frame].label}.png`);
    });
  }

  /** Returns why the page cannot be saved yet, or an empty text. */
  private whyNotSaved(): string {
    if (this.live && this.live.state?.render?.state !== "finished") return "There is nothing to save until a render has finished: choose Render first.";
    return this.run?.state.done === 0 ? "There is nothing to save until a frame is finished." : "";
  }

  /** Saves the page with all its finished pictures as one file, which the server makes. */
  private async savePage(): Promise<void> {
    if (this.whyNotSaved()) return this.notifyBriefly("page", this.whyNotSaved());
    this.notify("page", "");
    try {
      const blob = await loadBytes("page.html", (progress) => this.showProgress("page", { what: "Making the page", ...progress }));
      download(blob, `${this.fields[0].title.replace(/\.[^.]*$/, "")}.html`);
    } catch (error) {
      this.notify("page", error instanceof Error ? error.message : String(error));
    }
    this.showProgress("page", null);
  }

  private async copyLink(): Promise<void> {
    this.touched(true);
    const link = location.href.split("#")[0] + this.store.address();
    try {
      await navigator.clipboard.writeText(link);
      this.notifyBriefly("link", isLocalPage() ? `The link is in the clipboard. It works on this machine only; ${canSavePage() ? "for others, save the page" : "to others, send the page's files"}.` : "The link is in the clipboard.");
    } catch {
      location.hash = this.store.address();
      this.notifyBriefly("link", "The link is in the address bar.");
    }
  }
}
