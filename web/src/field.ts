// The description of a light field (web/README.md lists the keys), checked before use.

export interface Axis {
  views: number;
  first: number;
  step: number;
  by: "slope" | "angle";
  beyond: "stays" | "repeats" | "next lens";
}

export interface Frame {
  label: string;
  kind?: string;
  psnr_db?: number;
  pending?: boolean;
}

/** A way in which pixels of a frame were made, such as tracing or interpolation. Provenance codes are indices in the list of
 *  origins. */
export interface Origin {
  name: string;
  missed: boolean;
}

/** Defines which view each sub-pixel shows; see src/view/page_display.hpp. */
export interface SlantedPanel {
  periods: number;
  tilt: number;
  center: number;
  inverted: boolean;
  /** Positions of sub-pixels in pixels: [row from the bottom, modulo 4][column modulo 2][red, green, blue][x, y]. */
  sub_pixels: number[][][][];
}

export interface Field {
  title: string;
  view_size: [number, number];
  tiles: [number, number];
  across: Axis;
  up: Axis;
  vergence_per_mm: number;
  window_mm: { centre: [number, number]; size: [number, number] };
  lens_samples: [boolean, boolean];
  panel: { is: "integral" | "quilt" | "own"; size: [number, number]; panel?: SlantedPanel };
  eye_mm: [number, number, number];
  depth_budget_mm: number | null;
  depth: boolean;
  /** null: unknown */
  provenance: Origin[] | null;
  disparity_scale_mm: number;
  /** Size of views in the small preview; null: there is no preview. */
  preview: [number, number] | null;
  frames_per_second: number;
  assumption: string;
  frames: Frame[];
}

export class Refusal extends Error {}

function require(holds: boolean, what: string): asserts holds {
  if (!holds) throw new Refusal(`The description of the light field is damaged: ${what}.`);
}

const isNumber = (value: unknown): value is number => typeof value === "number" && Number.isFinite(value);
const areNumbers = (value: unknown, count: number): boolean =>
  Array.isArray(value) && value.length === count && value.every(isNumber);
const areSizes = (value: unknown): boolean =>
  areNumbers(value, 2) && (value as number[]).every((side) => side >= 1 && side <= 65536 && Number.isInteger(side));

const areOrigins = (value: unknown): boolean =>
  Array.isArray(value) && value.length <= 8 && value.every((one) => typeof one?.name === "string" && typeof one.missed === "boolean");

function checkAxis(axis: Axis, name: string): void {
  require(typeof axis === "object" && axis !== null, `it has no "${name}"`);
  require(Number.isInteger(axis.views) && axis.views >= 1 && axis.views <= 65536, `"${name}" has no number of views`);
  require(isNumber(axis.first) && isNumber(axis.step), `"${name}" has no positions of views`);
}

function checkField(field: Field): void {
  require(typeof field === "object" && field !== null, "it is not an object");
  require(areSizes(field.view_size) && areSizes(field.tiles), "it has no size of views");
  checkAxis(field.across, "across");
  checkAxis(field.up, "up");
  require(field.tiles[0] * field.tiles[1] >= field.across.views * field.up.views, "it has fewer tiles than views");
  require(isNumber(field.vergence_per_mm) && isNumber(field.disparity_scale_mm), "it has no viewing distance");
  require(areNumbers(field.window_mm?.centre, 2) && areNumbers(field.window_mm?.size, 2), "it has no window");
  require(areNumbers(field.eye_mm, 3) && field.eye_mm[2] > 0, "it has no eye");
  require(Array.isArray(field.lens_samples) && areSizes(field.panel?.size), "it has no panel");
  field.provenance ??= null;
  require(field.provenance === null || areOrigins(field.provenance), "its origins of pixels are damaged");
  field.preview ??= null;
  require(field.preview === null || areSizes(field.preview), "its preview has no size");
  require(isNumber(field.frames_per_second) && field.frames_per_second > 0, "it has no frame rate");
  require(Array.isArray(field.frames) && field.frames.length > 0, "it has no frames");
  require(field.frames.every((frame) => typeof frame?.label === "string"), "a frame has no label");
}

export function readFields(json: unknown): Field[] {
  const fields = (json as { fields?: Field[] } | null)?.fields;
  require(Array.isArray(fields) && fields.length > 0, "it lists no light field");
  fields.forEach(checkField);
  return fields;
}

/** Converts a slope to the quantity in which the views of an axis are evenly spaced: the slope itself, or its angle. */
const placed = (axis: Axis, slope: number): number => (axis.by === "angle" ? Math.atan(slope) : slope);
const slopeOf = (axis: Axis, place: number): number => (axis.by === "angle" ? Math.tan(place) : place);

/** share: 0 is the left or lower end of the viewing zone, 1 the right or upper end. */
export const slopeInZone = (axis: Axis, share: number): number =>
  slopeOf(axis, axis.first + axis.step * (share * axis.views - 0.5));

/** Distance between the limits of the eye and the ends of the zone, as a share of the zone. Rounding in the address and on the
 *  GPU is smaller, so an eye at a limit is within the zone. */
const kInset = 1e-4;

/** Like slopeInZone, but limits the share to the zone. */
export const slopeWithinZone = (axis: Axis, share: number): number =>
  slopeInZone(axis, Math.min(Math.max(share, kInset), 1 - kInset));

export const shareOfZone = (axis: Axis, slope: number): number =>
  axis.step === 0 ? 0.5 : ((placed(axis, slope) - axis.first) / axis.step + 0.5) / axis.views;

/** Disparity of a depth: the shift in the display's plane, in mm, per unit of slope between two eyes. */
export const disparityOfDepth = (field: Field, depth: number): number => depth / (1 - depth * field.vergence_per_mm);
export const depthOfDisparity = (field: Field, disparity: number): number =>
  disparity / (1 + disparity * field.vergence_per_mm);

/** Returns whether the page can compute crosstalk. Neighbouring views must be neighbouring pixels of the panel, or views of
 *  a quilt. */
export const hasCrosstalk = (field: Field): boolean => field.panel.is !== "own" && field.across.views * field.up.views > 1;

/** Error function for x >= 0 with an error below 1.5e-7 (Abramowitz and Stegun, 7.1.26). */
function erf(x: number): number {
  const t = 1 / (1 + 0.3275911 * x);
  return 1 - t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429)))) * Math.exp(-x * x);
}

/** Share of light from each of the two neighbouring pixels, for an eye that sees the middle of a pixel. sigma: standard
 *  deviation of the lenses' blur in pixels. */
export const neighbourShare = (sigma: number): number =>
  sigma > 0 ? 0.5 * (erf(1.5 / (Math.SQRT2 * sigma)) - erf(0.5 / (Math.SQRT2 * sigma))) : 0;

/** Share of the display at which the eye sees views that are meant for another viewing zone (flips). */
export function shareOutOfZone(field: Field, eye: readonly number[]): number {
  const steps = 128;
  const outside = (axis: Axis, i: 0 | 1, step: number): boolean => {
    if (axis.views < 2 || axis.step === 0) return false;
    const point = field.window_mm.centre[i] + ((step + 0.5) / steps - 0.5) * field.window_mm.size[i];
    const slope = eye[i] / eye[2] - point * (1 / eye[2] - field.vergence_per_mm);
    const share = shareOfZone(axis, slope);
    return share < 0 || share > 1;
  };
  const all = [...Array(steps).keys()];
  const [across, up] = [0, 1].map((i) => all.filter((step) => outside(i === 0 ? field.across : field.up, i as 0 | 1, step)).length / steps);
  return 1 - (1 - across) * (1 - up);
}

/** Returns a picture size with square pixels and at least the resolution of a view. */
export function naturalSize(field: Field): [number, number] {
  const [width, height] = field.window_mm.size;
  const pixel = Math.min(width / field.view_size[0], height / field.view_size[1]);
  return [Math.max(1, Math.round(width / pixel)), Math.max(1, Math.round(height / pixel))];
}
