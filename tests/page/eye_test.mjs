// The picture for an eye matches `lippmann replay` with a PSNR of 40 dB at the eye of a view, and 30 dB between views.
import assert from "node:assert/strict";
import { test } from "node:test";
import { closeAfterEach, eyeOfView, fractional, grid, lenslets, open, psnrBeside, quilt, replay, set, sheet, view } from "./support.mjs";

closeAfterEach();

async function compare(name, make, views) {
  make();
  const page = await open(await view(name));
  for (const [across, up] of views) {
    const eye = await eyeOfView(page, across, up);
    await set(page, { eye, lenses: true, between: "blend" });
    const file = replay(name, `${name}-${across}-${up}`, "--eye", eye.join(","));
    const psnr = await psnrBeside(page, file);
    const least = Number.isInteger(across) && Number.isInteger(up) ? 40 : 30;
    console.log(`${name}, view ${across}, ${up}: ${psnr.toFixed(1)} dB`);
    assert.ok(psnr >= least, `${name}, view ${across}, ${up}: ${psnr} dB, at least ${least}`);
  }
}

test("a lenticular sheet", () => compare("sheet", sheet, [[0, 0], [3, 0], [7, 0], [2.4, 0], [5.5, 0]]));
test("an array of lenslets", () => compare("lenslets", lenslets, [[0, 0], [2, 1], [3, 3], [1.3, 0.5], [2.5, 2.2]]));
test("a quilt", () => compare("quilt", quilt, [[0, 0], [6, 0], [11, 0], [4.5, 0], [9.7, 0]]));
test("a grid of cameras", () => compare("grid", grid, [[0, 0], [2, 2], [4, 1], [1.5, 2.5], [3.2, 0.7]]));

// With a fractional number of pixels per lens, a view does not consist of whole panel pixels.
test("fractional lenses", () => compare("fractional", fractional, [[0, 0], [3, 0], [5, 0]]));

test("eyes outside the zone match replay, too", async () => {
  for (const [name, eye] of [["sheet", [60, 0, 192]], ["sheet", [-10, 0, 120]], ["lenslets", [-50, 30, 150]], ["quilt", [90, 0, 200]], ["grid", [30, 10, 150]]]) {
    const page = await open(await view(name));
    await set(page, { eye, lenses: true, between: "blend" });
    const psnr = await psnrBeside(page, replay(name, `${name}-${eye.join("_")}`, "--eye", eye.join(",")));
    console.log(`${name} from ${eye}: ${psnr.toFixed(1)} dB`);
    assert.ok(psnr >= 30, `${name} from ${eye}: ${psnr} dB`);
  }
});

test("depth interpolates views better than blending", async () => {
  const { lippmann } = await import("./support.mjs");
  lippmann("render", "room", "--optics", "multiview", "--camera-grid", "--views", "9x1", "--size", "1152x128", "--view-angle", "20", "--frames", "0", "--aov", "depth", "-o", "row", "-q");
  lippmann("convert", "row/frame_0000.png", "row-miv", "--to", "miv");
  lippmann("convert", "row-miv", "half", "--from", "miv", "--to", "miv", "--keep", "0-8:2");
  const page = await open(await view("half"));
  const whole = await open(await view("row"));
  const eye = await eyeOfView(whole, 3, 0);
  const traced = replay("row", "row-3", "--eye", eye.join(","));
  const psnr = {};
  for (const between of ["depth", "blend"]) {
    await set(page, { eye, between });
    psnr[between] = await psnrBeside(page, traced);
  }
  console.log(`by depth ${psnr.depth.toFixed(1)} dB, blended ${psnr.blend.toFixed(1)} dB`);
  assert.ok(psnr.depth >= psnr.blend + 3, `by depth ${psnr.depth} dB, blended ${psnr.blend} dB`);
});

test("the limits of the eye are within the zone", async () => {
  for (const [name, make] of [["sheet", sheet], ["quilt", quilt], ["fractional", fractional]]) {
    make();
    const page = await open(await view(name));
    for (const key of ["Home", "End"]) {
      const before = page.url();
      await page.getByRole("slider", { name: "Left to right" }).press(key);
      await page.waitForFunction((before) => location.href !== before, before);
      for (const loads of [1, 2]) {
        await page.waitForSelector('#stage[data-drawn="true"]');
        const { share, eye } = await page.evaluate(() => ({ share: window.lippmann.outOfZone, eye: window.lippmann.state.eye }));
        assert.equal(share, 0, `${name}, ${key}, load ${loads}: ${eye}`);
        assert.equal(await page.locator("#notice").textContent(), "");
        if (loads === 1) await page.reload();
      }
    }
  }
});
