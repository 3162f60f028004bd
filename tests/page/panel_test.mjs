// On a calibrated panel, the canvas equals `lippmann convert --to native` within one code.
import assert from "node:assert/strict";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { differenceFrom, drop } from "./panel.mjs";
import { closeAfterEach, drawn, expectComplaints, grid, inFolder, lippmann, open, play, set, sheet, view } from "./support.mjs";

closeAfterEach();

sheet();
grid();
lippmann("render", "room", "--optics", "multiview", "--views", "8x6", "--size", "384x288", "--frames", "0-3", "--to", "quilt", "-o", "room", "-q");
const quilts = readdirSync(inFolder("room")).filter((name) => /_qs8x6a.*\.png$/.test(name)).map((name) => `room/${name}`);

/** Writes a calibration file with `values` in place of defaults. Returns its name. */
const calibration = (name, values) => {
  writeFileSync(inFolder(`${name}.json`), JSON.stringify({ pitch: 52.3, slope: -7.2, center: 0.37, DPI: 324, screenW: 203, screenH: 151, viewCone: 40, ...values }));
  return `${name}.json`;
};
const cells = [-1, 1].map((side) => ({ ROffsetX: 0.31 * side, ROffsetY: 0.17, GOffsetX: -0.21, GOffsetY: 0.05 * side, BOffsetX: 0.02, BOffsetY: -0.33 }));

async function compare(name, input, display, flags = [], reading = []) {
  lippmann("convert", input, `${name}.png`, ...reading, "--to", "native", "--display", display, ...flags);
  const page = await open(await play(input, "--display", display, ...flags, ...reading));
  await page.evaluate(() => window.lippmann.pause());
  await set(page, { frame: 0 });
  const { most, differ } = await differenceFrom(page, `${name}.png`);
  console.log(`${name}: ${most} codes at most, ${(100 * differ).toFixed(4)} % of the codes differ`);
  assert.ok(most <= 1, `${name}: ${most} codes`);
  if (!flags.includes("linear") && !flags.includes("gaussian")) assert.equal(most, 0, name);
  return page;
}

test("a striped panel", () => compare("striped", quilts[0], calibration("striped-panel")));
test("flipped sub-pixels and lenses", () => compare("flipped", quilts[0], calibration("flipped-panel", { flipImageX: 1, flipImageY: 1, flipSubp: 1, slope: 6.1 })));
for (const pattern of [0, 1, 2, 3, 4])
  test(`cells of sub-pixels by pattern ${pattern}`, () => compare(`cells-${pattern}`, quilts[0], calibration(`cells-${pattern}-panel`, { subpixelCells: cells, CellPatternMode: pattern })));
test("filtered views", async () => {
  const display = calibration("mixed-panel", { subpixelCells: cells, CellPatternMode: 1 });
  await compare("linear", quilts[0], display, ["--filter", "linear"]);
  await compare("gaussian", quilts[0], display, ["--filter", "gaussian", "--sigma", "0.8"]);
});

// If the page computed in single precision, hundreds of sub-pixels would show a wrong view.
test("a preset at full size", () => compare("portrait", quilts[0], "portrait"));

test("a render behind a lenticular sheet", async () => {
  const page = await compare("of-sheet", "sheet/frame_0000.png", calibration("sheet-panel"));
  await page.setViewportSize({ width: 1400, height: 900 });
  await set(page, { show: "eye" });
  assert.equal(await page.locator(".caption:visible").count(), 2);
  await set(page, { show: "display" });
  assert.equal(await page.locator(".caption:visible").count(), 0);
});

test("a set of views", async () => {
  lippmann("convert", quilts[0], "set", "--to", "views");
  await compare("of-set", "set", calibration("set-panel"), [], ["--views", "48x1"]);
});

test("native frames are played unchanged", async () => {
  const display = calibration("own-panel");
  lippmann("render", "room", "--display", display, "--layout", "native", "--frames", "0", "-o", "own", "-q");
  const own = readdirSync(inFolder("own")).find((name) => name.endsWith(".png"));
  const page = await open(await play("own", "--display", display));
  assert.deepEqual(await differenceFrom(page, `own/${own}`), { most: 0, differ: 0 });
  const other = await open(await play("own", "--display", calibration("other-panel", { center: 0.6 })));
  assert.ok((await differenceFrom(other, `own/${own}`)).most > 1, "the calibration has no effect");
});

test("frames play in a loop, loaded once", async () => {
  const asked = [];
  const page = await open(await play("room", "--display", calibration("loop-panel")), { onRequest: (url) => asked.push(url) });
  await page.waitForFunction(() => window.lippmann.isPlaying && window.lippmann.state.frame === 3, null, { timeout: 60000 });
  await page.waitForFunction(() => window.lippmann.state.frame === 0, null, { timeout: 60000 });
  const pictures = () => asked.filter((url) => /\/views\/\d+$/.test(url));
  assert.equal(pictures().length, 4);
  const shown = await page.evaluate(async () => {
    const frames = [];
    while (frames.length < 9) {
      await new Promise(requestAnimationFrame);
      const { drawn, frame } = document.querySelector("#stage").dataset;
      if (drawn !== "true") frames.push("none");
      else if (frames[frames.length - 1] !== frame) frames.push(frame);
    }
    return frames;
  });
  assert.ok(!shown.includes("none"), `nothing is shown between ${shown}`);
  assert.equal(pictures().length, 4, "frames are loaded again");
  lippmann("convert", quilts[2], "loop.png", "--to", "native", "--display", "loop-panel.json");
  await page.evaluate(() => window.lippmann.pause());
  await set(page, { frame: 2 });
  assert.deepEqual(await differenceFrom(page, "loop.png"), { most: 0, differ: 0 });
});

test("the server reads a dropped calibration", async () => {
  const display = calibration("dropped-panel", { center: 0.81 });
  lippmann("convert", quilts[0], "dropped.png", "--to", "native", "--display", display);
  const page = await open(await view(quilts[0]));
  assert.equal(await page.locator('option[value="display"]').isDisabled(), true);
  await drop(page, "visual.json", readFileSync(inFolder(display), "utf8"));
  await page.waitForFunction(() => window.lippmann.state.show === "display");
  await drawn(page);
  assert.equal((await differenceFrom(page, "dropped.png")).most, 0);
  lippmann("convert", quilts[0], "second.png", "--to", "native", "--display", calibration("second-panel", { center: 0.2, serial: "LKG-second" }));
  await drop(page, "visual.json", readFileSync(inFolder("second-panel.json"), "utf8"));
  await page.getByText(/LKG-second/).waitFor();
  await drawn(page);
  assert.equal((await differenceFrom(page, "second.png")).most, 0);
});

test("invalid calibrations give a message", async () => {
  expectComplaints(/status of 422/);
  const page = await open(await view(quilts[0]));
  for (const [text, message] of [
    ["no JSON", /visual\.json cannot be used: the calibration/],
    ["{}", /screenW/],
    ['{"pitch":50,"slope":0,"center":0,"DPI":324,"screenW":100,"screenH":100}', /slope.*lenses lie along the rows/],
    ['{"pitch":50,"slope":-7,"center":0,"DPI":324,"screenW":100,"screenH":0}', /screenH/],
    [" ".repeat((1 << 20) + 1), /larger than 1 MB/],
  ]) {
    await drop(page, "visual.json", text);
    await page.waitForFunction((pattern) => new RegExp(pattern).test(document.querySelector("#notice").textContent), message.source);
    assert.equal(await page.evaluate(() => window.lippmann.state.show), "eye");
  }
});

test("light fields that no panel plays are refused", async () => {
  writeFileSync(inFolder("broken.json"), "{");
  await assert.rejects(play(quilts[0], "--display", "broken.json"), /broken\.json/);
  await assert.rejects(play(quilts[0], "--display", "missing.json"), /there is no such file/);
  await assert.rejects(play(quilts[0], "--display", "microlens-1mm-4k"), /only slanted panels have interlaced pixels/);
  await assert.rejects(play("grid", "--display", "portrait"), /5x5 views/);
  await assert.rejects(play(quilts[0]), /--display/);
});

test("F fills the screen pixel for pixel", async () => {
  const page = await open(await play(quilts[0], "--display", calibration("screen-panel")), { width: 800, height: 600 });
  assert.match(await page.locator("#notice").textContent(), /F plays it pixel for pixel/);
  await page.locator("#canvas").focus();
  await page.keyboard.press("f");
  await page.waitForFunction(() => document.fullscreenElement !== null);
  await page.waitForFunction(() => /This screen has \d+×\d+ pixels, but the panel 203×151/.test(document.querySelector("#notice").textContent));
  const box = await page.locator("#canvas").boundingBox();
  assert.deepEqual([box.x, box.y, box.width, box.height], [0, 0, 203, 151]);
  await page.keyboard.press("f");
  await page.waitForFunction(() => document.fullscreenElement === null);
  await page.getByRole("button", { name: "Full screen" }).click();
  await page.waitForFunction(() => document.fullscreenElement !== null);
});
