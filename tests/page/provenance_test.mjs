// An overlay tints pixels by how they were made (provenance), exactly as the render reports.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { closeAfterEach, eyeCodes, eyeOfView, inFolder, lippmann, open, panelCodes, set, sheet, view } from "./support.mjs";

closeAfterEach();

const kPixels = 256 * 64;
lippmann("render", "gears", "--optics", "multiview", "--views", "4x1", "--size", "256x64", "--frames", "0,8", "--reuse", "interpolate", "--keyframes", "16", "--aov", "provenance", "-o", "gears", "-q");
const { frames } = JSON.parse(readFileSync(inFolder("gears/report.json")));
const address = await view("gears");

const legend = (page) => page.locator("#legend li").allTextContents();
const picture = (page) => eyeCodes(page, 64);
const codesOfView = (page, frame, view) => page.evaluate(async ([frame, view]) => {
  const bitmap = await createImageBitmap(await (await fetch(`0/provenance/${frame}`)).blob(), { colorSpaceConversion: "none" });
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
  context.drawImage(bitmap, 0, 0);
  const { tiles, view_size: size } = window.lippmann.fields[0];
  const [column, row] = [view % tiles[0], tiles[1] - 1 - Math.floor(view / tiles[0])];
  const data = context.getImageData(column * size[0], row * size[1], ...size).data;
  return [...data].filter((_, i) => i % 4 === 0);
}, [frame, view]);

test("only missed pixels are tinted", async () => {
  const page = await open(address);
  await page.locator("#legend").waitFor({ state: "hidden" });
  await set(page, { frame: 1 });
  let missed = 0;
  for (const view of [0, 3]) {
    const eye = await eyeOfView(page, view, 0);
    await set(page, { eye, between: "blend", overlay: "none" });
    const plain = await picture(page);
    await set(page, { overlay: "missed" });
    const tinted = await picture(page);
    const codes = await codesOfView(page, 1, view);
    codes.forEach((code, i) => {
      const differs = [0, 1, 2].some((c) => plain[4 * i + c] !== tinted[4 * i + c]);
      assert.equal(differs, code === 3, `view ${view}, pixel ${i} of code ${code}`);
      missed += code === 3 ? 1 : 0;
    });
  }
  assert.ok(missed > 0, "no pixel was missed, so the test is void");
});

test("the legend has the frame's shares", async () => {
  const page = await open(address);
  await set(page, { frame: 1, overlay: "provenance" });
  const share = frames[1].missed_pixels / kPixels;
  const text = (share) => `${(100 * share).toFixed(1)}\u2009%`;
  assert.deepEqual(await legend(page), [`interpolated ${text(1 - share)}`, `missed, filled ${text(share)}`]);
  await set(page, { overlay: "missed" });
  assert.deepEqual(await legend(page), [`missed, filled ${text(share)}`]);
  await set(page, { frame: 0 });
  assert.deepEqual(await legend(page), ["missed 0.0\u2009%"]);
  await set(page, { overlay: "provenance" });
  assert.deepEqual(await legend(page), ["traced 100.0\u2009%"]);
  await page.getByLabel("Overlay").selectOption("none");
  // Unlike set(), selectOption() does not wait until the page shows the change.
  await page.locator("#legend").waitFor({ state: "hidden" });
});

/** Returns a PNG file in base64 in which the first `pixels` pixels have the provenance code `code`, the others 0. */
const codesWith = (page, code, pixels) => page.evaluate(async ([code, pixels]) => {
  const { tiles, view_size: size } = window.lippmann.fields[0];
  const canvas = new OffscreenCanvas(tiles[0] * size[0], tiles[1] * size[1]);
  const context = canvas.getContext("2d");
  context.fillStyle = "#000000";
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.fillStyle = `rgb(${code}, ${code}, ${code})`;
  context.fillRect(0, 0, pixels, 1);
  const bytes = new Uint8Array(await (await canvas.convertToBlob({ type: "image/png" })).arrayBuffer());
  return btoa(String.fromCharCode(...bytes));
}, [code, pixels]);

test("shares near 100 % are not rounded up", async () => {
  const page = await open(address);
  const body = Buffer.from(await codesWith(page, 3, 3), "base64");
  await page.route("**/0/provenance/1", (route) => route.fulfill({ contentType: "image/png", body }));
  await set(page, { frame: 1, overlay: "provenance" });
  await page.locator("#legend li").nth(1).waitFor();
  assert.deepEqual(await legend(page), ["traced 99.9\u2009%", "missed, filled < 0.1\u2009%"]);
  await page.unroute("**/0/provenance/1");
});

test("the panel's picture is tinted, values are not", async () => {
  const page = await open(address);
  await set(page, { frame: 1, overlay: "none" });
  const value = await page.evaluate(() => window.lippmann.valueAt(0.5, 0.5));
  await set(page, { overlay: "provenance" });
  assert.deepEqual(await page.evaluate(() => window.lippmann.valueAt(0.5, 0.5)), value);
  const panel = () => panelCodes(page);
  await set(page, { show: "panel" });
  const tinted = await panel();
  await set(page, { overlay: "none" });
  assert.notDeepEqual(await panel(), tinted);
});

test("saved pages have the overlay", async () => {
  lippmann("view", "gears", "--save", "saved");
  const page = await open(`file://${inFolder("saved")}/index.html#frame=1&overlay=provenance`);
  assert.equal((await legend(page)).length, 2);
  sheet();
  const other = await open(await view("sheet"));
  assert.equal(await other.getByLabel("Overlay").isVisible(), false);
});
