// Prints of the light field for lens sheets, made by the server and shown as eyes see them through the lenses
// (web/README.md lists the keys).
import { download, loadPicture, postText } from "./data";
import { depthOfDisparity, disparityOfDepth, Refusal, slopeInZone, type Field } from "./field";
import type { Frames } from "./frames";

export interface PrintChoices {
  displays: string[];
}

interface Made {
  id: number;
  description: string;
  fitted: string;
  pixels: [number, number];
  field: Field;
}

/** The display is a lens sheet on paper, with the settings of the page's controls. */
export const kSheet = "sheet";
/** The display is in a file that the user has chosen. */
export const kFile = "file";

export interface PrintSettings {
  display: string;
  lpi: string;
  dpi: string;
  paper: string;
  landscape: boolean;
  fit: "" | "crop" | "pad" | "stretch";
  shift: number;
}

const message = (error: unknown): string => (error instanceof Error ? error.message : String(error));

export class Print {
  readonly settings: PrintSettings;
  file: { name: string; text: string } | null = null;
  made: Made | null = null;
  /** Whether the user wants to see the print through the lens sheet. */
  isWanted = false;
  isSeen = false;
  /** Whether the next click on the picture sets the zero plane. */
  awaitsClick = false;
  /** Focus and aperture of the views while the zero plane is dragged, otherwise null. */
  preview: { aperture: number; focus: number } | null = null;
  private madeOf = "";
  private shownId = 0;
  private pending = 0;
  private hasPanel = false;
  private queue: Promise<void> = Promise.resolve();
  private readonly own: Field;

  constructor(
    readonly about: PrintChoices,
    field: Field,
    private readonly frames: Frames,
    private readonly state: () => { frame: number; show: string },
    private readonly take: (facts: Partial<Field>) => void,
    private readonly changed: (picture: boolean) => void,
    private readonly notify: (about: string, text: string) => void,
  ) {
    this.own = { ...field };
    const [width, height] = field.window_mm.size;
    this.settings = { display: kSheet, lpi: "60", dpi: "600", paper: "A5", landscape: width > height, fit: "", shift: 0 };
  }

  get isBusy(): boolean {
    return this.pending > 0;
  }

  /** Range of the shift per view, in pixels. At its ends, the outermost views are shifted by 15 % of their width. */
  get shiftRange(): [number, number] {
    const { across, view_size: size } = this.own;
    const most = (0.3 * size[0]) / Math.max(across.views - 1, 1);
    return [-most, most];
  }

  set(changes: Partial<PrintSettings>): void {
    Object.assign(this.settings, changes);
    this.notify("print", "");
    if (this.isWanted) this.enqueue(() => this.show());
    this.changed(false);
  }

  /** Shows the view through the sheet, because the zero plane is visible only there. */
  setShift(shift: number): void {
    this.isWanted = true;
    this.set({ shift });
  }

  /** Motion of a point from view to view, in pixels, per mm of its disparity. */
  private get pixelsPerDisparity(): number {
    const { across, view_size: size, window_mm: window } = this.own;
    const last = slopeInZone(across, 1 - 0.5 / across.views);
    const first = slopeInZone(across, 0.5 / across.views);
    return (((last - first) / Math.max(across.views - 1, 1)) * size[0]) / window.size[0];
  }

  private within(shift: number): number {
    const [least, most] = this.shiftRange;
    return Math.min(Math.max(shift, least), most);
  }

  setPlane(depth: number): void {
    this.awaitsClick = false;
    this.setShift(this.within(-disparityOfDepth(this.own, depth) * this.pixelsPerDisparity));
  }

  /** Moves the zero plane by a drag, and shows the plane by focusing on it. from: shift at the start of the drag. across:
   *  motion to the right, as a share of the picture. */
  dragPlane(from: number, across: number): void {
    const [least, most] = this.shiftRange;
    this.settings.shift = this.within(from + across * (most - least));
    this.preview = { aperture: 0.5, focus: depthOfDisparity(this.own, -this.settings.shift / this.pixelsPerDisparity) };
    this.changed(false);
  }

  dropPlane(): void {
    this.preview = null;
    this.awaitsClick = false;
    this.setShift(this.settings.shift);
  }

  see(on: boolean): void {
    this.isWanted = on;
    this.awaitsClick = false;
    this.notify("print", "");
    this.enqueue(() => this.show());
  }

  /** Shows the views without the sheet while the page waits for the click. */
  awaitClick(on: boolean): void {
    this.see(false);
    this.awaitsClick = on;
    this.changed(false);
  }

  async chooseFile(file: File): Promise<void> {
    if (file.size > 1 << 19) return this.notify("print", `${file.name} is larger than 512 kB, so it is not a display.`);
    this.file = { name: file.name, text: await file.text() };
    this.set({ display: kFile });
  }

  /** Makes the print again if it is shown and no longer fits the state. */
  follow(): void {
    if (!this.isWanted || this.isBusy) return;
    if (this.state().show === "display") this.see(false);
    else if (!this.isCurrent()) this.enqueue(() => this.show());
  }

  private isCurrent(): boolean {
    const isThere = this.isSeen && this.shownId === this.made?.id && this.madeOf === this.request();
    return isThere && (this.hasPanel || !this.needsPanel(this.made as Made));
  }

  private needsPanel(made: Made): boolean {
    return this.state().show === "panel" && made.field.panel.is === "own";
  }

  save(title: string): void {
    this.notify("print", "");
    this.enqueue(async () => {
      const made = await this.make();
      const blob = await this.picture("file", made);
      download(blob, `${title.replace(/\.[^.]*$/, "")}-print.png`);
    });
  }

  private enqueue(task: () => Promise<void>): void {
    this.pending++;
    this.changed(false);
    this.queue = this.queue
      .then(task)
      .catch((error: unknown) => {
        this.leave();
        this.notify("print", message(error));
      })
      .finally(() => {
        this.pending--;
        this.changed(false);
        this.follow();
      });
  }

  private request(): string {
    const { display, lpi, dpi, paper, landscape, fit, shift } = this.settings;
    const shown = display === kFile && this.file ? { file: this.file } : { display: display === kSheet ? `lpi=${lpi} dpi=${dpi} paper=${paper}${landscape ? " landscape" : ""}` : display };
    return JSON.stringify({ frame: this.state().frame, ...shown, ...(fit === "" ? {} : { fit }), view_shift_px: shift });
  }

  private async make(): Promise<Made> {
    const wanted = this.request();
    if (this.made && this.madeOf === wanted) return this.made;
    this.made = JSON.parse(await postText("print", wanted)) as Made;
    this.madeOf = wanted;
    return this.made;
  }

  private async picture(kind: "views" | "panel" | "file", made: Made): Promise<Blob> {
    const blob = await loadPicture(`print/${kind}/${made.id}`);
    if (blob.size > 0) return blob;
    this.made = null;
    throw new Refusal("Another page has made a print meanwhile. Try again.");
  }

  private async show(): Promise<void> {
    if (!this.isWanted) return this.leave();
    if (this.isCurrent()) return;
    const made = await this.make();
    const needsPanel = this.needsPanel(made);
    const views = await this.picture("views", made);
    const panel = needsPanel ? await this.picture("panel", made) : null;
    const { frames: _, ...facts } = made.field;
    await this.frames.showLive({ ...this.own, ...facts }, { views, depth: null, panel });
    this.frames.isLive = true;
    this.isSeen = true;
    this.hasPanel = panel !== null;
    this.shownId = made.id;
    this.take(facts);
    this.changed(true);
  }

  private leave(): void {
    this.isWanted = false;
    if (!this.isSeen) return;
    this.isSeen = false;
    this.frames.endLive();
    const { frames: _, ...facts } = this.own;
    this.take(facts);
    this.changed(true);
  }
}
