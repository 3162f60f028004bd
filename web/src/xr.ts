// Shows the light field in a headset (WebXR), with the viewer's head at the intended viewing position of the display. If the
// viewing distance is below kLeastDistanceMm, display and distance are enlarged by the same factor, because near objects strain
// the eyes. The slopes of the eyes do not change, so the eyes stay in the viewing zone.
import { Refusal, type Field } from "./field";
import type { Gl } from "./gl";

// TypeScript's library does not declare WebXR.
interface XrTransform {
  position: { x: number; y: number; z: number };
  inverse: { matrix: Float32Array };
}
interface XrView {
  projectionMatrix: Float32Array;
  transform: XrTransform;
}
interface XrViewport {
  x: number;
  y: number;
  width: number;
  height: number;
}
interface XrLayer {
  framebuffer: WebGLFramebuffer | null;
  getViewport(view: XrView): XrViewport | null;
}
interface XrFrame {
  getViewerPose(space: unknown): { views: XrView[] } | null;
}
interface XrSession extends EventTarget {
  updateRenderState(state: { baseLayer: XrLayer }): void;
  requestReferenceSpace(kind: string): Promise<unknown>;
  requestAnimationFrame(callback: (now: number, frame: XrFrame) => void): number;
  end(): Promise<void>;
}
interface XrSystem extends EventTarget {
  isSessionSupported(mode: string): Promise<boolean>;
  requestSession(mode: string): Promise<XrSession>;
}
type LayerMaker = new (session: XrSession, gl: Gl) => XrLayer;

const systemOf = (): XrSystem | undefined => (navigator as { xr?: XrSystem }).xr;
const layerMaker = (): LayerMaker | undefined => (window as { XRWebGLLayer?: LayerMaker }).XRWebGLLayer;

export interface HeadsetView {
  framebuffer: WebGLFramebuffer | null;
  viewport: XrViewport;
  /** Position of the eye, in mm of the display. */
  eye: [number, number, number];
  /** Matrix (column-major) from mm of the display to the clip space of the eye's picture. */
  clipFromDisplay: number[];
}

const kLeastDistanceMm = 600;

export const enlargement = (field: Field): number => Math.max(1, kLeastDistanceMm / field.eye_mm[2]);

/** Product a b of 4 x 4 matrices (column-major). */
function product(a: ArrayLike<number>, b: ArrayLike<number>): number[] {
  const entry = (row: number, column: number) => [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + row] * b[4 * column + k], 0);
  return [...Array(16).keys()].map((i) => entry(i % 4, i >> 2));
}

export class Headset {
  isThere = false;
  private session: XrSession | null = null;

  constructor(
    private readonly gl: Gl,
    private readonly field: Field,
    private readonly drawViews: (now: number, framebuffer: WebGLFramebuffer | null, views: HeadsetView[]) => void,
    /** Called when a headset is found or lost, entered or left. */
    private readonly changed: () => void,
    private readonly notify: (text: string) => void,
  ) {
    const system = systemOf();
    system?.addEventListener("devicechange", () => void this.look());
    void this.look();
  }

  get isOn(): boolean {
    return this.session !== null;
  }

  async toggle(): Promise<void> {
    this.notify("");
    try {
      if (this.session) await this.session.end();
      else await this.enter();
    } catch (error) {
      this.notify(`Cannot enter the headset: ${error instanceof Error ? error.message : String(error)}`);
    }
  }

  private async look(): Promise<void> {
    const system = systemOf();
    this.isThere = (await system?.isSessionSupported("immersive-vr").catch(() => false)) ?? false;
    this.changed();
  }

  private async enter(): Promise<void> {
    const system = systemOf();
    const Layer = layerMaker();
    if (!system || !Layer) throw new Refusal("this browser has no WebXR.");
    const session = await system.requestSession("immersive-vr");
    try {
      await this.begin(session, Layer);
    } catch (error) {
      await session.end().catch(() => {});
      throw error;
    }
  }

  private async begin(session: XrSession, Layer: LayerMaker): Promise<void> {
    await (this.gl as Gl & { makeXRCompatible(): Promise<void> }).makeXRCompatible();
    const layer = new Layer(session, this.gl);
    session.updateRenderState({ baseLayer: layer });
    const space = await session.requestReferenceSpace("local");
    session.addEventListener("end", () => this.leave(session));
    this.session = session;
    const draw = (now: number, frame: XrFrame): void => {
      if (this.session !== session) return;
      session.requestAnimationFrame(draw);
      this.drawFrame(now, layer, frame.getViewerPose(space)?.views ?? []);
    };
    session.requestAnimationFrame(draw);
    this.changed();
  }

  private leave(session: XrSession): void {
    if (this.session !== session) return;
    this.session = null;
    this.changed();
  }

  private drawFrame(now: number, layer: XrLayer, views: XrView[]): void {
    const shown = views.flatMap((view) => {
      const viewport = layer.getViewport(view);
      return viewport ? [{ framebuffer: layer.framebuffer, viewport, eye: this.eyeOf(view), clipFromDisplay: this.clipFromDisplay(view) }] : [];
    });
    this.drawViews(now, layer.framebuffer, shown);
  }

  /** Position of the eye in mm of the display. The origin of the headset's space, in metres, is the intended viewing
   *  position. */
  private eyeOf(view: XrView): [number, number, number] {
    const mm = 1000 / enlargement(this.field);
    const { x, y, z } = view.transform.position;
    const [left, up, before] = this.field.eye_mm;
    return [left + mm * x, up + mm * y, before + mm * z];
  }

  private clipFromDisplay(view: XrView): number[] {
    const scale = enlargement(this.field) / 1000;
    const [x, y, z] = this.field.eye_mm.map((mm) => -mm * scale);
    const place = [scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, x, y, z, 1];
    return product(view.projectionMatrix, product(view.transform.inverse.matrix, place));
  }
}
