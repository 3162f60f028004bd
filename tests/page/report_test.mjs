// The page of results opens from disk, draws its charts, and fits windows of any width.
import assert from "node:assert/strict";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { closeAfterEach, inFolder, lippmann, open } from "./support.mjs";

closeAfterEach();

const small = ["--size", "128x128", "--lenses", "16", "--frames", "0-8", "-q"];
lippmann("render", "room", ...small, "--reuse", "interpolate", "--min-psnr", "30", "-o", "made");
lippmann("render", "room", ...small, "--reuse", "none", "-o", "traced");
lippmann("report", "made", "-q");
lippmann("report", "traced", "made", "-o", "both.html", "-q");

const openFile = (name, options) => open(pathToFileURL(inFolder(name)).href, { ready: false, ...options });
const report = (name) => JSON.parse(readFileSync(inFolder(`${name}/report.json`), "utf8"));

test("it opens from a disk without errors", async () => {
  const asked = [];
  const page = await openFile("made/report.html", { onRequest: (url) => asked.push(url) });
  assert.match(await page.title(), /^made/);
  const widths = await page.locator(".pictures img").evaluateAll((images) => images.map((image) => image.naturalWidth));
  assert.ok(widths.length > 1 && widths.every((width) => width > 0), `${widths}`);
  assert.ok(asked.every((url) => url.startsWith("file:") || url.startsWith("data:")), `${asked}`);
});

/** The page stores six digits of a figure and shows four. */
const shown = (figure) => Number(Number(figure.toPrecision(6)).toPrecision(4));
const chart = (page, title) => page.locator("figure.chart", { hasText: title }).first();
/** Returns the legend's text for each series at a frame. */
const legend = async (figure, frame) => {
  await figure.locator(".u-series", { hasText: new RegExp(`^Frame${frame}$`) }).waitFor();
  return figure.locator(".u-series").evaluateAll((rows) => Object.fromEntries(rows.map((row) => [row.querySelector(".u-label").textContent, row.querySelector(".u-value").textContent])));
};
/** Waits until the colours in `wanted` are the most frequent opaque colours of the canvas. */
const hasColors = async (page, figure, wanted) => page.waitForFunction(([canvas, wanted]) => {
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
  copy.drawImage(canvas, 0, 0);
  const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
  const pixels = new Map();
  for (let i = 0; i < data.length; i += 4) if (data[i + 3] === 255) pixels.set(data.slice(i, i + 3).join(), (pixels.get(data.slice(i, i + 3).join()) ?? 0) + 1);
  return [...pixels].sort((a, b) => b[1] - a[1]).slice(0, wanted.length).map(([color]) => color).sort().join() === wanted.sort().join();
}, [await figure.locator("canvas").elementHandle(), wanted]);

test("pointing at a frame shows its figures", async () => {
  const page = await openFile("made/report.html");
  const { frames } = report("made");
  const area = chart(page, "Where pixels come from").locator(".u-over");
  const { width } = await area.boundingBox();
  for (const [i, frame] of frames.entries()) {
    await area.hover({ position: { x: (width * (i + 0.5)) / frames.length, y: 20 } });
    const psnr = await legend(chart(page, "PSNR"), frame.frame);
    const bound = frame.psnr_at_least_db;
    assert.equal(psnr["at least (95 % confidence)"], bound === null ? "\u2013" : String(shown(bound)));
    assert.equal((await legend(chart(page, "CPU time per frame"), frame.frame))[frame.kind === "in-between" ? "with reuse" : "traced whole"], String(shown(frame.cpu_seconds)));
  }
});

test("charts follow the page's colours", async () => {
  const page = await openFile("made/report.html");
  const figure = chart(page, "Where pixels come from");
  const style = () => page.evaluate(() => [0, 2].map((i) => getComputedStyle(document.documentElement).getPropertyValue(`--c${i}`)));
  const seen = [];
  for (const media of [{ colorScheme: "light" }, { colorScheme: "dark" }, { media: "print" }]) {
    await page.emulateMedia(media);
    const wanted = (await style()).map((hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16)).join());
    await hasColors(page, figure, wanted);
    seen.push(String(wanted));
  }
  assert.equal(seen[2], seen[0]);
  assert.notEqual(seen[1], seen[0]);
  await page.emulateMedia({ colorScheme: null, media: null });
});

test("charts have descriptions", async () => {
  const page = await openFile("made/report.html");
  const { frames } = report("made");
  const seconds = frames.filter((frame) => frame.kind === "in-between").map((frame) => shown(frame.cpu_seconds));
  const spoken = await page.getByRole("img", { name: /^CPU time per frame/ }).getAttribute("aria-label");
  assert.ok(spoken.startsWith(`CPU time per frame (s) of ${frames.length} frames; traced whole: `), spoken);
  assert.ok(spoken.endsWith(`; with reuse: ${Math.min(...seconds)} to ${Math.max(...seconds)}`), spoken);
});

test("a thousand frames are drawn", async () => {
  const long = report("made");
  long.frames = [...Array(1000).keys()].map((number) => ({ ...long.frames[number % long.frames.length], frame: number }));
  mkdirSync(inFolder("long"));
  writeFileSync(inFolder("long/report.json"), JSON.stringify(long));
  lippmann("report", "long", "-q");
  const page = await openFile("long/report.html");
  assert.equal(await page.locator("figure.chart canvas").count(), await page.locator("figure.chart").count());
  assert.match(await page.getByRole("img", { name: /^Rays per pixel/ }).getAttribute("aria-label"), /of 1000 frames/);
});

test("narrow windows work, and the table scrolls", async () => {
  for (const width of [340, 820, 1400]) {
    const page = await openFile("both.html", { width, height: 700 });
    await page.locator("details").evaluateAll((all) => all.forEach((details) => (details.open = true)));
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
    const widths = await page.locator("figure.chart").evaluateAll((all) => all.map((figure) => [figure.clientWidth, figure.querySelector(".uplot").clientWidth]));
    assert.ok(widths.length > 5 && widths.every(([figure, plot]) => plot === figure), `${widths}`);
  }
});

test("names in legends stay on one line", async () => {
  for (const [width, height] of [[390, 844], [844, 390], [1400, 900]]) {
    const page = await openFile("made/report.html", { width, height });
    const rows = await page.locator(".u-series").evaluateAll((all) => all.map((row) => [row.textContent, row.getBoundingClientRect().height]));
    assert.deepEqual(rows.filter(([, height]) => height > 26), [], `${width}x${height}`);
    const tops = await chart(page, "Rays per pixel").locator(".u-series").evaluateAll((all) => all.slice(1).map((row) => row.getBoundingClientRect().top));
    if (width > 390) assert.equal(new Set(tops).size, 1, `${width}x${height}: ${tops}`);
  }
});

test("two renders stand side by side", async () => {
  const page = await openFile("both.html");
  assert.deepEqual(await page.locator(".compare thead th").allTextContents(), ["", "traced", "made"]);
  assert.equal(await page.locator("h2").count(), 3);
});

test("a truncated report gives one line of error", () => {
  writeFileSync(inFolder("cut.json"), readFileSync(inFolder("made/report.json"), "utf8").slice(0, 2000));
  assert.throws(() => lippmann("report", "cut.json"), /cut\.json: is not JSON, or is truncated/);
});
