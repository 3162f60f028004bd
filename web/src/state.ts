// The choices of the user, stored in the page's address. A script or an embedding page can set them.
import type { Field } from "./field";

export interface State {
  frame: number;
  eye: [number, number, number];
  aperture: number;
  focus: number;
  show: "eye" | "panel" | "display";
  stereo: "off" | "anaglyph" | "side-by-side" | "top-bottom";
  separation: number;
  between: "depth" | "blend";
  lenses: boolean;
  crosstalk: number;
  exposure: number;
  line: number;
  /** Magnification relative to the fitted picture, and the offset of its centre as a share of the magnified size. */
  magnify: number;
  pan: [number, number];
  /** Tints all pixels by their origin, or only the missed pixels. */
  overlay: "none" | "provenance" | "missed";
  compare: "first" | "second" | "wipe" | "side-by-side" | "difference";
  wipe: number;
  scale: number;
  speed: number;
  loop: boolean;
  /** In a scene that is set up: what dragging moves, and whether the depth budget is drawn. */
  drag: "eye" | "turn" | "plane";
  budget: boolean;
  theme: "system" | "dark" | "light";
}

const kWords: { [Key in keyof State]?: readonly string[] } = {
  show: ["eye", "panel", "display"],
  stereo: ["off", "anaglyph", "side-by-side", "top-bottom"],
  between: ["depth", "blend"],
  overlay: ["none", "provenance", "missed"],
  compare: ["first", "second", "wipe", "side-by-side", "difference"],
  drag: ["eye", "turn", "plane"],
  theme: ["system", "dark", "light"],
};

const kRanges: { [Key in keyof State]?: readonly [number, number] } = {
  aperture: [0, 1],
  separation: [0, 200],
  exposure: [-8, 8],
  crosstalk: [0, 8],
  line: [-1, 1],
  magnify: [0.1, 64],
  wipe: [0, 1],
  scale: [1, 255],
  speed: [0.05, 16],
};

export function defaultState(fields: Field[], plays: boolean, isSetUp = false): State {
  const field = fields[0];
  return {
    frame: 0,
    eye: [...field.eye_mm],
    aperture: 0,
    focus: 0,
    show: plays ? "display" : "eye",
    stereo: "off",
    separation: defaultSeparation(field),
    between: field.depth ? "depth" : "blend",
    lenses: false,
    crosstalk: 0,
    exposure: 0,
    line: -1,
    magnify: 1,
    pan: [0, 0],
    overlay: "none",
    compare: fields.length > 1 ? "wipe" : "first",
    wipe: 0.5,
    scale: 32,
    speed: 1,
    loop: true,
    drag: isSetUp ? "turn" : "eye",
    budget: false,
    theme: "system",
  };
}

/** Returns the distance between the eyes in mm: 63, or an eighth of the viewing zone's width if that is less. */
function defaultSeparation(field: Field): number {
  const zone = Math.abs(field.across.step) * field.across.views * field.eye_mm[2];
  return Math.min(63, Math.round(zone * 1.25) / 10);
}

function readValue(key: keyof State, value: unknown, fields: Field[], current: unknown): unknown {
  if (key === "eye") {
    const eye = typeof value === "string" ? value.split(",").map(Number) : value;
    const fits = Array.isArray(eye) && eye.length === 3 && eye.every((x) => Number.isFinite(x) && Math.abs(x) < 1e6);
    return fits && eye[2] >= 1 ? eye : undefined;
  }
  if (key === "pan") {
    const pan = typeof value === "string" ? value.split(",").map(Number) : value;
    return Array.isArray(pan) && pan.length === 2 && pan.every((share) => Number.isFinite(share) && Math.abs(share) <= 64) ? pan : undefined;
  }
  if (typeof current === "boolean") return value === true || value === "1" ? true : value === false || value === "0" ? false : undefined;
  if (typeof current === "string") return kWords[key]?.includes(String(value)) ? value : undefined;
  const number = value === "" || value === null ? NaN : Number(value);
  if (!Number.isFinite(number)) return undefined;
  if (key === "frame") return Math.min(Math.max(Math.round(number), 0), fields[0].frames.length - 1);
  if (key === "focus") return number * fields[0].vergence_per_mm < 0.95 ? number : undefined;
  const range = kRanges[key];
  return range ? Math.min(Math.max(number, range[0]), range[1]) : number;
}

export class Store {
  readonly state: State;
  private readonly defaults: State;
  private readonly listeners: (() => void)[] = [];
  private addressTimer = 0;

  /** plays: whether there is a calibrated panel. beginsPlaying: whether the page first shows the picture of this panel.
   *  isSetUp: whether the page shows a scene that is set up. */
  constructor(
    readonly fields: Field[],
    public plays = false,
    beginsPlaying = plays,
    isSetUp = false,
  ) {
    this.defaults = defaultState(fields, beginsPlaying, isSetUp);
    this.state = { ...this.defaults };
    this.readAddress();
  }

  listen(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** Notifies the listeners although the state has not changed. */
  touch(): void {
    this.listeners.forEach((listener) => listener());
  }

  /** Applies changes; ignores unknown names and invalid values. */
  set(changes: Record<string, unknown>): void {
    let changed = false;
    for (const [name, value] of Object.entries(changes)) {
      if (!(name in this.state) || (name === "show" && value === "display" && !this.plays)) continue;
      const key = name as keyof State;
      const read = readValue(key, value, this.fields, this.state[key]);
      if (read === undefined || JSON.stringify(read) === JSON.stringify(this.state[key])) continue;
      (this.state as unknown as Record<string, unknown>)[key] = read;
      changed = true;
    }
    if (!changed) return;
    this.touch();
    window.clearTimeout(this.addressTimer);
    this.addressTimer = window.setTimeout(() => this.writeAddress(), 250);
  }

  reset(): void {
    this.set({ ...this.defaults, eye: this.fields[0].eye_mm, frame: this.state.frame, theme: this.state.theme });
  }

  readAddress(): void {
    this.set(Object.fromEntries(new URLSearchParams(location.hash.slice(1))));
  }

  /** The part of the address after #, with all values that differ from the defaults. */
  address(): string {
    const parameters = new URLSearchParams();
    for (const key of Object.keys(this.state) as (keyof State)[]) {
      const value = this.state[key];
      if (JSON.stringify(value) === JSON.stringify(this.defaults[key])) continue;
      const text = (number: number) => String(Math.round(number * 1e4) / 1e4);
      parameters.set(key, Array.isArray(value) ? value.map(text).join(",") : typeof value === "boolean" ? (value ? "1" : "0") : typeof value === "number" ? text(value) : value);
    }
    return `#${parameters.toString().replace(/%2C/g, ",")}`;
  }

  private writeAddress(): void {
    try {
      history.replaceState(null, "", this.address());
    } catch {
      // Some browsers do not allow pages opened from a disk to change the address.
    }
  }
}
