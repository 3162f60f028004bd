// Two light fields are compared by a wipe, side by side, and by their difference.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { besidePanel } from "./panel.mjs";
import { closeAfterEach, inFolder, lippmann, open, set, sheet, view } from "./support.mjs";

closeAfterEach();

sheet();
lippmann("render", "teapot", "--size", "256x256", "--lenses", "32", "--frames", "0-5", "--exposure", "0.3", "-o", "brighter", "-q");

test("a wipe shows both fields and their difference", async () => {
  const page = await open(await view("sheet", "brighter"));
  const pictures = await page.evaluate(async () => [await window.lippmann.picture(64, 64, 0), await window.lippmann.picture(64, 64, 1)].map((codes) => codes.slice(0, 4096).reduce((a, b) => a + b)));
  assert.ok(pictures[1] > pictures[0] * 1.02, `${pictures}`);
  for (const compare of ["wipe", "side-by-side", "difference", "first", "second"]) await set(page, { compare });
  await set(page, { compare: "difference", scale: 64 });
  const shown = await page.locator("#scale").textContent();
  const psnr = Number(/([0-9.]+) dB/.exec(shown)[1]);
  assert.ok(psnr > 15 && psnr < 45, shown);
  assert.match(shown, /0 to 64 codes/);
  await set(page, { frame: 3 });
});

test("few lenses are compared beside their panels", async () => {
  const page = await open(await view("sheet", "brighter"), { width: 1400, height: 900 });
  for (const [width, height, scale, isBelow] of [[1400, 900, 2, false], [390, 844, 1, true]]) {
    await page.setViewportSize({ width, height });
    await set(page, { compare: "wipe", wipe: 0.5 });
    assert.deepEqual(await besidePanel(page, "sheet", { to: 0.49 }), { scale, most: 0, isBelow });
    assert.deepEqual(await besidePanel(page, "brighter", { from: 0.51 }), { scale, most: 0, isBelow });
    await set(page, { compare: "side-by-side" });
    assert.deepEqual(await besidePanel(page, "sheet", { shift: -0.5 }), { scale: 1, most: 0, isBelow });
    assert.deepEqual(await besidePanel(page, "brighter", { shift: 0.5 }), { scale: 1, most: 0, isBelow });
    await set(page, { compare: "second" });
    assert.deepEqual(await besidePanel(page, "brighter"), { scale, most: 0, isBelow });
  }
});

test("the wipe is dragged on either picture", async () => {
  const page = await open(await view("sheet", "brighter"), { width: 1400, height: 900 });
  const at = await page.evaluate(() => {
    const canvas = document.getElementById("canvas").getBoundingClientRect();
    return ["eye-caption", "panel-caption"].map((id) => ({ x: parseFloat(document.getElementById(id).style.left) + document.getElementById("stage").getBoundingClientRect().left, y: canvas.top + canvas.height / 2 }));
  });
  for (const [i, { x, y }] of at.entries()) {
    await set(page, { wipe: 0.5 });
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 128, y, { steps: 4 });
    await page.mouse.up();
    const wipe = await page.evaluate(() => window.lippmann.state.wipe);
    assert.ok(Math.abs(wipe - 0.75) < 0.01, `picture ${i}: ${wipe}`);
  }
});

test("a light field beside itself is identical", async () => {
  const page = await open(`${await view("sheet", "sheet")}#compare=difference`);
  assert.match(await page.locator("#scale").textContent(), /identical/);
});

test("the panel's picture follows from the views", async () => {
  const page = await open(`${await view("sheet")}#show=panel`, { width: 900, height: 900 });
  const url = `data:image/png;base64,${readFileSync(inFolder("sheet/frame_0000.png")).toString("base64")}`;
  const wrong = await page.evaluate(async (url) => {
    const bytes = Uint8Array.from(atob(url.split(",")[1]), (c) => c.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes]), { colorSpaceConversion: "none" });
    const canvas = new OffscreenCanvas(256, 256);
    canvas.getContext("2d").drawImage(bitmap, 0, 0);
    const codes = canvas.getContext("2d").getImageData(0, 0, 256, 256).data;
    const code = (v) => Math.floor(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055) + 0.5);
    let wrong = 0;
    // The picture is enlarged, so centres of the panel's pixels are read.
    for (let y = 3; y < 256; y += 17)
      for (let x = 5; x < 256; x += 13) {
        const seen = window.lippmann.valueAt((x + 0.5) / 256, (y + 0.5) / 256).map(code);
        if (seen.some((value, c) => value !== codes[4 * (256 * y + x) + c])) wrong++;
      }
    return wrong;
  }, url);
  assert.equal(wrong, 0);
});
