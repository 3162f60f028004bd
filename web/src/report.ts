// Draws the charts of `lippmann report`: lines or stacked bars over the frame numbers.
//
// Each `figure.chart` of the page contains its data as JSON (src/report/chart.hpp). uPlot draws on a canvas of a fixed size. Therefore,
// the charts are redrawn when the page's width or colours change, and before printing.
/// <reference types="vite/client" />
import uPlot from "uplot";
import uplotStyle from "uplot/dist/uPlot.min.css?inline";

type Values = (number | null)[];

interface Series {
  name: string;
  color: number;
  values: Values;
}

interface Chart {
  title: string;
  unit: string;
  frames: number[];
  series: Series[];
  levels: { name: string; value: number }[];
  stacked: boolean;
  from_zero: boolean;
  top: number | null;
}

const kHeight = 230;
const kFont = '12px system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif';
/** 1, 2 and 5 times powers of 10 */
const kSteps = [...Array(19).keys()].flatMap((power) => [1, 2, 5].map((factor) => Number(`${factor}e${power - 9}`)));

const color = (name: string) => () => getComputedStyle(document.documentElement).getPropertyValue(name);

const numberText = (value: number | null | undefined) => (value == null ? "–" : String(Number(value.toPrecision(4))));

/** Tops of stacked bars: for each series, the sum of its values and those of the series before it. */
function stackedTops(series: Series[]): Values[] {
  const sums: number[] = [];
  return series.map(({ values }) => values.map((value, i) => (sums[i] = (sums[i] ?? 0) + Math.max(value ?? 0, 0))));
}

/** Values without neighbours are drawn as points, because a line would not show them. */
function lonePoints(u: uPlot, index: number): number[] {
  const values = u.data[index];
  return [...values.keys()].filter((i) => values[i] != null && values[i - 1] == null && values[i + 1] == null);
}

function seriesOptions(chart: Chart, { name, color: index, values }: Series): uPlot.Series {
  const stroke = color(`--c${index}`);
  const common: uPlot.Series = { label: name, value: (_, __, ___, at) => (at === null ? "" : numberText(values[at])) };
  if (!chart.stacked) return { ...common, stroke, width: 2, points: { size: 5, fill: stroke, filter: lonePoints } };
  return { ...common, fill: stroke, width: 0, paths: uPlot.paths.bars!({ size: [chart.frames.length > 120 ? 1 : 0.8, Infinity, 1] }), points: { show: false } };
}

/** Extends the range of frames by half a frame on both sides, so that whole bars are visible. A zoomed range stays unchanged. */
function frameRange({ frames }: Chart): uPlot.Range.Function {
  return (_, low, high) => (low === frames[0] && high === frames[frames.length - 1] ? [low - 0.5, high + 0.5] : [low, high]);
}

function valueRange(chart: Chart): uPlot.Range.Function {
  return (_, low, high) => {
    if (chart.from_zero) return [Math.min(low, 0), chart.top ?? (high > 0 ? 1.05 * high : 1)];
    const [padded, top] = uPlot.rangeNum(low, high, 0.1, false);
    return [padded ?? 0, top ?? 1];
  };
}

function chartOptions(chart: Chart, width: number, group: string): uPlot.Options {
  const axis = (): uPlot.Axis => ({ stroke: color("--quiet"), font: kFont, grid: { stroke: color("--line"), width: 1 }, ticks: { show: false } });
  const drawn = chart.series.map((series) => seriesOptions(chart, series));
  const levels = chart.levels.map(({ name }): uPlot.Series => ({ label: name, class: "level", stroke: color("--text"), width: 1.2, dash: [5, 4], points: { show: false }, value: () => "" }));
  return {
    width,
    height: kHeight,
    scales: { x: { time: false, range: frameRange(chart) }, y: { range: valueRange(chart) } },
    series: [{ label: "Frame", value: (_, frame) => frame ?? "" }, ...(chart.stacked ? drawn.reverse() : drawn), ...levels],
    axes: [{ ...axis(), incrs: kSteps.filter((step) => step >= 1), grid: { show: false }, size: 28, values: (_, frames) => frames.map(String) }, { ...axis(), incrs: kSteps, size: 56 }],
    cursor: { y: false, sync: { key: group }, points: { show: !chart.stacked } },
    legend: { markers: { width: 2, fill: (_, i) => markerColor(chart, i), stroke: (_, i) => (i > chart.series.length ? "var(--text)" : "transparent"), dash: "dashed" } },
  };
}

function markerColor(chart: Chart, index: number): string {
  const count = chart.series.length;
  if (index > count) return "transparent";
  return `var(--c${chart.series[chart.stacked ? count - index : index - 1].color})`;
}

/** Stacked bars are drawn from the highest sum down, so that lower bars cover higher bars. */
function dataOf(chart: Chart): uPlot.AlignedData {
  const values = chart.stacked ? stackedTops(chart.series).reverse() : chart.series.map((series) => series.values);
  return [chart.frames, ...values, ...chart.levels.map(({ value }) => chart.frames.map(() => value))];
}

function spoken(chart: Chart): string {
  const parts = chart.series.map(({ name, values }) => {
    const known = values.filter((value): value is number => value !== null);
    return known.length ? `${name}: ${numberText(Math.min(...known))} to ${numberText(Math.max(...known))}` : `${name}: not known`;
  });
  const levels = chart.levels.map(({ name }) => name);
  return [`${chart.title} (${chart.unit}) of ${chart.frames.length} frames`, ...parts, ...levels].join("; ");
}

/** Reserves room for the longest figure of each series, so that nothing moves when the figures of a frame appear. */
function reserveRoom(plot: HTMLElement, { series, stacked }: Chart): void {
  const [, ...figures] = plot.querySelectorAll<HTMLElement>(".u-value");
  for (const [i, { values }] of (stacked ? [...series].reverse() : series).entries())
    figures[i].style.minWidth = `${values.reduce<number>((most, value) => Math.max(most, numberText(value).length), 0)}ch`;
}

function draw(figure: HTMLElement): uPlot {
  const chart = JSON.parse(figure.querySelector("script")!.textContent!) as Chart;
  const plot = document.createElement("div");
  plot.setAttribute("role", "img");
  plot.setAttribute("aria-label", spoken(chart));
  figure.append(plot);
  const group = [...document.querySelectorAll("section")].findIndex((section) => section.contains(figure));
  const drawn = new uPlot(chartOptions(chart, figure.clientWidth, String(group)), dataOf(chart), plot);
  reserveRoom(plot, chart);
  return drawn;
}

const style = document.createElement("style");
style.textContent = uplotStyle;
document.head.prepend(style);

const charts = [...document.querySelectorAll<HTMLElement>("figure.chart")].map((figure) => ({ figure, plot: draw(figure) }));

function redraw(): void {
  for (const { figure, plot } of charts) {
    if (plot.width === figure.clientWidth) plot.redraw();
    else plot.setSize({ width: figure.clientWidth, height: kHeight });
  }
}

for (const query of ["(prefers-color-scheme: dark)", "print"]) matchMedia(query).addEventListener("change", redraw);
const resizes = new ResizeObserver(redraw);
for (const { figure } of charts) resizes.observe(figure);
