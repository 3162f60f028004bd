// Refocusing matches `lippmann replay`, and a click finds the depth of objects.
import assert from "node:assert/strict";
import { test } from "node:test";
import { grid, open, psnrBeside, replay, set, view } from "./support.mjs";

grid();
const page = await open(await view("grid"));

/** Returns the mean squared difference of neighbouring pixels in a part of the picture. */
const sharpness = (left, top) =>
  page.evaluate(
    async ([left, top]) => {
      const side = 256;
      const codes = await window.lippmann.picture(side, side);
      let sum = 0;
      for (let y = Math.round(top * side) - 14; y < Math.round(top * side) + 14; y++)
        for (let x = Math.round(left * side) - 14; x < Math.round(left * side) + 14; x++) sum += (codes[4 * (y * side + x)] - codes[4 * (y * side + x + 1)]) ** 2;
      return sum;
    },
    [left, top],
  );

/** Positions from the top left, as shares of the picture: the globe in front of the display's plane, the clock behind it. */
const places = { globe: [0.142, 0.66], clock: [0.777, 0.343] };

test("planes in focus match replay", async () => {
  for (const depth of [-60, -14, 0, 15]) {
    await set(page, { aperture: 1, focus: depth });
    const psnr = await psnrBeside(page, replay("grid", `at${depth}`, `--refocus=${depth}`));
    console.log(`focused at ${depth} mm: ${psnr.toFixed(1)} dB`);
    assert.ok(psnr >= 35, `focused at ${depth} mm: ${psnr} dB`);
  }
});

test("a click focuses, with and without depth", async () => {
  for (const [name, place] of Object.entries(places)) {
    await set(page, { aperture: 1 });
    await page.evaluate((place) => window.lippmann.focusAt(...place), place);
    const depth = await page.evaluate(() => window.lippmann.state.focus);
    const best = await sharpness(...place);
    for (const away of [-30, 30]) {
      await set(page, { focus: depth + away });
      const other = await sharpness(...place);
      assert.ok(best > 1.3 * other, `${name}: at ${depth} mm ${best}, ${away} mm away ${other}`);
    }
    console.log(`${name}: at ${depth.toFixed(1)} mm`);
  }
  // Without stored depth, the page finds the depth by comparing views.
  const { lippmann, inFolder } = await import("./support.mjs");
  const { rmSync } = await import("node:fs");
  await page.evaluate((place) => window.lippmann.focusAt(...place), places.clock);
  const known = await page.evaluate(() => window.lippmann.state.focus);
  lippmann("convert", "grid/frame_0000.png", "blind", "--to", "hci");
  for (const file of ["gt_depth_lowres", "gt_disp_lowres"]) {
    rmSync(inFolder(`blind/${file}.pfm`), { force: true });
    for (let i = 0; i < 25; i++) rmSync(inFolder(`blind/${file}_Cam${String(i).padStart(3, "0")}.pfm`), { force: true });
  }
  const blind = await open(await view("blind"));
  assert.equal(await blind.evaluate(() => window.lippmann.fields[0].depth), false);
  await blind.evaluate((place) => window.lippmann.focusAt(...place), places.clock);
  const found = await blind.evaluate(() => window.lippmann.state.focus);
  console.log(`the clock without depth: at ${found.toFixed(1)} mm, in truth ${known.toFixed(1)} mm`);
  assert.ok(Math.abs(found - known) < 0.25 * Math.abs(known) + 5, `${found} mm, in truth ${known} mm`);
});

// A lens array compresses depth to its depth budget. A click finds the compressed depth.
test("a click finds the fitted depth", async () => {
  const { lippmann } = await import("./support.mjs");
  const depths = [];
  for (const layers of [["--aov", "depth"], []]) {
    const name = `fitted${layers.length}`;
    lippmann("render", "room", "--optics", "microlens", "--size", "512x512", "--lenses", "64x64", "--frames", "0", ...layers, "-o", name, "-q");
    const fitted = await open(await view(name));
    await fitted.evaluate(() => window.lippmann.picture(8, 8));
    await fitted.evaluate((place) => window.lippmann.focusAt(...place), places.clock);
    depths.push(await fitted.evaluate(() => window.lippmann.state.focus));
  }
  console.log(`the clock: at ${depths[0].toFixed(1)} mm by its depth, at ${depths[1].toFixed(1)} mm by the views`);
  assert.ok(Math.abs(depths[0] - depths[1]) < 1.5, `${depths}`);
});

test("only a double click opens the aperture", async () => {
  await set(page, { aperture: 0, focus: 0 });
  await page.locator("#canvas").click({ position: { x: 230, y: 230 } });
  assert.equal(await page.evaluate(() => window.lippmann.state.aperture), 0);
  await page.locator("#canvas").dblclick({ position: { x: 330, y: 330 } });
  const state = await page.evaluate(() => window.lippmann.state);
  assert.equal(state.aperture, 0.5);
});
