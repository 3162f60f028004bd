// Lays out integral images with few lenses: the eye's view, and its panel beside or below it, pixel for pixel. Two compared integral images
// share this layout.
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

/** Lenses above this width in CSS pixels are wide. An eye's view through wide lenses looks stretched, so the panel is
 *  shown beside it. Decision 0088 derives the value. */
const kWideLens = 4;
/** In CSS pixels: the space between the two pictures, and the space below a picture for its caption. */
const kGap = 16;
const kCaption = 24;

/** scale: pixels of the canvas per pixel of the panel. ratio: pixels of the canvas per CSS pixel. */
const hasWideLenses = (field: Field, scale: number, ratio: number): boolean =>
  field.lens_samples.some((isLens, i) => isLens && scale * field.panel.size[i] > kWideLens * ratio * field.view_size[i]);

/** Returns the scale in pixels of the canvas per pixel of the panel. It is `scale`, rounded down to an integer for panels and wide lenses,
 *  so that all pixels have the same size. */
export const trueScale = (field: Field, scale: number, ratio: number, isPanel: boolean): number =>
  scale >= 1 && (isPanel || (field.panel.is === "integral" && hasWideLenses(field, scale, ratio))) ? Math.floor(scale) : scale;

/** Returns the layout on a canvas of this size. fields: the light fields shown. isApart: they are shown side by side.
 *  ratio: pixels of the canvas per CSS pixel. Returns null if the panels have many lenses or different sizes, if less
 *  than half of the panel would be visible, or if the eye's view would have less than half of its usual scale. */
export function pairOf(fields: Field[], isApart: boolean, [width, height]: Two, ratio: number): Pair | null {
  const [w, h] = [fields[0].panel.size[0] * (isApart ? fields.length : 1), fields[0].panel.size[1]];
  const [gap, caption] = [kGap, kCaption].map((length) => Math.round(length * ratio));
  const areAlike = fields.every(({ panel }) => panel.is === "integral" && panel.size.every((side, i) => side === fields[0].panel.size[i]));
  if (!areAlike || !fields.some((field) => hasWideLenses(field, Math.min(width / w, height / h), ratio))) return null;
  const beside = Math.floor(Math.min((width - gap) / (2 * w), (height - caption) / h));
  const below = Math.floor(Math.min(width / w, (height / 2 - caption) / h));
  const room: Two = [width, height - caption];
  const [best] = [beside, below]
    .map((most, along) => {
      const scale = Math.max(1, most), size = [w, h][along], between = along === 0 ? gap : caption;
      const fitted = Math.min(scale, room[0] / w, room[1] / h, (room[along] - between) / size - scale / 2);
      return { along, between, scale, fitted };
    })
    .sort((a, b) => b.scale - a.scale || b.fitted - a.fitted || (width > height ? a.along - b.along : b.along - a.along));
  const { along, between, scale, fitted } = best;
  if (fitted < scale / 2) return null;
  const eye: Two = [fitted * w, fitted * h], panel: Two = [scale * w, scale * h];
  const visible = panel.map((side, i) => Math.min(side, room[i] - (i === along ? eye[i] + between : 0)));
  if (visible.some((side, i) => side < panel[i] / 2 - 1)) return null;
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
