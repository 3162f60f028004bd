// Lays out an integral image with few lenses: the eye's view, and its panel beside or below it, pixel for pixel.
import type { Field } from "./field";

type Two = [number, number];

export interface Rectangle {
  left: number;
  top: number;
  width: number;
  height: number;
}

export interface Placed {
  /** Size and centre of the picture without magnification, in pixels of the canvas. */
  width: number;
  height: number;
  centre: Two;
  /** The part of the canvas that the picture may cover when magnified. */
  room: Rectangle;
}

export interface Pair {
  eye: Placed;
  panel: Placed;
  /** Pixels of the canvas per pixel of the panel. */
  scale: number;
}

/** Width of a lens in pixels of the canvas. An eye's view of wider lenses looks stretched by mistake, so the panel is shown beside it. */
const kWideLens = 4;
/** Space between the two pictures, and space below a picture for its caption, in CSS pixels. */
const kGap = 16;
const kCaption = 24;

const hasWideLenses = (field: Field, scale: number): boolean =>
  field.lens_samples.some((isLens, i) => isLens && scale * field.panel.size[i] > kWideLens * field.view_size[i]);

/** Returns the scale in pixels of the canvas per pixel of the panel. It is `scale`, rounded down to an integer for panels and wide lenses,
 *  so that all pixels have the same size. */
export const trueScale = (field: Field, scale: number, isPanel: boolean): number =>
  scale >= 1 && (isPanel || (field.panel.is === "integral" && hasWideLenses(field, scale))) ? Math.floor(scale) : scale;

/** Returns the layout on a canvas of this size. ratio: pixels of the canvas per CSS pixel. Returns null if the panel has many lenses, or if
 *  less than half of it would be visible. */
export function pairOf(field: Field, [width, height]: Two, ratio: number): Pair | null {
  const [w, h] = field.panel.size;
  const [gap, caption] = [kGap, kCaption].map((length) => Math.round(length * ratio));
  if (field.panel.is !== "integral" || !hasWideLenses(field, Math.min(width / w, height / h))) return null;
  const beside = Math.floor(Math.min((width - gap) / (2 * w), (height - caption) / h));
  const below = Math.floor(Math.min(width / w, (height / 2 - caption) / h));
  const along = (beside === below ? width > height : beside > below) ? 0 : 1;
  const between = along === 0 ? gap : caption;
  const room: Two = [width, height - caption];
  const scale = Math.max(1, beside, below), fitted = Math.min(scale, room[0] / w, room[1] / h);
  const eye: Two = [fitted * w, fitted * h], panel: Two = [scale * w, scale * h];
  const visible = panel.map((side, i) => Math.min(side, room[i] - (i === along ? eye[i] + between : 0)));
  if (visible.some((side, i) => side < panel[i] / 2)) return null;
  const first = Math.round((room[along] - eye[along] - between - visible[along]) / 2);
  const end = Math.round(first + eye[along]), second = end + between;
  const place = (size: Two, middle: number, from: number, to: number): Placed => {
    const [x, y] = size.map((side, i) => Math.round((room[i] - side) / 2) + side / 2);
    const centre: Two = [x, y], low: Two = [0, 0], high: Two = [...room];
    [centre[along], low[along], high[along]] = [middle, from, to];
    return { width: size[0], height: size[1], centre, room: { left: low[0], top: low[1], width: high[0] - low[0], height: high[1] - low[1] } };
  };
  return { eye: place(eye, first + eye[along] / 2, 0, end), panel: place(panel, second + visible[along] / 2, second, room[along]), scale };
}
