// A calibrated panel shows a scene that is being set up. Its final frame equals that of the saved job.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { differenceFrom, drop } from "./panel.mjs";
import { inFolder, lippmann, only, open, play, view } from "./support.mjs";

const cells = [-1, 1].map((side) => ({ ROffsetX: 0.31 * side, ROffsetY: 0.17, GOffsetX: -0.21, GOffsetY: 0.05 * side, BOffsetX: 0.02, BOffsetY: -0.33 }));
const panel = { pitch: 52.3, slope: -7.2, center: 0.37, DPI: 324, screenW: 203, screenH: 151, viewCone: 40, subpixelCells: cells, CellPatternMode: 1 };
writeFileSync(inFolder("panel.json"), JSON.stringify(panel));
writeFileSync(inFolder("other.json"), JSON.stringify({ ...panel, center: 0.81, screenW: 180, screenH: 120 }));

const size = { width: 820, height: 420 };
const atRest = (page) => page.waitForSelector('#stage[data-rest="true"][data-drawn="true"]', { timeout: 90000 });
const scene = (page) => page.evaluate(() => window.lippmann.scene);
const shown = (page) => page.evaluate(() => window.lippmann.state.show);

async function setUp(page, settings) {
  const { version } = await scene(page);
  await page.evaluate((settings) => window.lippmann.setUp(settings), settings);
  await page.waitForFunction((version) => window.lippmann.scene.version > version, version);
  await atRest(page);
}

async function saved(page, name) {
  await Promise.all([page.waitForResponse(/\/live\/save$/), page.getByRole("button", { name: "Save job" }).click()]);
  await page.waitForFunction((name) => window.lippmann.scene.saved === name, name);
  return name;
}

const quilt = ["--views", "5x4", "--size", "320x192", "--frames", "0-2"];
const page = await open(await play("room", "--display", "panel.json", "--filter", "linear", "--save-job", "quilt.toml", ...quilt), size);

test("the panel shows the scene's first pass", async () => {
  assert.equal(await shown(page), "display");
  assert.deepEqual(await page.evaluate(() => [document.querySelector("#canvas").width, document.querySelector("#canvas").height]), [203, 151]);
  await page.waitForFunction(() => window.lippmann.panel().some((code, i) => i % 4 < 3 && code > 40));
  await atRest(page);
});

test("at rest the panel matches convert", async () => {
  await setUp(page, { zoom: "1.3", orbit: "20,5" });
  lippmann("render", await saved(page, "quilt.toml"), "--frames", "0", "-o", "quilts", "-q");
  lippmann("convert", `quilts/${only("quilts", /^frame_0000.*\.png$/)}`, "quilt.png", "--to", "native", "--display", "panel.json", "--filter", "linear");
  const { most, differ } = await differenceFrom(page, "quilt.png");
  console.log(`of a quilt: ${most} codes at most, ${(100 * differ).toFixed(4)} % of the codes differ`);
  assert.ok(most <= 1, `${most} codes`);
});

test("dragging and arrow keys turn the camera", async () => {
  await page.getByLabel("Dragging the picture").selectOption("turn");
  const before = await scene(page);
  const box = await page.locator("#canvas").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 - 40, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  await page.waitForFunction((version) => window.lippmann.scene.version > version, before.version);
  await atRest(page);
  const dragged = await scene(page);
  assert.notEqual(dragged.settings.orbit, before.settings.orbit);
  await page.locator("#canvas").focus();
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction((version) => window.lippmann.scene.version > version, dragged.version);
  assert.notEqual((await scene(page)).settings.orbit, dragged.settings.orbit);
  await page.evaluate(() => window.lippmann.set({ drag: "eye" }));
});

test("another window changes the panel's scene and frame", async () => {
  const [second] = await Promise.all([page.waitForEvent("popup"), page.getByRole("button", { name: "Set up in another window" }).click()]);
  await atRest(second);
  assert.equal(await shown(second), "eye");
  await second.evaluate(() => window.lippmann.set({ frame: 2 }));
  await second.waitForSelector('#stage[data-frame="2"][data-rest="true"]', { timeout: 90000 });
  await page.waitForSelector('#stage[data-frame="2"][data-rest="true"]', { timeout: 90000 });
  await setUp(second, { zoom: "0.8" });
  await page.waitForFunction(() => window.lippmann.scene.settings.zoom === "0.8");
  await atRest(page);
  assert.equal(await page.evaluate(() => window.lippmann.state.frame), 2);
  assert.equal(await shown(page), "display");
  lippmann("render", await saved(page, await savedNext(page)), "--frames", "2", "-o", "second", "-q");
  lippmann("convert", `second/${only("second", /^frame_0002.*\.png$/)}`, "second.png", "--to", "native", "--display", "panel.json", "--filter", "linear");
  assert.ok((await differenceFrom(page, "second.png")).most <= 1);
  await second.close();
});

const savedNext = async (page) => (await scene(page)).saved;

test("the page renders the panel's frame", async () => {
  await page.getByRole("button", { name: "Render this frame" }).click();
  await page.waitForFunction(() => window.lippmann.scene.render?.state === "finished");
  assert.match(await page.locator("#facts").textContent(), /./);
  await atRest(page);
  assert.match(only("out/room", /^frame_0002.*\.png$/), /qs5x4/);
});

test("the panel depends on the set-up's display", async () => {
  const choice = () => page.locator('option[value="display"]').isDisabled();
  await setUp(page, { display: "", optics: "multiview" });
  await page.waitForFunction(() => window.lippmann.state.show === "eye");
  assert.equal(await choice(), true);
  await setUp(page, { display: null, optics: null });
  assert.equal(await choice(), false);
  await page.evaluate(() => window.lippmann.set({ show: "display" }));
  await atRest(page);
});

test("a dropped calibration replaces the panel", async () => {
  await drop(page, "visual.json", readFileSync(inFolder("other.json"), "utf8"));
  await page.waitForFunction(() => document.querySelector("#canvas").width === 180);
  await atRest(page);
  lippmann("convert", `second/${only("second", /^frame_0002.*\.png$/)}`, "dropped.png", "--to", "native", "--display", "other.json", "--filter", "linear");
  assert.ok((await differenceFrom(page, "dropped.png")).most <= 1);
});

test("a job in native layout is played exactly", async () => {
  writeFileSync(inFolder("own.toml"), 'scene = "room"\ndisplay = "panel.json"\nlayout = "native"\nframes = "1"\n');
  const own = await open(await play("own.toml"), size);
  await own.waitForSelector('#stage[data-frame="1"][data-rest="true"][data-drawn="true"]', { timeout: 90000 });
  lippmann("render", "own.toml", "-o", "own", "-q");
  assert.deepEqual(await differenceFrom(own, `own/${only("own", /\.png$/)}`), { most: 0, differ: 0 });
  await own.close();
});

test("view of a panel's scene can play it", async () => {
  const page = await open(await view("room", "--display", "panel.json", ...quilt), size);
  await atRest(page);
  assert.equal(await shown(page), "eye");
  await page.getByLabel("Show", { exact: true }).selectOption("display");
  await page.waitForFunction(() => document.querySelector("#canvas").width === 203);
  await atRest(page);
  lippmann("render", "room", "--display", "panel.json", ...quilt.slice(0, 4), "--frames", "0", "-o", "seen", "-q");
  lippmann("convert", `seen/${only("seen", /^frame_0000.*\.png$/)}`, "seen.png", "--to", "native", "--display", "panel.json");
  assert.deepEqual(await differenceFrom(page, "seen.png"), { most: 0, differ: 0 });
  await page.close();
});

test("scenes that no panel shows are refused", async () => {
  await assert.rejects(play("room"), /--display/);
  await assert.rejects(play("room", "--display", "microlens-1mm-4k"), /only slanted panels have interlaced pixels/);
  await assert.rejects(play("room", "--display", "panel.json", "--from", "hci"), /--from: has no effect: IN is a scene/);
  await assert.rejects(play("nothing-there", "--display", "panel.json", "--zoom", "2"), /--zoom.*scenes/);
});
