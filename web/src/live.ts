// A scene that is set up in the page while the server renders it. Settings are texts with the names of flags of
// `lippmann render` (web/README.md lists the keys of the state).
import { loadPicture, postText, readState } from "./data";
import type { PanelDisplay } from "./display";
import { Refusal, type Field } from "./field";
import type { Frames } from "./frames";
import { pause } from "./pause";

export interface Rendered {
  state: "running" | "finished" | "stopped" | "failed";
  frames: number;
  done: number;
  share: number;
  seconds_left: number | null;
  folder: string;
  error: string;
}

export interface LiveState {
  serial: number;
  version: number;
  settings: Record<string, string>;
  changed: string[];
  frame: number;
  error: string;
  pass: "" | "coarse" | "draft" | "final";
  share: number;
  plane: { distance: number; nearest: number; farthest: number } | null;
  depth: { budget_mm: number | null; summary: string };
  view: string;
  light: string;
  display: PanelDisplay | null;
  picture: { id: number; version: number; frame: number; pass: string; view_size: [number, number]; depth: boolean; panel: boolean; field: Omit<Field, "frames"> } | null;
  saved: string;
  render: Rendered | null;
}

export interface Choices {
  choices: Record<string, string[]>;
  display: PanelDisplay | null;
  plays: boolean;
}

interface Changes {
  settings?: Record<string, string | null>;
  frame?: number;
  plane_mm?: number;
}

export class Live {
  state: LiveState | null = null;
  /** Changed settings that the server has not confirmed yet. Controls show them at once. */
  private wanted: Record<string, string> = {};
  private waiting: Changes | null = null;
  private confirmed = 0;
  private sending = false;
  private shownId = 0;
  private shownVersion = 0;
  private states = 0;

  constructor(
    readonly about: Choices,
    private readonly field: Field,
    private readonly frames: Frames,
    private readonly changed: (picture: boolean) => void,
    private readonly notify: (about: string, text: string) => void,
  ) {
    frames.isLive = true;
    void this.listen();
  }

  value(name: string): string {
    return this.wanted[name] ?? this.state?.settings[name] ?? "";
  }

  pendingNumber(name: string): number | undefined {
    return name in this.wanted ? Number(this.wanted[name]) : undefined;
  }

  number(name: string, otherwise: number): number {
    const text = this.value(name);
    const number = Number(text);
    return text === "" || !Number.isFinite(number) ? otherwise : number;
  }

  /** Frame number of the shown picture; -1 if there is no picture yet. */
  get shownFrame(): number {
    return this.shownId > 0 ? (this.state?.picture?.frame ?? -1) : -1;
  }

  /** Whether the shown picture is the final one for the current settings. */
  get isAtRest(): boolean {
    const { state } = this;
    const picture = state?.picture;
    return !!state && !!picture && !this.isOutdated && picture.id === this.shownId && picture.version === state.version && picture.pass === "final";
  }

  get isOutdated(): boolean {
    return this.shownId > 0 && (this.sending || this.waiting !== null || this.shownVersion < Math.max(this.state?.version ?? 0, this.confirmed));
  }

  get isNew(): boolean {
    return this.states <= 1;
  }

  /** The frame that another page chose; null while this page requests changes itself. */
  get othersFrame(): number | null {
    const { state } = this;
    return !state || this.sending || this.waiting || state.version < this.confirmed ? null : state.frame;
  }

  set(settings: Record<string, string | null>): void {
    for (const [name, value] of Object.entries(settings)) if (value !== null) this.wanted[name] = value;
    this.notify("asked", "");
    this.waiting = { ...this.waiting, settings: { ...this.waiting?.settings, ...settings } };
    void this.send();
    this.changed(false);
  }

  setFrame(frame: number): void {
    if (!this.state || (frame === this.state.frame && !this.waiting)) return;
    this.waiting = { ...this.waiting, frame };
    void this.send();
  }

  setPlane(plane_mm: number): void {
    this.waiting = { ...this.waiting, plane_mm };
    void this.send();
  }

  /** Changes that arrive during a request are sent together afterwards. */
  private async send(): Promise<void> {
    if (this.sending || !this.waiting) return;
    this.sending = true;
    const changes = this.waiting;
    this.waiting = null;
    try {
      this.confirmed = (await this.post("settings", changes) as { version: number }).version;
      this.notify("setting", "");
    } catch (error) {
      this.wanted = {};
      this.notify("setting", error instanceof Error ? error.message : String(error));
    }
    this.sending = false;
    void this.send();
    this.changed(false);
  }

  private async post(path: string, body: unknown): Promise<unknown> {
    return JSON.parse(await postText(`live/${path}`, JSON.stringify(body)));
  }

  private async ask(path: string, body: unknown): Promise<void> {
    try {
      await this.post(path, body);
      this.notify("asked", "");
    } catch (error) {
      this.notify("asked", error instanceof Error ? error.message : String(error));
    }
  }

  async save(): Promise<void> {
    await this.ask("save", {});
  }

  render(frames: "all" | "this"): void {
    void this.ask("render", { frames });
  }

  cancel(): void {
    void this.ask("cancel", {});
  }

  private async listen(): Promise<void> {
    for (;;) {
      const asked = performance.now();
      try {
        const state = (await readState(`live/state/${this.state?.serial ?? 0}`)) as LiveState;
        const before = this.state;
        const shown = this.shownId;
        const isNews = state.serial !== before?.serial || state.share !== before.share || JSON.stringify(state.render) !== JSON.stringify(before.render);
        this.take(state);
        if (isNews) this.changed(false);
        if (state.picture && state.picture.id !== this.shownId) await this.load(state.picture);
        if (shown !== this.shownId) this.changed(true);
        this.notify("server", "");
        if (!isNews && performance.now() - asked < 100) await pause(250);
      } catch (error) {
        this.notify("server", error instanceof Refusal ? error.message : String(error));
        await pause(2000);
      }
    }
  }

  private take(state: LiveState): void {
    this.state = state;
    this.states++;
    if (!this.sending && !this.waiting && state.version >= this.confirmed) this.wanted = {};
    this.notify("error", state.error);
  }

  private async load(picture: NonNullable<LiveState["picture"]>): Promise<void> {
    const { id, version, field } = picture;
    const [views, depth, panel] = await Promise.all([
      loadPicture(`live/views/${id}`),
      picture.depth ? loadPicture(`live/depth/${id}`) : null,
      picture.panel && field.panel.is === "own" ? loadPicture(`live/panel/${id}`) : null,
    ]);
    // The server sends an empty file if a newer picture has replaced this one. The newer picture is requested next.
    if ([views, depth, panel].some((one) => one?.size === 0)) return;
    await this.frames.showLive({ ...this.field, ...field }, { views, depth, panel });
    Object.assign(this.field, field);
    this.shownId = id;
    this.shownVersion = version;
  }
}
