// Plays a light field on a calibrated panel. In full screen, each pixel of the panel is one pixel of the screen.
import { readCalibration, readDisplay, type PanelDisplay } from "./display";
import { isOfPictures, pictures } from "./drop";
import { Refusal } from "./field";
import type { Frames } from "./frames";
import type { Gl } from "./gl";
import { Interlacer } from "./interlace";
import type { Store } from "./state";

/** Bytes of interlaced frames to keep on the GPU. */
function playedBudget(): number {
  const gigabytes = (navigator as { deviceMemory?: number }).deviceMemory ?? 4;
  return Math.min(Math.max(gigabytes * 256, 512), 2048) * 1024 * 1024;
}

/** Largest accepted size of a calibration file. */
const kMostCalibrationBytes = 1 << 20;

const sizeText = ([width, height]: readonly number[]): string => `${width}\u00d7${height}`;

export class Player {
  display: PanelDisplay | null = null;
  /** The last panel in the server's state of the scene, as JSON. */
  private named = "";
  private isDropped = false;

  constructor(
    private readonly gl: Gl,
    private readonly store: Store,
    private readonly frames: Frames,
    private readonly stage: HTMLElement,
    private readonly notify: (about: string, text: string) => void,
    takePictures: (dropped: ReturnType<typeof pictures>) => void,
  ) {
    document.addEventListener("fullscreenchange", () => this.store.touch());
    window.addEventListener("dragover", (event) => event.preventDefault());
    window.addEventListener("drop", (event) => {
      event.preventDefault();
      if (event.dataTransfer && isOfPictures(event.dataTransfer)) return takePictures(pictures(event.dataTransfer));
      const file = event.dataTransfer?.files[0];
      if (file) void this.take(file);
    });
  }

  /** Throws a Refusal if this device cannot draw the panel, or if a panel cannot show the views. */
  playOn(display: PanelDisplay): void {
    const { up, title } = this.store.fields[0];
    if (up.views > 1 && !this.frames.isLive) throw new Refusal(`${title} has ${up.views} rows of views, but a panel shows only one: \`lippmann convert --keep\` selects one row.`);
    this.takeDisplay(display);
    this.store.set({ show: "display" });
    this.store.touch();
  }

  private takeDisplay(display: PanelDisplay): void {
    this.frames.playOn(new Interlacer(this.gl, display), playedBudget());
    this.display = display;
    this.store.plays = true;
  }

  /** Plays on the panel for which a scene is set up. A calibration that was dropped on the page takes precedence. */
  follow(display: PanelDisplay | null): void {
    const named = JSON.stringify(display);
    if (named === this.named || this.isDropped) return;
    this.named = named;
    if (display) this.takeDisplay(readDisplay(display));
    else this.stop();
    this.store.touch();
  }

  private stop(): void {
    this.display = null;
    this.store.set({ show: this.store.state.show === "display" ? "eye" : this.store.state.show });
    this.store.plays = false;
  }

  async take(file: File): Promise<void> {
    this.notify("calibration", "");
    try {
      if (file.size > kMostCalibrationBytes) throw new Refusal("It is larger than 1 MB, so it is not a calibration.");
      this.playOn(await readCalibration(await file.text()));
      this.isDropped = true;
    } catch (error) {
      this.notify("calibration", `${file.name} cannot be used: ${error instanceof Refusal ? error.message : String(error)}`);
    }
  }

  choose(): void {
    const input = document.createElement("input");
    Object.assign(input, { type: "file", accept: ".json,application/json" });
    input.addEventListener("change", () => input.files?.[0] && void this.take(input.files[0]));
    input.click();
  }

  get isPlaying(): boolean {
    return this.store.state.show === "display" && this.display !== null;
  }

  get canFillScreen(): boolean {
    return document.fullscreenEnabled;
  }

  async toggleFullScreen(): Promise<void> {
    try {
      if (document.fullscreenElement) await document.exitFullscreen();
      else await this.stage.requestFullscreen({ navigationUI: "hide" });
    } catch {
      this.notify("screen", "The browser does not let this page fill the screen.");
    }
  }

  /** Opens a second window, which shows the view of an eye, to set up the scene. */
  openSetUp(): void {
    window.open(`${location.href.split("#")[0]}#show=eye`, "_blank", "popup,width=1200,height=800");
  }

  describe(): string {
    return this.display ? `${this.display.name}, ${sizeText(this.display.pixels)}` : "none";
  }

  /** Gives the canvas the size of the panel. Returns whether its size has changed. */
  fit(canvas: HTMLCanvasElement): boolean {
    const [width, height] = (this.display as PanelDisplay).pixels;
    const changed = canvas.width !== width || canvas.height !== height;
    if (changed) Object.assign(canvas, { width, height });
    const ratio = window.devicePixelRatio || 1;
    const fills = document.fullscreenElement === this.stage;
    canvas.style.width = fills ? `${width / ratio}px` : "";
    canvas.style.height = fills ? `${height / ratio}px` : "";
    this.notify("screen", this.screenNotice(fills, ratio));
    return changed;
  }

  private screenNotice(fills: boolean, ratio: number): string {
    const { pixels } = this.display as PanelDisplay;
    const { gl } = this;
    if (gl.drawingBufferWidth !== gl.canvas.width || gl.drawingBufferHeight !== gl.canvas.height)
      return `This device draws at most ${sizeText([gl.drawingBufferWidth, gl.drawingBufferHeight])} pixels, but the panel has ${sizeText(pixels)}.`;
    if (!fills) return this.canFillScreen ? "Shown as a picture. On the panel's screen, \u201cFull screen\u201d or F plays it pixel for pixel." : "Shown as a picture: this browser cannot fill the screen.";
    const screen = [Math.round(window.innerWidth * ratio), Math.round(window.innerHeight * ratio)];
    const fits = screen.every((side, i) => Math.abs(side - pixels[i]) <= ratio);
    return fits ? "" : `This screen has ${sizeText(screen)} pixels, but the panel ${sizeText(pixels)}: move the window to the panel's screen.`;
  }
}
