// The page of a running render shows finished frames, and stops and resumes the render. Unfinished frames are grey.
import assert from "node:assert/strict";
import { once } from "node:events";
import { existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { begin, expectComplaints, eyeCodes, inFolder, lippmann, open, set, view } from "./support.mjs";

const kFrames = 8;
const job = (folder, spp = "24") => ["render", "room", "--optics", "multiview", "--views", "4x1", "--size", "256x64", "--layout", "quilt", "--aov", "depth", "--integrator", "path", "--spp", spp, "--reuse", "none", "--frames", `0-${kFrames - 1}`, "-o", folder, "-q"];
const frames = (folder) => readdirSync(inFolder(folder)).filter((name) => /^(frame|aov)_/.test(name)).sort();
const pictures = (folder) => frames(folder).filter((name) => name.endsWith(".png"));
const isStopped = (page) => page.waitForFunction(() => window.lippmann?.run.state === "stopped", null, { timeout: 60000 });

async function until(holds) {
  while (!holds()) await new Promise((resolve) => setTimeout(resolve, 50));
}

/** Halts the render after `count` frames, so that the page's state stays the same during a test. */
async function haltedAfter(count, process, folder) {
  process.kill("SIGCONT");
  await until(() => existsSync(inFolder(folder)) && pictures(folder).length >= count);
  process.kill("SIGSTOP");
}

const render = begin(...job("run"));
await haltedAfter(1, render, "run");
const address = await view("run");
const page = await open(address, { ready: false });
page.setDefaultTimeout(90000);
await page.waitForFunction(() => window.lippmann);

test("finished frames appear, others are missing", async () => {
  await page.evaluate(() => (window.isTheSamePage = true));
  assert.ok((await page.evaluate(() => window.lippmann.run.done)) <= pictures("run").length);
  await haltedAfter(4, render, "run");
  await page.waitForFunction(() => window.lippmann.run.done >= 3 && window.lippmann.run.seconds_left !== null);
  assert.match(await page.locator("#facts").textContent(), /Rendering: \d+ of 8 frames, about \d+ (s|min) left/);
  const { done, frames } = await page.evaluate(() => window.lippmann.run);
  assert.equal(frames, kFrames);
  await page.evaluate(() => window.lippmann.set({ frame: 1 }));
  await page.waitForSelector('#stage[data-drawn="true"][data-frame="1"]');
  await page.waitForFunction(() => document.querySelector("#notice").textContent === "");
  await page.evaluate(() => window.lippmann.set({ frame: 7 }));
  await page.waitForFunction(() => /Frame 0007 is not rendered yet/.test(document.querySelector("#notice").textContent));
  await page.getByRole("button", { name: "Next frame" }).click();
  assert.equal(await page.evaluate(() => window.lippmann.state.frame), 0);
  await page.getByRole("button", { name: "Previous frame" }).click();
  const last = await page.evaluate(() => window.lippmann.state.frame);
  assert.ok(last >= done - 1 && last < kFrames - 1, `${last} of ${done}`);
  assert.match(await page.locator(".marks").getAttribute("aria-label"), /of 8 frames are rendered/);
});

test("the page of finished frames can be saved", async () => {
  const [made] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Save page" }).click()]);
  await made.saveAs(inFolder("unfinished.html"));
  const saved = await open(`file://${inFolder("unfinished.html")}`);
  const count = await saved.evaluate(() => window.lippmann.fields[0].frames.length);
  assert.ok(count >= 3 && count < kFrames, `${count} frames`);
});

test("requests without the token have no effect", async () => {
  const order = (address, headers) => fetch(`${address}run/stop`, { method: "POST", body: "{}", headers }).then(({ status }) => status);
  const origin = new URL(address).origin;
  assert.notEqual(new URL(address).pathname, "/");
  assert.equal(await order(`${origin}/`, { Origin: origin }), 403);
  assert.equal(await order(address, {}), 403);
  assert.equal(await order(address, { Origin: "http://evil.example" }), 403);
  assert.equal(await page.evaluate(() => window.lippmann.run.state), "running");
});

test("the keyboard stops a render like Ctrl-C", async () => {
  await page.getByRole("button", { name: "Stop" }).focus();
  const ended = once(render, "exit");
  await Promise.all([page.waitForResponse(/\/run\/stop$/), page.keyboard.press("Enter")]);
  render.kill("SIGCONT");
  assert.deepEqual(await ended, [130, null]);
  await isStopped(page);
  const done = pictures("run").length;
  assert.ok(done >= 2 && done < kFrames, `${done} frames`);
  assert.equal(JSON.parse(readFileSync(inFolder("run/report.json"), "utf8")).interrupted, true);
  assert.match(await page.locator("#facts").textContent(), new RegExp(`Stopped: ${done} of 8 frames`));
  await page.waitForFunction(() => document.activeElement.textContent === "Resume");
});

test("a resumed render has the same bytes", async () => {
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => window.lippmann?.run.state === "finished");
  assert.equal(await page.evaluate(() => window.isTheSamePage), true);
  lippmann(...job("undisturbed"));
  assert.deepEqual(frames("run"), frames("undisturbed"));
  for (const name of frames("run")) assert.ok(readFileSync(inFolder(`run/${name}`)).equals(readFileSync(inFolder(`undisturbed/${name}`))), name);
  lippmann("check", "run");
  await page.evaluate(() => window.lippmann.set({ frame: 7 }));
  await page.waitForSelector('#stage[data-drawn="true"][data-frame="7"]');
  await page.waitForFunction(() => document.querySelector("#notice").textContent === "");
  const other = await open(await view("undisturbed"));
  const codes = (one) => eyeCodes(one, 64);
  await other.evaluate(() => window.lippmann.set({ frame: 7 }));
  assert.deepEqual(await codes(page), await codes(other));
});

test("a killed render is shown as stopped", async () => {
  expectComplaints(/status of 422/);
  const killed = begin(...job("killed"));
  await haltedAfter(1, killed, "killed");
  await page.goto(await view("killed"));
  await page.waitForFunction(() => window.lippmann?.run.state === "running");
  killed.kill("SIGKILL");
  await isStopped(page);
  await page.waitForFunction(() => /Stopped: \d of 8 frames/.test(document.querySelector("#facts").textContent));
  writeFileSync(inFolder("killed/job.toml"), 'scene = "teapot"\n');
  await page.getByRole("button", { name: "Resume" }).click();
  await page.waitForFunction(() => /job.toml: was changed after the render wrote it/.test(document.querySelector("#notice").textContent));
  assert.equal(await page.evaluate(() => window.lippmann.run.state), "stopped");
});

/** Codes of the middle of the canvas. */
const middle = () => page.evaluate(() => {
  const gl = document.querySelector("canvas").getContext("webgl2");
  const codes = new Uint8Array(4);
  gl.readPixels(gl.drawingBufferWidth >> 1, gl.drawingBufferHeight >> 1, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, codes);
  return [...codes.slice(0, 3)];
});

test("an unfinished frame is grey, without a hint", async (t) => {
  const early = begin(...job("early", "128"));
  t.after(() => early.kill("SIGKILL"));
  await until(() => existsSync(inFolder("early/report.json")));
  early.kill("SIGSTOP");
  assert.deepEqual(pictures("early"), []);
  await page.goto(await view("early"));
  await page.waitForSelector('#stage[data-drawn="true"]');
  const [hint, bar] = [page.locator("#hint"), page.getByRole("progressbar", { name: "Render" })];
  for (const theme of ["light", "dark"]) {
    await set(page, { theme });
    const [red, green, blue] = await middle();
    assert.ok(red >= 40 && red <= 215 && Math.abs(red - green) < 4 && Math.abs(red - blue) < 4, `${theme}: ${[red, green, blue]}`);
  }
  assert.equal(await hint.isVisible(), false);
  assert.equal(await bar.getAttribute("value"), null);
  await haltedAfter(2, early, "early");
  await page.waitForSelector('#stage[data-drawn="true"][data-pending="false"]');
  assert.equal(await hint.isVisible(), true);
  assert.notEqual(await bar.getAttribute("value"), null);
});
