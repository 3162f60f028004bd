// Renders each eye's picture to a target in linear light, then composes the canvas from them.
import { disparityOfDepth, hasCrosstalk, naturalSize, type Axis, type Field } from "./field";
import type { Frames, LoadedFrame, Use } from "./frames";
import { bind, codeFromLinear, Program, Target, type Gl, type Uniform } from "./gl";
import { eyeShader, kFrameShader, kWindowShader, kWindowVertices, panelShader, screenShader, type ScreenMode, type Variant } from "./shaders";
import { pairOf, trueScale, type Pair, type Rectangle } from "./pair";
import { tints } from "./provenance";
import { bindQuilt } from "./quilt";
import type { State } from "./state";
import type { HeadsetView } from "./xr";

export interface Loupe {
  x: number;
  y: number;
}

type Eye = [number, number, number];

interface Beside {
  target: Target;
  /** The frame and the settings of the picture in the target, or null if the target is empty. */
  shows: { frame: LoadedFrame; key: string } | null;
}

const kBeyond = { stays: 0, repeats: 1, "next lens": 2 };
const kPanelKinds = { integral: 0, quilt: 1, own: 2 };
const kStereoModes = { off: "first", anaglyph: "anaglyph", "side-by-side": "beside", "top-bottom": "above" } as const;
const kCompareModes = { first: "first", second: "first", wipe: "wipe", difference: "difference", "side-by-side": "beside" } as const;
const kLoupeRadius = 92;
/** Least length of a picture's longer side in pixels. Smaller views are upsampled, so that edges of lenses and of depth
 *  look smooth. */
const kLeastLongSide = 800;
/** Upper bound of the longer side of a magnified picture, in pixels. */
const kMostPlace = 8192;

/** Crosstalk applies only to the view of an eye with a closed aperture. */
export const useOf = (state: State): Use => (state.show === "eye" && state.crosstalk > 0 && state.aperture === 0 ? `eye/${Math.round(100 * state.crosstalk)}` : state.show);

export function magnified({ width, height, centre }: { width: number; height: number; centre: [number, number] }, by: number, pan: number[]): Rectangle {
  const place = { width: Math.max(1, Math.round(width * by)), height: Math.max(1, Math.round(height * by)) };
  return { left: Math.round(centre[0] + pan[0] * width - place.width / 2), top: Math.round(centre[1] + pan[1] * height - place.height / 2), ...place };
}

function overlap({ left, top, width, height }: Rectangle, room: Rectangle): Rectangle {
  const at = { left: Math.max(left, room.left), top: Math.max(top, room.top) };
  const [right, bottom] = [Math.min(left + width, room.left + room.width), Math.min(top + height, room.top + room.height)];
  return { ...at, width: Math.max(1, right - at.left), height: Math.max(1, bottom - at.top) };
}

const axisOf = (axis: Axis): number[] => [axis.first, axis.step, axis.by === "angle" ? 1 : 0, kBeyond[axis.beyond]];

export class Renderer {
  /** Size of the canvas in pixels at full resolution. */
  screen: [number, number] = [1, 1];
  /** Size and centre of the picture without magnification. */
  fitted = { width: 1, height: 1, centre: [0, 0] as [number, number] };
  pair: Pair | null = null;
  /** Rectangle of the picture on the canvas, from the top left; may exceed the canvas if magnified. */
  place: Rectangle = { left: 0, top: 0, width: 1, height: 1 };
  /** Rectangle of the panel beside the eye's view, or null if there is none. */
  besidePlace: Rectangle | null = null;
  /** `place`, in pixels of the canvas at its current resolution. */
  private drawn: Rectangle = this.place;
  loupe: Loupe | null = null;
  private readonly eyePrograms = new Map<string, Program>();
  private readonly panelPrograms = new Map<string, Program>();
  private frameProgram: Program | null = null;
  private windowProgram: Program | null = null;
  private readonly screenPrograms = new Map<ScreenMode, Program>();
  /** Whether pictures are drawn directly to the canvas, which halves the time without a GPU. */
  private direct = false;
  /** Rectangle of the panel shown in the last picture. */
  private panelPart: Rectangle = this.place;
  private last: { state: State; field: Field; frame: LoadedFrame } | null = null;
  private readonly targets: [Target, Target, Target, Target];
  /** Pictures of the panels beside the eye's view. They are kept while the eye moves, because they do not change. */
  private readonly beside: [Beside, Beside];

  constructor(
    private readonly gl: Gl,
    private readonly fields: Field[],
    private readonly frames: Frames,
  ) {
    this.targets = [new Target(gl), new Target(gl), new Target(gl), new Target(gl)];
    this.beside = [{ target: new Target(gl), shows: null }, { target: new Target(gl), shows: null }];
  }

  /** Returns the index of the frame to compare: the one with the same label, or else the same index. */
  frameOf(field: number, frame: number): number {
    if (field === 0) return frame;
    const frames = this.fields[field].frames;
    const same = frames.findIndex((one) => one.label === this.fields[0].frames[frame].label);
    return same >= 0 ? same : Math.min(frame, frames.length - 1);
  }

  shownFields(state: State): number[] {
    if (this.fields.length < 2 || state.compare === "first" || state.show === "display") return [0];
    return state.compare === "second" ? [1] : [0, 1];
  }

  /** Draws if all pictures or their previews are loaded, and returns whether they are. divisor: size of the screen / size of
   *  the canvas. */
  draw(state: State, ground: number[], divisor = 1): boolean {
    const shown = this.shownFields(state);
    const loaded = shown.map((field) => this.loaded(field, state) ?? this.frames.getPreview(field, this.frameOf(field, state.frame), useOf(state)));
    if (loaded.some((one) => !one)) return false;
    shown.forEach((field, i) => this.wantOverlay(field, loaded[i] as LoadedFrame, state));
    if (state.show === "display") return this.drawFrame(loaded[0] as LoadedFrame);
    const stereo = shown.length === 1 && state.show === "eye" && state.stereo !== "off";
    const fields = shown.map((one) => this.fields[one]);
    const [field] = fields;
    this.layOut(fields, state, stereo);
    const two = stereo || shown.length > 1;
    this.resize(divisor);
    const whole = this.pictureSize(field, state, two);
    const size = whole.map((side) => Math.max(1, Math.round(side / divisor))) as [number, number];
    this.direct = !two && state.show === "eye" && whole[0] === this.place.width && whole[1] === this.place.height;
    this.last = { state: { ...state }, field, frame: loaded[0] as LoadedFrame };
    if (this.direct) {
      this.drawDirectly(field, loaded[0] as LoadedFrame, state, ground);
      if (state.line >= 0) this.drawLine(field, loaded[0] as LoadedFrame, state);
      if (this.pair) this.drawBeside(this.pair, fields, loaded as LoadedFrame[], state);
      return true;
    }
    shown.forEach((one, i) => {
      const frame = loaded[i] as LoadedFrame;
      if (state.show === "panel") this.drawPanel(this.targets[i], this.fields[one], frame, state, this.place, (this.panelPart = shown.length > 1 ? this.place : overlap(this.place, { left: 0, top: 0, width: this.screen[0], height: this.screen[1] })));
      else if (stereo) this.drawPair(field, frame, state, size);
      else this.drawEye(this.targets[i], this.fields[one], frame, state, state.eye, size);
    });
    this.compose(state, stereo, ground);
    if (state.line >= 0 && state.show === "eye") this.drawLine(field, loaded[0] as LoadedFrame, state);
    if (this.pair) this.drawBeside(this.pair, fields, loaded as LoadedFrame[], state);
    return true;
  }

  private wantOverlay(field: number, frame: LoadedFrame, state: State): void {
    if (state.overlay !== "none" && state.show !== "display" && this.fields[field].provenance) this.frames.wantProvenance(frame, field, this.frameOf(field, state.frame));
  }

  private showsDifference(state: State): boolean {
    return this.shownFields(state).length > 1 && state.compare === "difference";
  }

  private overlays(frame: LoadedFrame, state: State): boolean {
    return state.overlay !== "none" && !this.showsDifference(state) && !!frame.provenance;
  }

  /** For each origin of pixels, its share of the first shown light field; null while the provenance is not loaded. */
  originShares(state: State): number[] | null {
    const field = this.shownFields(state)[0];
    return this.frames.peek(field, this.frameOf(field, state.frame), useOf(state))?.provenance?.shares ?? null;
  }

  private overlayUniforms(field: Field, frame: LoadedFrame, state: State): Record<string, Uniform> {
    return { u_provenance: bindQuilt(this.gl, 3, frame.provenance?.texture ?? frame.views, frame.layer), u_tints: tints(field, state.overlay) };
  }

  private loaded(field: number, state: State): LoadedFrame | null {
    return this.frames.get(field, this.frameOf(field, state.frame), useOf(state));
  }

  /** Draws the frame of a calibrated panel, which has the size of the canvas. */
  private drawFrame(frame: LoadedFrame): true {
    const gl = this.gl;
    const { width, height } = gl.canvas;
    this.place = { left: 0, top: 0, width, height };
    this.pair = this.besidePlace = null;
    this.last = null;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, width, height);
    this.frameProgram ??= new Program(gl, kFrameShader);
    this.frameProgram.draw({ u_frame: bind(gl, 0, frame.panel) });
    return true;
  }

  /** Draws the views of a headset. Eyes behind the display see only the background, as do all eyes before the frame has
   *  loaded. */
  drawHeadset(state: State, framebuffer: WebGLFramebuffer | null, views: HeadsetView[], ground: number[]): void {
    const gl = this.gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.clearColor(ground[0], ground[1], ground[2], 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    const seen: State = { ...state, show: "eye" };
    const [field] = this.shownFields(seen);
    const frame = this.loaded(field, seen);
    for (const view of views) if (frame && view.eye[2] > 1) this.drawWindow(this.fields[field], frame, seen, view);
  }

  private drawWindow(field: Field, frame: LoadedFrame, state: State, view: HeadsetView): void {
    const gl = this.gl;
    const { x, y, width, height } = view.viewport;
    const target = this.targets[0];
    this.drawEye(target, field, frame, state, view.eye, this.windowSize(field, Math.max(width, height)));
    gl.bindFramebuffer(gl.FRAMEBUFFER, view.framebuffer);
    gl.viewport(x, y, width, height);
    this.windowProgram ??= new Program(gl, kWindowShader, kWindowVertices);
    const uniforms = { u_clip_from_display: view.clipFromDisplay, u_window_centre: field.window_mm.centre, u_window_size: field.window_mm.size };
    this.windowProgram.draw({ ...uniforms, u_first: bind(gl, 0, target.texture), u_exposure: 2 ** state.exposure }, 4);
  }

  /** The resolution of the views, limited to what the headset can show. */
  private windowSize(field: Field, shown: number): [number, number] {
    const [width, height] = field.window_mm.size;
    const scale = Math.min(shown, Math.max(...naturalSize(field), kLeastLongSide)) / Math.max(width, height);
    return [Math.max(1, Math.round(width * scale)), Math.max(1, Math.round(height * scale))];
  }

  /** RGBA codes of the canvas, top row first. */
  canvasCodes(): Uint8ClampedArray {
    const gl = this.gl;
    const { width, height } = gl.canvas;
    const codes = new Uint8ClampedArray(4 * width * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(codes.buffer));
    for (let y = 0; y < height >> 1; y++) {
      const above = codes.slice(4 * width * y, 4 * width * (y + 1));
      codes.copyWithin(4 * width * y, 4 * width * (height - 1 - y), 4 * width * (height - y));
      codes.set(above, 4 * width * (height - 1 - y));
    }
    return codes;
  }

  private drawPair(field: Field, frame: LoadedFrame, state: State, size: [number, number]): void {
    [-0.5, 0.5].forEach((side, i) => {
      const [x, y, z] = state.eye;
      this.drawEye(this.targets[i], field, frame, state, [x + side * state.separation, y, z], size);
    });
  }

  /** Draws a grey rectangle in place of each picture of a frame that is not rendered yet. */
  drawBlank(state: State, ground: number[]): void {
    this.layOut(this.shownFields(state).map((one) => this.fields[one]), state, state.stereo !== "off" && state.show === "eye");
    this.resize(1);
    const grey = ground.map((part) => 0.7 * part + 0.15);
    const [width, height] = this.screen;
    const places = this.pair ? [this.place, magnified(this.pair.panel, 1, [0, 0])] : [state.show === "display" ? { left: 0, top: 0, width, height } : this.place];
    this.beginCanvas(ground);
    for (const place of places) {
      this.clip(place);
      this.gl.clearColor(grey[0], grey[1], grey[2], 1);
      this.gl.clear(this.gl.COLOR_BUFFER_BIT);
    }
    this.clip(null);
  }

  /** Divides the canvas's size by `divisor`. The page stretches the canvas over the same rectangle of the screen. */
  private resize(divisor: number): void {
    const { canvas } = this.gl, scaled = (length: number) => Math.round(length / divisor);
    const [width, height] = this.screen.map((side) => Math.max(1, scaled(side)));
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    const { left, top } = this.place;
    this.drawn = { left: scaled(left), top: scaled(top), width: Math.max(1, scaled(this.place.width)), height: Math.max(1, scaled(this.place.height)) };
  }

  /** Computes the rectangles of one or two pictures on the screen, and of the epipolar-plane image below. */
  private layOut(fields: Field[], state: State, stereo: boolean): void {
    const [field] = fields;
    const [width, height] = this.screen;
    const room = height * (state.line >= 0 && state.show === "eye" ? 0.8 : 1);
    const [w, h] = state.show === "panel" ? field.panel.size : field.window_mm.size;
    const isApart = fields.length > 1 && state.compare === "side-by-side";
    const wide = (stereo && state.stereo === "side-by-side") || isApart;
    const high = stereo && state.stereo === "top-bottom";
    const aspect = ((w / h) * (wide ? 2 : 1)) / (high ? 2 : 1);
    const rows = field.panel.size[1] * (high ? 2 : 1);
    const fitted = rows * trueScale(field, Math.min(width / aspect, room) / rows, this.ratio, state.show === "panel");
    const isAlone = stereo || state.line >= 0 || state.show !== "eye";
    this.pair = isAlone ? null : pairOf(fields, isApart, this.screen, this.ratio);
    this.besidePlace = null;
    this.fitted = this.pair?.eye ?? { width: fitted * aspect, height: fitted, centre: [width / 2, room / 2] };
    // The picture is not magnified while the epipolar-plane image is shown below.
    const by = state.line >= 0 && state.show === "eye" ? 1 : Math.min(state.magnify, this.mostMagnified);
    const pan = by === state.magnify ? state.pan : [0, 0];
    this.place = magnified(this.fitted, by, pan);
  }

  /** Pixels of the canvas at full resolution per CSS pixel. */
  private get ratio(): number {
    return this.screen[0] / Math.max(1, (this.gl.canvas as HTMLCanvasElement).clientWidth);
  }

  get mostMagnified(): number {
    return Math.max(1, kMostPlace / Math.max(this.fitted.width, this.fitted.height));
  }

  /** The magnification at which one pixel of the views or of the panel covers one pixel of the screen. */
  magnifiedForTrueSize(state: State): number {
    const field = this.fields[this.shownFields(state)[0]];
    const size = state.show === "panel" ? field.panel.size : naturalSize(field);
    return Math.min(Math.max(...size) / Math.max(this.fitted.width, this.fitted.height), this.mostMagnified);
  }

  private pictureSize(field: Field, state: State, two: boolean): [number, number] {
    const [width, height] = field.window_mm.size;
    const natural = Math.max(...naturalSize(field));
    const halved = two && (state.stereo === "top-bottom" || state.compare === "side-by-side");
    const shown = Math.max(this.place.width, this.place.height) / (halved ? 2 : 1);
    const side = Math.max(2, Math.min(shown, Math.max(natural, kLeastLongSide)));
    if (!two && side === shown) return [this.place.width, this.place.height];
    const scale = side / Math.max(width, height);
    return [Math.max(1, Math.round(width * scale)), Math.max(1, Math.round(height * scale))];
  }

  private fieldUniforms(field: Field, frame: LoadedFrame): Record<string, Uniform> {
    const gl = this.gl;
    return {
      u_views: bindQuilt(gl, 0, frame.views, frame.layer),
      u_depth: bindQuilt(gl, 1, frame.depth ?? frame.views, frame.layer),
      u_panel: bind(gl, 2, frame.panel),
      u_layer_tiles: { integers: frame.layer ?? field.tiles },
      u_view_size: frame.viewSize,
      u_tiles: { integers: field.tiles },
      u_grid: { integers: [field.across.views, field.up.views] },
      u_window_centre: field.window_mm.centre,
      u_window_size: field.window_mm.size,
      u_across: axisOf(field.across),
      u_up: axisOf(field.up),
      u_vergence: field.vergence_per_mm,
      u_disparity_scale: field.disparity_scale_mm,
    };
  }

  private eyeProgram(field: Field, frame: LoadedFrame, task: Variant["task"], through: Partial<Variant> = {}): Program {
    const byAngle = field.across.by === "angle" || field.up.by === "angle";
    const variant: Variant = { byAngle, rows: field.up.views > 1, depth: false, task, layered: frame.layer !== null, screen: false, snap: false, crosstalk: false, budget: false, overlay: false, ...through };
    const key = JSON.stringify(variant);
    const made = this.eyePrograms.get(key) ?? new Program(this.gl, eyeShader(variant));
    this.eyePrograms.set(key, made);
    return made;
  }

  private usesDepth(frame: LoadedFrame, state: State): boolean {
    return (state.between === "depth" || state.budget) && frame.depth !== null && !state.lenses && state.crosstalk === 0;
  }

  private eyeUniforms(field: Field, frame: LoadedFrame, state: State, eye: Eye, size: [number, number]): Record<string, Uniform> {
    const snap = field.lens_samples.map((lens) => (lens && state.lenses ? 1 : 0));
    return {
      ...this.fieldUniforms(field, frame),
      ...(this.overlays(frame, state) ? this.overlayUniforms(field, frame, state) : {}),
      u_output_size: size,
      u_offset: [0, 0],
      u_exposure: 2 ** state.exposure,
      u_eye: eye,
      u_snap: { integers: snap },
      u_disparities: frame.disparities,
      u_aperture: state.aperture,
      u_focus: disparityOfDepth(field, state.focus),
      u_line: state.line,
      u_sigma: state.crosstalk,
      u_budget: Math.min(field.depth_budget_mm ?? 1e9, 1e9),
    };
  }

  private drawDirectly(field: Field, frame: LoadedFrame, state: State, ground: number[]): void {
    const gl = this.gl;
    const { left, top, width, height } = this.drawn;
    const bottom = gl.canvas.height - top - height;
    this.beginCanvas(ground);
    gl.viewport(left, bottom, width, height);
    const [program, uniforms] = this.eyePass(field, frame, state, state.eye, [width, height], true);
    program.draw({ ...uniforms, u_offset: [left, bottom] });
    this.clip(null);
  }

  /** Draws the panel beside the eye's view. Two panels are compared in the same way as two views. Magnification first
   *  enlarges only the eye's view, up to the scale of the panel, and then both pictures. */
  private drawBeside({ eye, panel }: Pair, fields: Field[], frames: LoadedFrame[], state: State): void {
    const by = this.place.width / eye.width;
    const place = (this.besidePlace = magnified(panel, by > 1 ? Math.max(1, this.place.width / panel.width) : by, state.pan));
    if (fields.length > 1 && state.compare === "side-by-side") {
      const width = place.width / 2;
      fields.forEach((field, i) => this.drawPanelBeside(i, field, frames[i], state, { ...place, left: place.left + i * width, width }, panel.room));
      fields.forEach((_, i) => this.composeBeside("first", i, { ...place, left: place.left + i * width, width }, panel.room, state));
      return;
    }
    fields.forEach((field, i) => this.drawPanelBeside(i, field, frames[i], state, place, panel.room));
    this.composeBeside(fields.length > 1 ? kCompareModes[state.compare] : "first", 0, place, panel.room, state);
  }

  private drawPanelBeside(index: number, field: Field, frame: LoadedFrame, state: State, place: Rectangle, room: Rectangle): void {
    const beside = this.beside[index];
    const part = overlap(place, room);
    const key = JSON.stringify([place, part, this.overlays(frame, state) && state.overlay]);
    if (beside.shows?.frame !== frame || beside.shows.key !== key) this.drawPanel(beside.target, field, frame, state, place, part);
    beside.shows = { frame, key };
  }

  /** Composes the part of the panels within `room` on the canvas. index: the panel that is shown, or the first of two. */
  private composeBeside(mode: ScreenMode, index: number, place: Rectangle, room: Rectangle, state: State): void {
    const gl = this.gl;
    if (place.left >= room.left + room.width || place.left + place.width <= room.left) return;
    const part = overlap(place, room);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, gl.canvas.width, gl.canvas.height);
    this.clip(part);
    const wipe = (place.left + state.wipe * place.width - part.left) / part.width;
    this.screenProgram(mode).draw({
      ...this.screenUniforms(state, [0, 0, 0]),
      u_first: bind(gl, 0, this.beside[index].target.texture),
      u_second: bind(gl, 1, this.beside[1].target.texture),
      u_wipe: wipe,
      u_place: this.onCanvas(part),
    });
    this.clip(null);
  }

  /** Clears the canvas, and limits drawing to the room of the eye's view. */
  private beginCanvas(ground: number[]): void {
    const gl = this.gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, gl.canvas.width, gl.canvas.height);
    gl.clearColor(ground[0], ground[1], ground[2], 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    this.clip(this.pair?.eye.room ?? null);
  }

  private clip(room: Rectangle | null): void {
    const gl = this.gl;
    if (!room) return gl.disable(gl.SCISSOR_TEST);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(...this.onCanvas(room));
  }

  /** Returns (left, bottom, width, height) in pixels of the canvas at its current resolution. */
  private onCanvas({ left, top, width, height }: Rectangle): [number, number, number, number] {
    const { canvas } = this.gl;
    const [x, right] = [left, left + width].map((place) => Math.round((place * canvas.width) / this.screen[0]));
    const [y, bottom] = [top, top + height].map((place) => Math.round((place * canvas.height) / this.screen[1]));
    return [x, canvas.height - bottom, right - x, bottom - y];
  }

  private eyePass(field: Field, frame: LoadedFrame, state: State, eye: Eye, size: [number, number], screen: boolean): [Program, Record<string, Uniform>] {
    const task = state.aperture > 0 ? "refocus" : "eye";
    const crosstalk = task === "eye" && state.crosstalk > 0 && hasCrosstalk(field);
    const depth = task === "eye" && this.usesDepth(frame, state);
    const program = this.eyeProgram(field, frame, task, { depth, screen, snap: state.lenses, crosstalk, budget: depth && state.budget, overlay: this.overlays(frame, state) });
    return [program, this.eyeUniforms(field, frame, state, eye, size)];
  }

  private drawEye(target: Target, field: Field, frame: LoadedFrame, state: State, eye: Eye, size: [number, number]): void {
    target.begin(...size);
    const [program, uniforms] = this.eyePass(field, frame, state, eye, size, false);
    program.draw(uniforms);
  }

  private panelProgram(variant: Pick<Variant, "overlay" | "layered">): Program {
    const key = JSON.stringify(variant);
    const made = this.panelPrograms.get(key) ?? new Program(this.gl, panelShader(variant));
    this.panelPrograms.set(key, made);
    return made;
  }

  /** place: rectangle of the whole panel. part: its visible part, so that a magnified panel needs no larger target. */
  private drawPanel(target: Target, field: Field, frame: LoadedFrame, state: State, place: Rectangle, part: Rectangle): void {
    const size = [part.width, part.height].map((side) => Math.min(side, kMostPlace / 2)) as [number, number];
    target.begin(...size);
    const loupe = this.loupe;
    const [w, h] = field.panel.size;
    const [perX, perY] = [w / place.width, h / place.height];
    const cell = field.panel.is === "integral" ? Math.max(field.across.views, field.up.views) : 8;
    const { ratio } = this;
    const radius = kLoupeRadius * ratio;
    const overlay = this.overlays(frame, state);
    this.panelProgram({ overlay, layered: frame.layer !== null }).draw({
      ...this.fieldUniforms(field, frame),
      ...(overlay ? this.overlayUniforms(field, frame, state) : {}),
      u_output_size: size,
      u_panel_size: field.panel.size,
      u_samples: field.view_size,
      u_kind: { integers: [kPanelKinds[field.panel.is]] },
      u_part: [(part.left - place.left) * perX, (part.top - place.top) * perY, part.width * perX, part.height * perY],
      u_loupe: loupe ? [loupe.x - part.left, loupe.y - part.top, radius, Math.max(2 * ratio, Math.floor((1.6 * radius) / (2 * cell)))] : [0, 0, 0, 1],
      u_loupe_at: loupe ? [(loupe.x - place.left) * perX, (loupe.y - place.top) * perY] : [0, 0],
    });
  }

  private screenUniforms(state: State, ground: number[]): Record<string, Uniform> {
    return {
      u_first: bind(this.gl, 0, this.targets[0].texture),
      u_second: bind(this.gl, 1, this.targets[1].texture),
      u_exposure: 2 ** state.exposure,
      u_wipe: state.wipe,
      u_scale: state.scale,
      u_ground: ground,
    };
  }

  private screenProgram(mode: ScreenMode): Program {
    const made = this.screenPrograms.get(mode) ?? new Program(this.gl, screenShader(mode));
    this.screenPrograms.set(mode, made);
    return made;
  }

  private compose(state: State, stereo: boolean, ground: number[]): void {
    const gl = this.gl;
    const { height } = gl.canvas;
    this.beginCanvas(ground);
    let mode: ScreenMode = "first";
    if (stereo) mode = kStereoModes[state.stereo];
    else if (this.shownFields(state).length > 1) mode = kCompareModes[state.compare];
    const drawn = state.show === "panel" ? this.panelPart : this.drawn;
    this.screenProgram(mode).draw({
      ...this.screenUniforms(state, ground),
      u_place: [drawn.left, height - drawn.top - drawn.height, drawn.width, drawn.height],
    });
    this.clip(null);
  }

  private drawLine(field: Field, frame: LoadedFrame, state: State): void {
    const gl = this.gl;
    const { width, height } = gl.canvas;
    const { left, width: across } = this.drawn;
    const size: [number, number] = [across, Math.max(8, Math.round(height * 0.18))];
    const target = this.targets[2];
    target.begin(...size);
    this.eyeProgram(field, frame, "line", { depth: this.usesDepth(frame, state), overlay: this.overlays(frame, state) }).draw(this.eyeUniforms(field, frame, state, state.eye, size));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(left, 0, ...size);
    this.screenProgram("first").draw({
      ...this.screenUniforms(state, [0, 0, 0]),
      u_first: bind(gl, 0, target.texture),
      u_place: [left, 0, ...size],
    });
    gl.viewport(0, 0, width, height);
  }

  /** Converts a point of the canvas to a point of the display, as shares from the top left. Returns null if the point is
   *  outside the picture. */
  shareAt(state: State, x: number, y: number): [number, number] | null {
    const room = this.pair?.eye.room;
    if (room && (x < room.left || y < room.top || x > room.left + room.width || y > room.top + room.height)) return null;
    let share: [number, number] = [(x - this.place.left) / this.place.width, (y - this.place.top) / this.place.height];
    if (share.some((s) => s < 0 || s > 1)) return null;
    const twice = (s: number) => (2 * s) % 1;
    const compared = this.shownFields(state).length > 1;
    if (compared ? state.compare === "side-by-side" : state.stereo === "side-by-side" && state.show === "eye") share = [twice(share[0]), share[1]];
    if (!compared && state.stereo === "top-bottom" && state.show === "eye") share = [share[0], twice(share[1])];
    return share;
  }

  /** Linear light at a point of the last picture. which: index of the light field or of the eye. share: shares from the
   *  top left. */
  valueAt(which: 0 | 1, share: [number, number]): number[] {
    if (this.last && (this.direct || (this.overlays(this.last.frame, this.last.state) && this.last.state.show === "eye"))) return this.valueOfEye(share);
    const target = this.targets[which];
    const [across, down] = this.last?.state.show === "panel" ? this.inPanelPart(share) : share;
    const x = Math.min(target.width - 1, Math.floor(across * target.width));
    const y = Math.min(target.height - 1, Math.floor((1 - down) * target.height));
    return [...target.read(x, y, 1, 1)].slice(0, 3);
  }

  private inPanelPart(share: [number, number]): number[] {
    const { place, panelPart: part } = this;
    const within = (value: number) => Math.min(Math.max(value, 0), 1);
    return [within((place.left + share[0] * place.width - part.left) / part.width), within((place.top + share[1] * place.height - part.top) / part.height)];
  }

  private valueOfEye(share: [number, number]): number[] {
    const { field, frame } = this.last as { state: State; field: Field; frame: LoadedFrame };
    const state: State = { ...(this.last as { state: State }).state, overlay: "none" };
    const { width, height } = this.place;
    const x = Math.min(width - 1, Math.floor(share[0] * width));
    const y = Math.min(height - 1, Math.floor((1 - share[1]) * height));
    const target = this.targets[3];
    target.begin(1, 1);
    const [program, uniforms] = this.eyePass(field, frame, state, state.eye, [width, height], false);
    program.draw({ ...uniforms, u_offset: [-x, -y] });
    return [...target.read(0, 0, 1, 1)].slice(0, 3);
  }

  /** Depth in mm at a point of the display: the known depth, or the depth at which the views agree best. */
  depthAt(state: State, share: [number, number]): number | null {
    const field = this.fields[this.shownFields(state)[0]];
    const frame = this.loaded(this.shownFields(state)[0], state);
    if (!frame || field.across.views * field.up.views < 2) return null;
    const steps = frame.depth ? 1 : 128;
    const { centre, size } = field.window_mm;
    const point = [centre[0] + (share[0] - 0.5) * size[0], centre[1] + (0.5 - share[1]) * size[1]];
    const target = this.targets[3];
    target.begin(steps, 1);
    const uniforms = this.eyeUniforms(field, frame, state, state.eye, [steps, 1]);
    this.eyeProgram(field, frame, "find", { depth: frame.depth !== null }).draw({ ...uniforms, u_point: point });
    const values = target.read(0, 0, steps, 1);
    const [least, greatest] = frame.disparities;
    let disparity = values[0];
    if (!frame.depth) {
      let best = 0;
      for (let i = 1; i < steps; i++) if (values[4 * i] < values[4 * best]) best = i;
      disparity = least + ((best + 0.5) / steps) * (greatest - least);
    }
    return disparity / (1 + disparity * field.vergence_per_mm);
  }

  /** RGBA codes of a light field's picture for the eye, top row first; null while the light field loads. */
  picture(state: State, field: number, size: [number, number]): Uint8ClampedArray | null {
    const frame = this.loaded(field, { ...state, show: "eye" });
    if (!frame) return null;
    const target = this.targets[3];
    this.drawEye(target, this.fields[field], frame, state, state.eye, size);
    const linear = target.read(0, 0, ...size);
    const codes = new Uint8ClampedArray(linear.length);
    const gain = 2 ** state.exposure;
    const [width, height] = size;
    for (let y = 0; y < height; y++)
      for (let i = 0; i < 4 * width; i++) {
        const value = linear[4 * width * (height - 1 - y) + i];
        codes[4 * width * y + i] = i % 4 === 3 ? 255 : codeFromLinear(gain * value);
      }
    return codes;
  }
}
