// Scrubbing, stepping and playing show the right frames.
import assert from "node:assert/strict";
import { test } from "node:test";
import { closeAfterEach, open, psnrBeside, replay, set, sheet, view } from "./support.mjs";

closeAfterEach();

sheet();
const address = await view("sheet");

test("scrubbing shows the chosen frame", async () => {
  const page = await open(address);
  await set(page, { lenses: true });
  replay("sheet", "frames");
  for (const frame of [4, 0, 2]) {
    await page.getByRole("slider", { name: "Frame" }).fill(String(frame));
    await page.waitForSelector(`#stage[data-frame="${frame}"]`);
    const file = replay("sheet", "frames").replace("eye_0000", `eye_000${frame}`);
    const psnr = await psnrBeside(page, file);
    assert.ok(psnr >= 38, `frame ${frame}: ${psnr} dB`);
    const other = await psnrBeside(page, file.replace(`000${frame}`, `000${(frame + 3) % 6}`));
    assert.ok(psnr > other + 3, `frame ${frame} is hardly nearer to itself, ${psnr} dB, than to another, ${other} dB`);
  }
});

test("buttons and keys step and play", async () => {
  const page = await open(address);
  const frame = () => page.evaluate(() => window.lippmann.state.frame);
  await page.getByRole("button", { name: "Next frame" }).click();
  assert.equal(await frame(), 1);
  await page.getByRole("button", { name: "Previous frame" }).click();
  await page.getByRole("button", { name: "Previous frame" }).click();
  assert.equal(await frame(), 5);
  await set(page, { frame: 0, loop: false });
  await page.getByRole("button", { name: "Play" }).click();
  await page.waitForFunction(() => window.lippmann.state.frame === 5, null, { timeout: 60000 });
  await page.getByRole("button", { name: "Play" }).waitFor();
  assert.equal(await frame(), 5);
  await set(page, { frame: 3, loop: true });
  await page.locator("#canvas").focus();
  await page.keyboard.press(" ");
  await page.waitForFunction(() => window.lippmann.state.frame < 3, null, { timeout: 60000 });
  await page.getByRole("button", { name: "Pause" }).click();
});

// The first animation frame after a click may have a time stamp from before the click.
test("a lagging clock plays from the shown frame", async () => {
  const ahead = "const now = performance.now.bind(performance); performance.now = () => now() + 200;";
  const page = await open(address, { script: ahead });
  const shown = () => page.evaluate(() => window.lippmann.state.frame);
  await page.getByRole("button", { name: "Play" }).click();
  await page.waitForFunction(() => window.lippmann.state.frame > 0, null, { timeout: 60000 });
  await page.getByRole("button", { name: "Pause" }).click();
  assert.ok((await shown()) < 6);
});

test("the address holds the state", async () => {
  const page = await open(`${address}#frame=4&eye=10,0,192&stereo=anaglyph&nonsense=1&exposure=abc`);
  const state = await page.evaluate(() => window.lippmann.state);
  assert.deepEqual([state.frame, state.eye, state.stereo, state.exposure], [4, [10, 0, 192], "anaglyph", 0]);
  await set(page, { frame: 2 });
  await page.waitForFunction(() => location.hash.includes("frame=2"));
});
