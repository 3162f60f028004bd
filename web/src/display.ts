// The calibrated panel on which light fields are played. The server reads calibration files, and this file checks the numbers
// that the server sends (web/README.md lists the keys).
import { postText } from "./data";
import { Refusal, type SlantedPanel } from "./field";

export interface PanelDisplay {
  name: string;
  pixels: [number, number];
  panel: SlantedPanel;
  filter: "nearest" | "linear" | "gaussian";
  sigma_views: number;
}

function require(holds: boolean, what: string): asserts holds {
  if (!holds) throw new Refusal(`The description of the panel is damaged: ${what}.`);
}

const isFinite = (value: unknown): boolean => typeof value === "number" && Number.isFinite(value);
const isListOf = (value: unknown, count: number, holds: (one: unknown) => boolean): boolean =>
  Array.isArray(value) && value.length === count && value.every(holds);
const isOffset = (value: unknown): boolean => isListOf(value, 2, isFinite);
const isPixel = (value: unknown): boolean => isListOf(value, 3, isOffset);
const isRow = (value: unknown): boolean => isListOf(value, 2, isPixel);

export function readDisplay(json: unknown): PanelDisplay {
  const display = json as PanelDisplay;
  require(typeof display === "object" && display !== null, "it is not an object");
  require(isListOf(display.pixels, 2, (side) => Number.isInteger(side) && (side as number) >= 1 && (side as number) <= 65536), "it has no size");
  const panel = display.panel;
  require(isFinite(panel?.periods) && isFinite(panel.tilt) && isFinite(panel.center), "the positions of its lenses are missing");
  require(isListOf(panel.sub_pixels, 4, isRow), "the positions of its sub-pixels are missing");
  require(["nearest", "linear", "gaussian"].includes(display.filter) && isFinite(display.sigma_views), "its filter is missing");
  return display;
}

export const samePanel = (a: SlantedPanel | undefined, b: SlantedPanel): boolean => JSON.stringify(a) === JSON.stringify(b);

/** Reads the text of a visual.json. Throws a Refusal that describes the error. */
export const readCalibration = async (text: string): Promise<PanelDisplay> => readDisplay(JSON.parse(await postText("calibration", text)));
