// A render whose folder is shown while it runs, or after it was stopped. All its frames are on the time line from the
// start, `pending` until they are finished.
import { postText, readState } from "./data";
import type { Field } from "./field";
import { pause } from "./pause";

export interface RunState {
  state: "starting" | "running" | "stopping" | "elsewhere" | "stopped" | "finished";
  frames: number;
  done: number;
  seconds_left: number | null;
  host: string;
  folder: string;
  error: string;
  finished: { index: number; kind?: string; psnr_db?: number }[];
}

const kBetweenAsksMs = 500;

export const minutes = (seconds: number): string => (seconds < 90 ? `${Math.ceil(seconds)} s` : `${Math.ceil(seconds / 60)} min`);

export class Run {
  private known = 0;
  private listening = false;
  private asking: Promise<void> | null = null;

  constructor(
    public state: RunState,
    private readonly field: Field,
    private readonly changed: (finished: RunState["finished"]) => void,
    private readonly notify: (about: string, text: string) => void,
  ) {
    for (const frame of field.frames) frame.pending = true;
    this.take(state.finished);
    void this.listen();
  }

  get isUnderWay(): boolean {
    return this.state.state === "running" || this.state.state === "starting";
  }

  get canResume(): boolean {
    return this.state.state === "stopped";
  }

  describe(): string {
    const { state, done, frames, seconds_left: left, host } = this.state;
    const count = `${done} of ${frames} frame${frames === 1 ? "" : "s"}`;
    if (state === "running") return `Rendering: ${count}${left === null ? "" : `, about ${minutes(left)} left`}`;
    if (state === "starting") return `Setting up: ${count}`;
    if (state === "stopping") return `Stopping: ${count}`;
    if (state === "elsewhere") return `${count}. ${host} renders the others, or was stopped.`;
    return state === "stopped" ? `Stopped: ${count}` : `Finished: ${frames} frame${frames === 1 ? "" : "s"}`;
  }

  async toggle(): Promise<void> {
    const order = this.isUnderWay ? "stop" : this.canResume ? "resume" : "";
    if (!order) return;
    try {
      await postText(`run/${order}`, "{}");
      this.notify("asked", "");
      await this.ask();
      if (order === "resume") void this.listen();
    } catch (error) {
      this.notify("asked", error instanceof Error ? error.message : String(error));
    }
  }

  private take(finished: RunState["finished"]): void {
    this.known += finished.length;
    for (const { index, kind, psnr_db } of finished) Object.assign(this.field.frames[index], { pending: false, kind, psnr_db });
  }

  /** Only one request is sent at a time, so that each change is reported once. */
  private ask(): Promise<void> {
    this.asking ??= this.answer().finally(() => (this.asking = null));
    return this.asking;
  }

  private async answer(): Promise<void> {
    const before = JSON.stringify({ ...this.state, finished: [] });
    const state = (await readState(`run/state/${this.known}`)) as RunState;
    this.state = state;
    this.take(state.finished);
    if (state.finished.length > 0 || JSON.stringify({ ...state, finished: [] }) !== before) this.changed(state.finished);
  }

  private async listen(): Promise<void> {
    if (this.listening) return;
    this.listening = true;
    while (this.state.state !== "finished") {
      await pause(kBetweenAsksMs);
      try {
        await this.ask();
        this.notify("server", "");
      } catch (error) {
        this.notify("server", error instanceof Error ? error.message : String(error));
        await pause(2000);
      }
    }
    this.listening = false;
  }
}
