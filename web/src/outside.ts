// Lets other programs control the page: `window.lippmann` in scripts of the page's own origin, or messages from an embedding
// page.
//   parent to page: frame.contentWindow.postMessage({ lippmann: { eye: [20, 0, 500], frame: 12, focus: -10, aperture: 1 } }, "*")
//   page to parent: { lippmann: { state: {...} } } after every change; no pictures.
import { shareOutOfZone } from "./field";
import type { App } from "./app";
import type { LiveState } from "./live";
import type { Print } from "./print";
import type { RunState } from "./run";
import type { State } from "./state";

interface Handle {
  readonly state: State;
  readonly fields: App["fields"];
  set(changes: Record<string, unknown>): void;
  focusAt(x: number, y: number): void;
  picture(width: number, height: number, field?: number): Promise<Uint8ClampedArray>;
  /** Share of the display at which the eye sees views that are meant for another viewing zone. */
  readonly outOfZone: number;
  readonly isPlaying: boolean;
  pause(): void;
  panel(): Uint8ClampedArray;
  valueAt(x: number, y: number): number[];
  /** The scene that the user sets up, or null. Its settings have the names of flags of `lippmann render`. */
  readonly scene: LiveState | null;
  setUp(settings: Record<string, string | null>): void;
  /** The last print; null if there is none. */
  readonly print: Print["made"];
  /** The render that is running or was stopped; null if there is none. */
  readonly run: RunState | null;
}

declare global {
  interface Window {
    lippmann?: Handle;
  }
}

export function steerFromOutside(app: App): void {
  const { store } = app;
  window.lippmann = {
    get state() {
      return structuredClone(store.state);
    },
    fields: app.fields,
    set: (changes) => store.set(changes),
    focusAt: (x, y) => app.focusAt([x, y]),
    picture: (width, height, field = 0) => app.picture([width, height], field),
    get outOfZone() {
      return shareOutOfZone(app.fields[0], store.state.eye);
    },
    get isPlaying() {
      return app.timeline.playing;
    },
    pause: () => app.timeline.pause(),
    panel: () => app.panelCodes(),
    valueAt: (x, y) => app.renderer.valueAt(0, [x, y]),
    get scene() {
      return structuredClone(app.live?.state ?? null);
    },
    get run() {
      return structuredClone(app.run?.state ?? null);
    },
    setUp: (settings) => app.live?.set(settings),
    get print() {
      return structuredClone(app.print?.made ?? null);
    },
  };
  window.addEventListener("message", (event) => {
    const changes = (event.data as { lippmann?: Record<string, unknown> } | null)?.lippmann;
    if (event.source === window.parent && typeof changes === "object" && changes !== null) store.set(changes);
  });
  if (window.parent !== window) store.listen(() => window.parent.postMessage({ lippmann: { state: structuredClone(store.state) } }, "*"));
}
