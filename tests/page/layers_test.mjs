// Quilts that exceed the GPU's texture size are stored in layers of whole tiles, and look the same.
import assert from "node:assert/strict";
import { readdirSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { closeAfterEach, eyeCodes, eyeOfView, inFolder, lippmann, open, panelCodes, play, quilt, set, view } from "./support.mjs";

closeAfterEach();

/** Returns a script that simulates a GPU with this maximum texture size. */
const limitedTo = (side) => `{
  const original = WebGL2RenderingContext.prototype.getParameter;
  WebGL2RenderingContext.prototype.getParameter = function (name) {
    return name === this.MAX_TEXTURE_SIZE ? ${side} : original.call(this, name);
  };
  const store = WebGL2RenderingContext.prototype.texStorage3D;
  window.layers = [];
  WebGL2RenderingContext.prototype.texStorage3D = function (target, levels, format, width, height, depth) {
    window.layers.push([width, height, depth]);
    return store.call(this, target, levels, format, width, height, depth);
  };
}`;

/** Lowest accepted PSNR in dB. Layers have other texture coordinates than one texture, and GPUs round coordinates to
 *  1/256 of a texel. */
const kLeastDb = 50;
const psnr = (a, b) => -10 * Math.log10(a.reduce((sum, x, i) => sum + ((x - b[i]) / 255) ** 2, 0) / a.length);
const most = (a, b) => a.reduce((greatest, x, i) => Math.max(greatest, Math.abs(x - b[i])), 0);

test("layers look like one texture", async () => {
  quilt();
  const address = await view("quilt");
  const whole = await open(address);
  const layered = await open(address, { script: limitedTo(220) });
  const places = [[0, 0], [4.5, 0], [7.5, 0]];
  for (const [across, up] of places)
    for (const changes of [{ between: "depth", aperture: 0 }, { between: "blend" }, { aperture: 0.6, focus: 3 }]) {
      const state = { eye: await eyeOfView(whole, across, up), ...changes };
      await set(whole, state), await set(layered, state);
      const alike = psnr(await eyeCodes(whole, 192), await eyeCodes(layered, 192));
      console.log(`view ${across}, ${JSON.stringify(changes)}: ${alike.toFixed(1)} dB`);
      assert.ok(alike >= kLeastDb, `view ${across}, ${JSON.stringify(changes)}: ${alike} dB`);
    }
  for (const page of [whole, layered]) await set(page, { show: "panel", aperture: 0 });
  assert.equal(most(await panelCodes(whole), await panelCodes(layered)), 0, "what the panel shows");
  // A layer holds 2x1 tiles of 96x128 pixels, so 4x3 tiles need 6 layers.
  const layers = await layered.evaluate(() => window.layers);
  assert.deepEqual([...new Set(layers.map(String))], ["192,128,6"]);
  assert.equal(layers.length % 2, 0, "colours and depth alike");
  assert.equal(await layered.textContent("#notice"), "");
});

test("a panel plays a layered quilt exactly", async () => {
  lippmann("render", "room", "--optics", "multiview", "--views", "8x6", "--size", "384x288", "--frames", "0", "--to", "quilt", "-o", "room", "-q");
  const input = `room/${readdirSync(inFolder("room")).find((name) => /_qs8x6a.*\.png$/.test(name))}`;
  const calibration = { pitch: 52.3, slope: -7.2, center: 0.37, DPI: 324, screenW: 203, screenH: 151, viewCone: 40 };
  writeFileSync(inFolder("panel.json"), JSON.stringify(calibration));
  for (const filter of ["nearest", "gaussian"]) {
    const address = await play(input, "--display", "panel.json", "--filter", filter);
    const [whole, layered] = [await open(address), await open(address, { script: limitedTo(210) })];
    assert.equal(most(await panelCodes(whole), await panelCodes(layered)), 0, filter);
    assert.ok((await layered.evaluate(() => window.layers)).length > 0);
  }
});

test("views that are too large are scaled down", async () => {
  const page = await open(await view("quilt"), { script: limitedTo(100) });
  assert.match(await page.textContent("#notice"), /Shown at 1\/2 of its size: this device's GPU supports at most 100 pixels a side/);
});
