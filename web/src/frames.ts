// Frames on the GPU: loaded when they are asked for or soon will be, the least recently used given up beyond a bound.
import { loadPicture } from "./data";
import { Refusal, type Field } from "./field";
import { samePanel } from "./display";
import { pictureTexture, type Gl } from "./gl";
import type { Interlacer } from "./interlace";

/** What a frame is loaded for: eyes need its views, the panel's picture may be one of its own, a display plays one of codes. */
export type Use = "eye" | "panel" | "display";

export interface LoadedFrame {
  views: WebGLTexture;
  depth: WebGLTexture | null;
  panel: WebGLTexture | null;
  viewSize: [number, number];
  disparities: [number, number];
  bytes: number;
  /** Until depth is there too. */
  whole: Promise<void>;
  givenUp?: boolean;
}

/** Disparities of codes as src/view/disparity_codes.hpp has them. */
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

/** What failed is asked for again after a while: it may have been rendered meanwhile. */
const kRetryMs = 3000;

export class Frames {
  private readonly loaded = new Map<string, LoadedFrame>();
  private readonly loading = new Map<string, Promise<LoadedFrame>>();
  private readonly failures = new Map<string, { error: Error; at: number }>();
  private bytes = 0;
  private pinned: string[] = [];
  private interlacer: Interlacer | null = null;
  /** Of a scene that is set up: the newest picture is shown, whatever frame is asked for. */
  isLive = false;
  private live: LoadedFrame | null = null;

  constructor(
    private readonly gl: Gl,
    private readonly fields: Field[],
    private budget: number,
    private readonly changed: () => void,
    private readonly notice: (text: string) => void,
  ) {}

  /** The frame, where it is there; else it is on its way, and `changed` is called when it is. Throws what loading it threw. */
  get(field: number, frame: number, use: Use): LoadedFrame | null {
    if (this.isLive) return this.live;
    const { label, pending } = this.fields[field].frames[frame];
    if (pending) throw new Refusal(`Frame ${label} is not rendered yet.`);
    const key = `${field}/${frame}/${use}`;
    const failure = this.failures.get(key);
    if (failure && performance.now() - failure.at < kRetryMs) throw failure.error;
    const found = this.loaded.get(key);
    if (found) {
      this.loaded.delete(key);
      this.loaded.set(key, found);
      return found;
    }
    void this.load(field, frame, use);
    return null;
  }

  /** Shows pictures of a scene that is set up in place of those before. */
  async showLive(facts: Field, pictures: { views: Blob; depth: Blob | null; panel: Blob | null }): Promise<void> {
    const options: ImageBitmapOptions = { premultiplyAlpha: "none", colorSpaceConversion: "none" };
    const decode = async (blob: Blob | null) => (blob ? this.fitted(await createImageBitmap(blob, options), options) : null);
    const [views, depth, panel] = await Promise.all([decode(pictures.views), decode(pictures.depth), decode(pictures.panel)]);
    if (!views) return;
    const disparities = depth ? await rangeOf(depth, facts.disparity_scale_mm) : this.guessedRange(facts);
    const before = this.live;
    this.live = {
      views: pictureTexture(this.gl, views, "srgb"),
      depth: depth && pictureTexture(this.gl, depth, "codes"),
      panel: panel && pictureTexture(this.gl, panel, "srgb"),
      viewSize: [views.width / facts.tiles[0], views.height / facts.tiles[1]],
      disparities,
      bytes: 0,
      whole: Promise.resolve(),
    };
    for (const picture of [views, depth, panel]) picture?.close();
    for (const texture of before ? [before.views, before.depth, before.panel] : []) if (texture) this.gl.deleteTexture(texture);
  }

  /** These are not given up, whatever the bound says. */
  pin(fields: number[], frame: number): void {
    this.pinned = fields.map((field) => `${field}/${frame}/`);
  }

  get isLoading(): boolean {
    return this.loading.size > 0;
  }

  /** The frame where it is there; nothing is loaded. */
  peek(field: number, frame: number, use: Use): LoadedFrame | null {
    return this.isLive ? this.live : (this.loaded.get(`${field}/${frame}/${use}`) ?? null);
  }

  /** What a display plays is made by this from now on. */
  playOn(interlacer: Interlacer, budget: number): void {
    this.budget = budget;
    for (const [key, frame] of [...this.loaded]) if (key.endsWith("/display")) this.giveUp(key, frame);
    this.failures.clear();
    this.interlacer?.dispose();
    this.interlacer = interlacer;
  }

  /** How many frames of a field fit. */
  roomFor(field: number, use: Use): number {
    const some = [...this.loaded].find(([key]) => key.startsWith(`${field}/`) && key.endsWith(`/${use}`));
    return some ? Math.max(1, Math.floor(this.budget / some[1].bytes)) : 1;
  }

  load(field: number, frame: number, use: Use): Promise<LoadedFrame | null> {
    if (this.isLive) return Promise.resolve(this.live);
    const key = `${field}/${frame}/${use}`;
    if (this.fields[field].frames[frame].pending) return Promise.resolve(null);
    const found = this.loaded.get(key);
    if (found) return Promise.resolve(found);
    let promise = this.loading.get(key);
    if (!promise) {
      promise = use === "display" ? this.makePlayed(field, frame) : this.make(field, frame, use);
      this.loading.set(key, promise);
      promise
        .then((made) => this.keep(key, made))
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
    for (const texture of new Set([frame.views, frame.depth, frame.panel])) if (texture) this.gl.deleteTexture(texture);
  }

  /** Interlaced as soon as it is there: that takes less memory than its views, and playing it no time. */
  private async makePlayed(field: number, frame: number): Promise<LoadedFrame> {
    const facts = this.fields[field];
    const label = facts.frames[frame].label;
    const interlacer = this.interlacer as Interlacer;
    const { display } = interlacer;
    const isOwn = samePanel(facts.panel.panel, display.panel) && facts.panel.size.join() === display.pixels.join();
    const picture = isOwn ? await this.bitmap(`${field}/panel/${frame}`, label, facts.panel.size) : await this.bitmap(`${field}/views/${frame}`, label, this.quiltSize(facts));
    if (interlacer !== this.interlacer) return picture.close(), this.makePlayed(field, frame);
    const codes = pictureTexture(this.gl, picture, "codes");
    const viewSize: [number, number] = [picture.width / facts.tiles[0], picture.height / facts.tiles[1]];
    picture.close();
    const panel = isOwn ? interlacer.fromOwn(codes) : interlacer.fromViews(facts, codes, viewSize);
    this.gl.deleteTexture(codes);
    const [width, height] = display.pixels;
    return { views: panel, depth: null, panel, viewSize, disparities: [0, 0], bytes: 4 * width * height, whole: Promise.resolve() };
  }

  private async make(field: number, frame: number, use: Use): Promise<LoadedFrame> {
    const facts = this.fields[field];
    const label = facts.frames[frame].label;
    const needsPanel = use === "panel" && facts.panel.is === "own";
    const [views, panel] = await Promise.all([
      this.bitmap(`${field}/views/${frame}`, label, this.quiltSize(facts)),
      needsPanel ? this.bitmap(`${field}/panel/${frame}`, label, facts.panel.size) : null,
    ]);
    const made: LoadedFrame = {
      views: pictureTexture(this.gl, views, "srgb"),
      depth: null,
      panel: panel ? pictureTexture(this.gl, panel, "srgb") : null,
      viewSize: [views.width / facts.tiles[0], views.height / facts.tiles[1]],
      disparities: this.guessedRange(facts),
      // Depth, which follows, counts from the beginning.
      bytes: 4 * (views.width * views.height * (facts.depth ? 2 : 1) + (panel ? panel.width * panel.height : 0)),
      whole: Promise.resolve(),
    };
    views.close();
    panel?.close();
    if (facts.depth) made.whole = this.addDepth(made, field, frame);
    return made;
  }

  /** Views are shown blended until their depth is there. */
  private async addDepth(made: LoadedFrame, field: number, frame: number): Promise<void> {
    const facts = this.fields[field];
    try {
      const depth = await this.bitmap(`${field}/depth/${frame}`, facts.frames[frame].label, this.quiltSize(facts));
      made.disparities = await rangeOf(depth, facts.disparity_scale_mm);
      made.depth = pictureTexture(this.gl, depth, "codes");
      depth.close();
      if (made.givenUp) this.gl.deleteTexture(made.depth);
      this.changed();
    } catch (error) {
      this.notice(error instanceof Refusal ? error.message : `Frame ${facts.frames[frame].label}: its depth is damaged.`);
    }
  }

  /** Without depth: twice the depth budget on either side. */
  private guessedRange(facts: Field): [number, number] {
    const budget = facts.depth_budget_mm ?? 0.2 * facts.window_mm.size[1];
    return [-2 * budget, 2 * budget].map((z) => z / Math.max(1 - z * facts.vergence_per_mm, 0.2)) as [number, number];
  }

  private quiltSize(facts: Field): [number, number] {
    return [facts.tiles[0] * facts.view_size[0], facts.tiles[1] * facts.view_size[1]];
  }

  private async bitmap(name: string, label: string, size: [number, number]): Promise<ImageBitmap> {
    const blob = await loadPicture(name);
    const options: ImageBitmapOptions = { premultiplyAlpha: "none", colorSpaceConversion: "none" };
    let picture: ImageBitmap;
    try {
      picture = await createImageBitmap(blob, options);
    } catch {
      throw new Refusal(`Frame ${label}: its picture is damaged and cannot be decoded.`);
    }
    if (picture.width !== size[0] || picture.height !== size[1])
      throw new Refusal(`Frame ${label}: its picture has ${picture.width}x${picture.height} pixels, and the description says ${size[0]}x${size[1]}.`);
    return this.fitted(picture, options);
  }

  /** Quilts larger than the GPU takes are made smaller by a whole factor. */
  private async fitted(picture: ImageBitmap, options: ImageBitmapOptions): Promise<ImageBitmap> {
    const most = this.gl.getParameter(this.gl.MAX_TEXTURE_SIZE) as number;
    const by = Math.ceil(Math.max(picture.width, picture.height) / most);
    if (by <= 1) return picture;
    this.notice(`Shown at 1/${by} of its size: this device's GPU takes ${most} pixels a side.`);
    const small = await createImageBitmap(picture, { ...options, resizeWidth: Math.floor(picture.width / by), resizeHeight: Math.floor(picture.height / by), resizeQuality: "pixelated" });
    picture.close();
    return small;
  }
}
