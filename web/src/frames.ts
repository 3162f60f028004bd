// Keeps frames on the GPU. If they exceed a memory limit, the least recently used frames are freed.
import { asksForCrosstalk, canSavePage, loadPicture, type Progress } from "./data";
import { Refusal, type Field } from "./field";
import { samePanel } from "./display";
import { pictureTexture, type Gl } from "./gl";
import type { Interlacer } from "./interlace";
import { sharesOf, type Provenance } from "./provenance";
import { layerTiles, quiltTexture, type LayerTiles } from "./quilt";

/** Selects the pictures of a frame to load. "eye": the views. "panel": the views and the panel's picture. "display": a
 *  picture that is interlaced for a calibrated panel. "eye/N": views with crosstalk that the server computes, with a
 *  standard deviation of N / 100 pixels. */
export type Use = "eye" | "panel" | "display" | `eye/${number}`;

export interface LoadedFrame {
  layer: LayerTiles;
  views: WebGLTexture;
  depth: WebGLTexture | null;
  panel: WebGLTexture | null;
  /** Undefined: not requested; null: loading, or not available. */
  provenance?: Provenance | null;
  viewSize: [number, number];
  disparities: [number, number];
  bytes: number;
  /** Resolves when the views and the depth have been loaded. */
  whole: Promise<void>;
  givenUp?: boolean;
}

/** Returns the least and the greatest disparity in a picture of disparity codes (src/view/disparity_codes.hpp). */
function disparityRange(pixels: Uint8ClampedArray, scale: number): [number, number] {
  let least = Infinity;
  let greatest = -Infinity;
  for (let i = 0; i < pixels.length; i += 4) {
    const code = pixels[i] * 256 + pixels[i + 1];
    if (code === 0) continue;
    least = Math.min(least, code);
    greatest = Math.max(greatest, code);
  }
  if (least > greatest) return [-scale, scale];
  const disparity = (code: number) => {
    const t = (code - 1) / 32767 - 1;
    return (scale * t) / Math.max(1 - Math.abs(t), 1e-6);
  };
  return [disparity(least), disparity(greatest)];
}

async function rangeOf(codes: ImageBitmap, scale: number): Promise<[number, number]> {
  const side = 512;
  const few = await createImageBitmap(codes, { resizeWidth: side, resizeHeight: side, resizeQuality: "pixelated", premultiplyAlpha: "none", colorSpaceConversion: "none" });
  const canvas = new OffscreenCanvas(side, side);
  const context = canvas.getContext("2d", { willReadFrequently: true }) as OffscreenCanvasRenderingContext2D;
  context.drawImage(few, 0, 0);
  few.close();
  const [least, greatest] = disparityRange(context.getImageData(0, 0, side, side).data, scale);
  const margin = 0.02 * (greatest - least) + 1e-3;
  return [least - margin, greatest + margin];
}

interface LivePictures {
  views: Blob;
  depth: Blob | null;
  panel: Blob | null;
}

const crosstalkOf = (use: Use): string => (use.startsWith("eye/") ? use.slice(3) : "");

const kWhole: [number, number] = [1, 1];

/** A failed request is repeated after this time, because the frame may have been rendered meanwhile. */
const kRetryMs = 3000;

export class Frames {
  private readonly loaded = new Map<string, LoadedFrame>();
  private readonly loading = new Map<string, Promise<LoadedFrame>>();
  private readonly failures = new Map<string, { error: Error; at: number }>();
  private bytes = 0;
  private asked = 0;
  private pinned: string[] = [];
  private interlacer: Interlacer | null = null;
  /** Whether the user sets up a scene. If so, the newest picture of the scene is shown for every frame. */
  isLive = false;
  private live: LoadedFrame | null = null;
  /** Picture of the scene for the calibrated panel; null while the panel is not shown. */
  private livePlayed: LoadedFrame | null = null;
  private livePictures: { facts: Field; pictures: LivePictures } | null = null;
  private isPlayed = false;
  private isRemaking = false;
  /** Previews of the first shown frame, by field, used until the full picture has loaded. */
  private readonly previews = new Map<number, { frame: number; made: LoadedFrame }>();
  private readonly progresses = new Map<string, Progress>();

  constructor(
    private readonly gl: Gl,
    private readonly fields: Field[],
    private budget: number,
    private readonly changed: () => void,
    private readonly notice: (text: string) => void,
    private readonly progressed: () => void,
  ) {}

  private key(field: number, frame: number, use: Use): string {
    return `${field}/${frame}/${this.useFor(field, use)}`;
  }

  private useFor(field: number, use: Use): Use {
    return use.startsWith("eye/") && !asksForCrosstalk(this.fields[field]) ? "eye" : use;
  }

  /** Returns the frame if it is loaded. Otherwise starts to load it and returns null; `changed` is called when it has loaded.
   *  Throws the error if loading failed recently. */
  get(field: number, frame: number, use: Use): LoadedFrame | null {
    if (this.isLive) return this.getLive(use);
    const { label, pending } = this.fields[field].frames[frame];
    if (pending) throw new Refusal(`Frame ${label} is not rendered yet.`);
    const key = this.key(field, frame, use);
    const failure = this.failureOf(key);
    if (failure) throw failure;
    const found = this.loaded.get(key);
    if (found) {
      this.loaded.delete(key);
      this.loaded.set(key, found);
      return found;
    }
    void this.load(field, frame, use);
    return null;
  }

  getPreview(field: number, frame: number, use: Use): LoadedFrame | null {
    const preview = this.previews.get(field);
    return !this.isLive && use !== "display" && use !== "panel" && preview?.frame === frame ? preview.made : null;
  }

  get progress(): Progress | null {
    const all = [...this.progresses.values()];
    if (all.length === 0) return null;
    const sum = (of: (one: Progress) => number) => all.reduce((before, one) => before + of(one), 0);
    return { bytes: sum((one) => one.bytes), of: all.every((one) => one.of !== null) ? sum((one) => one.of as number) : null };
  }

  private async makePreview(field: number, frame: number): Promise<void> {
    const facts = this.fields[field];
    const [width, height] = facts.preview as [number, number];
    try {
      const picture = await this.bitmap(`${field}/preview/${frame}`, facts.frames[frame].label, [facts.tiles[0] * width, facts.tiles[1] * height], facts.tiles);
      const made: LoadedFrame = { layer: null, views: quiltTexture(this.gl, picture, facts.tiles, "srgb"), depth: null, panel: null, viewSize: [width, height], disparities: this.guessedRange(facts), bytes: 0, whole: Promise.resolve() };
      picture.close();
      this.previews.set(field, { frame, made });
      this.changed();
    } catch {
      // Previews fail silently. The full picture reports errors.
    }
  }

  private givePreviewUp(field: number): void {
    const preview = this.previews.get(field);
    this.previews.delete(field);
    if (preview) this.deleteTextures(preview.made);
  }

  /** A preview is loaded only before the first picture. Saved pages have a preview of the first frame only. */
  private wantsPreview(field: number, frame: number, use: Use): boolean {
    const isFirst = ![...this.loaded.keys()].some((key) => key.startsWith(`${field}/`)) && !this.previews.has(field);
    return isFirst && use === "eye" && this.fields[field].preview !== null && (frame === 0 || canSavePage());
  }

  private failureOf(key: string): Error | null {
    const failure = this.failures.get(key);
    return failure && performance.now() - failure.at < kRetryMs ? failure.error : null;
  }

  private getLive(use: Use): LoadedFrame | null {
    this.isPlayed = use === "display";
    if (!this.isPlayed) return this.live;
    const facts = this.livePictures?.facts;
    if (facts && facts.up.views > 1) throw new Refusal(`The scene has ${facts.up.views} rows of views, but a panel shows only one.`);
    if (!this.livePlayed) void this.remakeLive();
    return this.livePlayed;
  }

  private async remakeLive(): Promise<void> {
    if (this.isRemaking || !this.livePictures) return;
    this.isRemaking = true;
    await this.showLive(this.livePictures.facts, this.livePictures.pictures);
    this.isRemaking = false;
    this.changed();
  }

  /** Returns the picture for the calibrated panel: the native picture if the scene was rendered for this panel and the
   *  render is finished, otherwise the interlaced views. */
  private playedLive(facts: Field, views: ImageBitmap, panel: ImageBitmap | null): LoadedFrame | null {
    if (!this.isPlayed || !this.interlacer || facts.up.views > 1) return null;
    return this.played(facts, panel && this.isOwnPicture(facts) ? null : views, panel);
  }

  async showLive(facts: Field, pictures: LivePictures): Promise<void> {
    const shown = (this.livePictures = { facts, pictures });
    const options: ImageBitmapOptions = { premultiplyAlpha: "none", colorSpaceConversion: "none" };
    const decode = async (blob: Blob | null, tiles: readonly [number, number]) => (blob ? this.fitted(await createImageBitmap(blob, options), options, tiles) : null);
    const [views, depth, panel] = await Promise.all([decode(pictures.views, facts.tiles), decode(pictures.depth, facts.tiles), decode(pictures.panel, kWhole)]);
    if (!views) return;
    const disparities = depth ? await rangeOf(depth, facts.disparity_scale_mm) : this.guessedRange(facts);
    if (shown !== this.livePictures) return [views, depth, panel].forEach((picture) => picture?.close());
    const before = [this.live, this.livePlayed];
    this.livePlayed = this.playedLive(facts, views, panel);
    this.live = {
      layer: layerTiles(this.gl, views, facts.tiles),
      views: quiltTexture(this.gl, views, facts.tiles, "srgb"),
      depth: depth && quiltTexture(this.gl, depth, facts.tiles, "codes"),
      panel: panel && pictureTexture(this.gl, panel, "srgb"),
      viewSize: [views.width / facts.tiles[0], views.height / facts.tiles[1]],
      disparities,
      bytes: 0,
      whole: Promise.resolve(),
    };
    for (const picture of [views, depth, panel]) picture?.close();
    before.forEach((one) => one && this.deleteTextures(one));
  }

  endLive(): void {
    this.isLive = false;
    for (const one of [this.live, this.livePlayed]) if (one) this.deleteTextures(one);
    this.live = this.livePlayed = this.livePictures = null;
  }

  /** Protects a frame of these fields from being freed. */
  pin(fields: number[], frame: number): void {
    this.pinned = fields.map((field) => `${field}/${frame}/`);
  }

  get isLoading(): boolean {
    return this.loading.size > 0;
  }

  get isAsking(): boolean {
    return this.asked > 0;
  }

  /** Returns the frame if it is loaded. Loads nothing. */
  peek(field: number, frame: number, use: Use): LoadedFrame | null {
    return this.isLive ? this.live : (this.loaded.get(this.key(field, frame, use)) ?? null);
  }

  /** budget: bytes of frames to keep. */
  playOn(interlacer: Interlacer, budget: number): void {
    this.budget = budget;
    for (const [key, frame] of [...this.loaded]) if (key.endsWith("/display")) this.giveUp(key, frame);
    this.failures.clear();
    this.interlacer?.dispose();
    this.interlacer = interlacer;
    if (this.livePlayed) this.deleteTextures(this.livePlayed);
    this.livePlayed = null;
  }

  roomFor(field: number, use: Use): number {
    const some = [...this.loaded].find(([key]) => key.startsWith(`${field}/`) && key.endsWith(`/${use}`));
    return some ? Math.max(1, Math.floor(this.budget / some[1].bytes)) : 1;
  }

  load(field: number, frame: number, use: Use): Promise<LoadedFrame | null> {
    if (this.isLive) return Promise.resolve(this.live);
    const key = this.key(field, frame, use);
    if (this.fields[field].frames[frame].pending || this.failureOf(key)) return Promise.resolve(null);
    const found = this.loaded.get(key);
    if (found) return Promise.resolve(found);
    let promise = this.loading.get(key);
    if (!promise) {
      promise = use === "display" ? this.makePlayed(field, frame) : this.make(field, frame, this.useFor(field, use));
      this.loading.set(key, promise);
      promise
        .then((made) => {
          this.keep(key, made);
          this.givePreviewUp(field);
        })
        .catch((error: Error) => this.failures.set(key, { error, at: performance.now() }))
        .finally(() => {
          this.loading.delete(key);
          this.changed();
        });
    }
    return promise.catch(() => null);
  }

  private keep(key: string, made: LoadedFrame): void {
    this.loaded.set(key, made);
    this.bytes += made.bytes;
    for (const [old, frame] of this.loaded) {
      if (this.bytes <= this.budget) break;
      if (old === key || this.pinned.some((start) => old.startsWith(start))) continue;
      this.giveUp(old, frame);
    }
  }

  private giveUp(key: string, frame: LoadedFrame): void {
    this.loaded.delete(key);
    this.bytes -= frame.bytes;
    frame.givenUp = true;
    this.deleteTextures(frame);
  }

  private deleteTextures(frame: LoadedFrame): void {
    for (const texture of new Set([frame.views, frame.depth, frame.panel, frame.provenance?.texture ?? null])) if (texture) this.gl.deleteTexture(texture);
  }

  private isOwnPicture(facts: Field): boolean {
    const display = this.interlacer?.display;
    return !!display && samePanel(facts.panel.panel, display.panel) && facts.panel.size.join() === display.pixels.join();
  }

  /** Loads a frame and interlaces it immediately. The result takes less memory than the views, and playing it needs no
   *  further computation. */
  private async makePlayed(field: number, frame: number): Promise<LoadedFrame> {
    const facts = this.fields[field];
    const label = facts.frames[frame].label;
    const interlacer = this.interlacer as Interlacer;
    const isOwn = this.isOwnPicture(facts);
    const picture = isOwn ? await this.bitmap(`${field}/panel/${frame}`, label, facts.panel.size) : await this.quilt(`${field}/views/${frame}`, label, facts);
    if (interlacer !== this.interlacer) return picture.close(), this.makePlayed(field, frame);
    const made = this.played(facts, isOwn ? null : picture, isOwn ? picture : null);
    picture.close();
    return made;
  }

  /** Interlaces `views`, or uses `own`, a native picture of the panel, if `views` is null. */
  private played(facts: Field, views: ImageBitmap | null, own: ImageBitmap | null): LoadedFrame {
    const interlacer = this.interlacer as Interlacer;
    const picture = (views ?? own) as ImageBitmap;
    const tiles = views ? facts.tiles : kWhole;
    const layer = layerTiles(this.gl, picture, tiles);
    const codes = quiltTexture(this.gl, picture, tiles, "codes");
    const viewSize: [number, number] = [picture.width / facts.tiles[0], picture.height / facts.tiles[1]];
    const panel = views ? interlacer.fromViews(facts, codes, viewSize, layer) : interlacer.fromOwn(codes);
    this.gl.deleteTexture(codes);
    const [width, height] = interlacer.display.pixels;
    return { layer: null, views: panel, depth: null, panel, viewSize, disparities: [0, 0], bytes: 4 * width * height, whole: Promise.resolve() };
  }

  private async make(field: number, frame: number, use: Use): Promise<LoadedFrame> {
    const facts = this.fields[field];
    if (this.wantsPreview(field, frame, use)) await this.makePreview(field, frame);
    const label = facts.frames[frame].label;
    const needsPanel = use === "panel" && facts.panel.is === "own";
    const [views, panel] = await Promise.all([
      this.quilt(`${field}/views/${frame}${crosstalkOf(use)}`, label, facts),
      needsPanel ? this.bitmap(`${field}/panel/${frame}`, label, facts.panel.size) : null,
    ]);
    const made: LoadedFrame = {
      layer: layerTiles(this.gl, views, facts.tiles),
      views: quiltTexture(this.gl, views, facts.tiles, "srgb"),
      depth: null,
      panel: panel ? pictureTexture(this.gl, panel, "srgb") : null,
      viewSize: [views.width / facts.tiles[0], views.height / facts.tiles[1]],
      disparities: this.guessedRange(facts),
      // includes the depth and the provenance, which are loaded later
      bytes: (facts.provenance ? views.width * views.height : 0) + 4 * (views.width * views.height * (facts.depth ? 2 : 1) + (panel ? panel.width * panel.height : 0)),
      whole: Promise.resolve(),
    };
    views.close();
    panel?.close();
    if (facts.depth) made.whole = this.addDepth(made, field, frame);
    return made;
  }

  /** Loads the depth of a frame. Until then, views are blended without depth. */
  private async addDepth(made: LoadedFrame, field: number, frame: number): Promise<void> {
    const facts = this.fields[field];
    try {
      const depth = await this.quilt(`${field}/depth/${frame}`, facts.frames[frame].label, facts);
      made.disparities = await rangeOf(depth, facts.disparity_scale_mm);
      made.depth = quiltTexture(this.gl, depth, facts.tiles, "codes");
      depth.close();
      if (made.givenUp) this.gl.deleteTexture(made.depth);
      this.changed();
    } catch (error) {
      this.notice(error instanceof Refusal ? error.message : `Frame ${facts.frames[frame].label}: its depth is damaged.`);
    }
  }

  wantProvenance(made: LoadedFrame, field: number, frame: number): void {
    if (made.provenance !== undefined) return;
    made.provenance = null;
    void this.addProvenance(made, field, frame);
  }

  private async addProvenance(made: LoadedFrame, field: number, frame: number): Promise<void> {
    const facts = this.fields[field];
    this.asked++;
    try {
      const codes = await this.quilt(`${field}/provenance/${frame}`, facts.frames[frame].label, facts);
      if (!made.givenUp) made.provenance = { texture: quiltTexture(this.gl, codes, facts.tiles, "indices"), shares: sharesOf(codes, facts.provenance?.length ?? 0) };
      codes.close();
    } catch (error) {
      this.notice(error instanceof Refusal ? error.message : `Frame ${facts.frames[frame].label}: its provenance is damaged.`);
    }
    this.asked--;
    this.changed();
  }

  /** Returns an assumed range of disparities for views without depth. The range covers twice the depth budget on either side
   *  of the display. */
  private guessedRange(facts: Field): [number, number] {
    const budget = facts.depth_budget_mm ?? 0.2 * facts.window_mm.size[1];
    return [-2 * budget, 2 * budget].map((z) => z / Math.max(1 - z * facts.vergence_per_mm, 0.2)) as [number, number];
  }

  private quilt(name: string, label: string, facts: Field): Promise<ImageBitmap> {
    return this.bitmap(name, label, [facts.tiles[0] * facts.view_size[0], facts.tiles[1] * facts.view_size[1]], facts.tiles);
  }

  private async bitmap(name: string, label: string, size: [number, number], tiles = kWhole): Promise<ImageBitmap> {
    const blob = await loadPicture(name, (now) => {
      this.progresses.set(name, now);
      this.progressed();
    }).finally(() => this.progresses.delete(name));
    const options: ImageBitmapOptions = { premultiplyAlpha: "none", colorSpaceConversion: "none" };
    let picture: ImageBitmap;
    try {
      picture = await createImageBitmap(blob, options);
    } catch {
      throw new Refusal(`Frame ${label}: its picture is damaged and cannot be decoded.`);
    }
    if (picture.width !== size[0] || picture.height !== size[1])
      throw new Refusal(`Frame ${label}: its picture has ${picture.width}x${picture.height} pixels in place of ${size[0]}x${size[1]}.`);
    return this.fitted(picture, options, tiles);
  }

  /** Reduces a picture by an integer factor if a view or a panel exceeds the GPU's texture size. */
  private async fitted(picture: ImageBitmap, options: ImageBitmapOptions, tiles: readonly [number, number]): Promise<ImageBitmap> {
    const most = this.gl.getParameter(this.gl.MAX_TEXTURE_SIZE) as number;
    const views = [picture.width / tiles[0], picture.height / tiles[1]];
    const by = Math.ceil(Math.max(...views) / most);
    if (by <= 1) return picture;
    this.notice(`Shown at 1/${by} of its size: this device's GPU supports at most ${most} pixels a side.`);
    const [resizeWidth, resizeHeight] = views.map((side, i) => tiles[i] * Math.floor(side / by));
    const small = await createImageBitmap(picture, { ...options, resizeWidth, resizeHeight, resizeQuality: "pixelated" });
    picture.close();
    return small;
  }
}
