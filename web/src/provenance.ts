// The overlay that tints pixels by their origin (how they were made), and its legend.
import type { Field, Origin } from "./field";
import { linearFromCode } from "./gl";
import type { State } from "./state";

export interface Provenance {
  texture: WebGLTexture;
  /** The shares of all origins add up to 1. */
  shares: number[];
}

/** Colours that colour-blind users can distinguish (Okabe and Ito, Color Universal Design). */
const kColours = ["#d55e00", "#0072b2", "#009e73", "#f0e442", "#cc79a7", "#ffffff", "#56b4e9", "#4a3aa8"];
/** Opacity of the tint; higher if only missed pixels are tinted, because there are few. */
const kStrength = { provenance: 0.65, missed: 0.95, none: 0 };

const linearColour = (colour: string): number[] => [1, 3, 5].map((at) => linearFromCode(parseInt(colour.slice(at, at + 2), 16)));

const isShown = (origin: Origin | undefined, overlay: State["overlay"]): boolean => origin !== undefined && (overlay === "provenance" || origin.missed);

/** Linear red, green and blue, and the opacity, of each of 8 codes. */
export const tints = (field: Field, overlay: State["overlay"]): number[] =>
  kColours.flatMap((colour, code) => [...linearColour(colour), isShown(field.provenance?.[code], overlay) ? kStrength[overlay] : 0]);

/** Returns the share of pixels with each code. Reads a few rows at a time to limit the memory. */
export function sharesOf(picture: ImageBitmap, origins: number): number[] {
  const rows = Math.max(1, Math.min(picture.height, Math.floor((1 << 20) / picture.width)));
  const context = new OffscreenCanvas(picture.width, rows).getContext("2d", { willReadFrequently: true }) as OffscreenCanvasRenderingContext2D;
  const counts = new Array<number>(origins).fill(0);
  for (let top = 0; top < picture.height; top += rows) {
    const height = Math.min(rows, picture.height - top);
    context.drawImage(picture, 0, top, picture.width, height, 0, 0, picture.width, height);
    const codes = context.getImageData(0, 0, picture.width, height).data;
    for (let i = 0; i < codes.length; i += 4) counts[codes[i]]++;
  }
  return counts.map((count) => count / (picture.width * picture.height));
}

/** Shares near 0 % or 100 % are not rounded to 0 or 100. */
function percent(share: number): string {
  if (share > 0 && share < 0.001) return "< 0.1\u2009%";
  const shown = share < 1 ? Math.min(share, 0.999) : share;
  return `${(100 * shown).toFixed(1)}\u2009%`;
}

function entry(colour: string, name: string, share: number): HTMLElement {
  const item = document.createElement("li");
  const swatch = document.createElement("i");
  swatch.style.background = colour;
  const value = document.createElement("span");
  value.textContent = percent(share);
  item.append(swatch, `${name} `, value);
  return item;
}

export function showLegend(list: HTMLElement, field: Field, overlay: State["overlay"], shares: number[] | null): void {
  const origins = field.provenance ?? [];
  list.hidden = overlay === "none" || shares === null;
  if (list.hidden || shares === null) return;
  const entries = origins.flatMap((origin, code) => (shares[code] > 0 && isShown(origin, overlay) ? [entry(kColours[code], origin.name, shares[code])] : []));
  if (entries.length === 0) entries.push(entry("transparent", "missed", 0));
  list.replaceChildren(...entries);
}
