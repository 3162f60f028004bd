// Setting up a scene: dragging the plane renders again, the saved job renders the same picture, and a render can be
// cancelled.
import assert from "node:assert/strict";
import { existsSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { expectComplaints, eyeCodes, inFolder, lippmann, open, view } from "./support.mjs";

const page = await open(await view("room", "--optics", "multiview", "--views", "4x1", "--size", "256x64", "--frames", "0-3"), { width: 820, height: 420 });
page.setDefaultTimeout(90000);
const atRest = () => page.waitForSelector('#stage[data-rest="true"][data-drawn="true"]');
const scene = () => page.evaluate(() => window.lippmann.scene);
const codes = (one) => eyeCodes(one, 64);
const notice = (pattern) => page.waitForFunction((pattern) => new RegExp(pattern).test(document.querySelector("#notice").textContent), pattern);

async function renderedAfter(version) {
  await page.waitForFunction((version) => window.lippmann.scene.version > version, version);
  await atRest();
}

async function dragBy(x, y) {
  const box = await page.locator("#canvas").boundingBox();
  const [left, top] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(left, top);
  await page.mouse.down();
  await page.mouse.move(left + x, top + y, { steps: 5 });
  await page.mouse.up();
}

test("dragging moves the plane and the camera", async () => {
  await atRest();
  const before = await scene();
  await page.evaluate(() => window.lippmann.set({ drag: "plane", eye: [25, 0, window.lippmann.fields[0].eye_mm[2]] }));
  const seen = await codes(page);
  await dragBy(0, -90);
  await renderedAfter(before.version);
  const after = await scene();
  assert.ok(after.plane.distance > before.plane.distance + 0.1, `${before.plane.distance}, ${after.plane.distance}`);
  assert.notDeepEqual(await codes(page), seen);
  await page.getByLabel("Dragging the picture").selectOption("turn");
  await dragBy(-60, 30);
  await renderedAfter(after.version);
  const [yaw, pitch] = (await scene()).settings.orbit.split(",").map(Number);
  assert.ok(yaw > 5 && pitch > 2, `${yaw}, ${pitch}`);
  assert.match(await page.locator("#facts").textContent(), /as rendered/);
});

test("a click moves the plane to a point", async () => {
  const before = await scene();
  await page.getByLabel("Dragging the picture").selectOption("plane");
  await page.locator("#canvas").click({ position: { x: 230, y: 190 } });
  await renderedAfter(before.version);
  assert.notEqual((await scene()).plane.distance, before.plane.distance);
  await page.evaluate(() => window.lippmann.set({ drag: "eye" }));
});

test("the saved job renders the same codes", async () => {
  await page.getByRole("slider", { name: "Frame" }).fill("2");
  await page.waitForSelector('#stage[data-frame="2"][data-rest="true"][data-drawn="true"]');
  await page.getByRole("button", { name: "Save job" }).click();
  await page.waitForFunction(() => window.lippmann.scene.saved === "room.toml");
  lippmann("render", "room.toml", "--frames", "2", "-o", "again", "-q");
  const again = await open(await view("again"), { width: 820, height: 420 });
  const eye = await page.evaluate(() => window.lippmann.state.eye);
  await again.evaluate((eye) => window.lippmann.set({ eye, between: "blend" }), eye);
  await page.evaluate(() => window.lippmann.set({ between: "blend" }));
  assert.deepEqual(await codes(page), await codes(again));
  await again.context().close();
});

test("outdated pictures are marked", async () => {
  const facts = () => page.locator("#facts").textContent();
  const outdated = () => page.locator("#stage").getAttribute("data-outdated");
  assert.equal(await outdated(), "false");
  let release;
  const released = new Promise((resolve) => (release = resolve));
  await page.route("**/live/views/*", async (route) => {
    await released;
    await route.continue();
  });
  await page.evaluate(() => window.lippmann.setUp({ zoom: "0.1" }));
  await page.waitForSelector('#stage[data-outdated="true"]');
  await page.waitForFunction(() => window.lippmann.scene.settings.zoom === "0.1");
  assert.match(await facts(), /with the previous settings/);
  assert.equal(await outdated(), "true");
  release();
  await page.waitForSelector('#stage[data-outdated="false"]');
  await page.evaluate(() => window.lippmann.setUp({ zoom: null }));
  await atRest();
  assert.doesNotMatch(await facts(), /with the previous settings/);
});

test("invalid settings give a message", async () => {
  expectComplaints(/status of 422/);
  await page.evaluate(() => window.lippmann.setUp({ zoom: "-1" }));
  await notice("zoom");
  const { version } = await scene();
  await page.evaluate(() => window.lippmann.setUp({ focus: "nobody" }));
  await notice("focus");
  await page.getByRole("button", { name: "Save job" }).click();
  await notice("settings: .*nobody");
  await page.evaluate(() => window.lippmann.setUp({ focus: null }));
  await renderedAfter(version + 1);
  await page.waitForFunction(() => !/nobody/.test(document.querySelector("#notice").textContent));
});

test("a render shows progress and can be cancelled", async () => {
  const save = page.getByRole("button", { name: "Save page" });
  assert.match(await save.getAttribute("title"), /nothing to save until a render has finished/);
  await save.click({ force: true });
  await notice("nothing to save");
  await page.getByRole("button", { name: "Render this frame" }).click();
  await page.waitForFunction(() => window.lippmann.scene.render?.state === "finished");
  assert.equal(await save.getAttribute("aria-disabled"), "false");
  const [made] = await Promise.all([page.waitForEvent("download"), save.click()]);
  assert.equal(made.suggestedFilename(), "room.html");
  assert.ok(existsSync(inFolder("out/room/frame_0002.png")));
  await atRest();
  // 512 samples make the render so slow that it can be cancelled before it ends.
  await page.evaluate(() => window.lippmann.setUp({ integrator: "path", spp: "512" }));
  await page.waitForFunction(() => window.lippmann.scene.settings.spp === "512");
  await page.getByRole("button", { name: "Render all frames" }).click();
  await page.getByRole("progressbar", { name: "Render" }).waitFor();
  await page.getByRole("button", { name: "Cancel" }).click();
  await page.waitForFunction(() => window.lippmann.scene.render.state === "stopped");
  await page.getByText(/Stopped after 0 of 4 frames: out.room-2/).waitFor();
  await page.evaluate(() => window.lippmann.setUp({ integrator: null, spp: null }));
  await atRest();
});

// With a view cone of 2 degrees, the whole room is sharp (green); with 90 degrees, most of it is blurred (red).
test("the depth budget tints the picture", async () => {
  const excess = () => page.evaluate(async () => (await window.lippmann.picture(64, 64)).reduce((sum, code, i) => sum + (i % 4 === 1 ? 2 * code : i % 4 === 3 ? 0 : -code), 0));
  for (const [angle, sign] of [["2", 1], ["90", -1]]) {
    const { version } = await scene();
    await page.evaluate((angle) => window.lippmann.setUp({ "view-angle": angle, "fit-depth": "false" }), angle);
    await renderedAfter(version);
    const without = await excess();
    await page.getByLabel("Show the depth budget").check();
    const by = (await excess()) - without;
    assert.ok(sign * by > 64 * 64 * 20, `${angle} degrees: greener by ${by}`);
    await page.getByLabel("Show the depth budget").uncheck();
  }
});

test("the keyboard reaches controls and moves the plane", async () => {
  const wanted = await page.evaluate(() => [...document.querySelectorAll("button, input, select, canvas, summary")].filter((one) => one.checkVisibility()).length);
  await page.locator("#canvas").focus();
  const reached = new Set();
  for (let i = 0; i < wanted + 2; i++) {
    const [name, index] = await page.evaluate(() => {
      const one = document.activeElement;
      return [one === document.body ? "none" : one.labels?.[0]?.textContent || one.getAttribute("aria-label") || one.textContent || "", [...document.querySelectorAll("*")].indexOf(one)];
    });
    assert.notEqual(name.trim(), "");
    if (name !== "none") reached.add(index);
    await page.keyboard.press("Tab");
  }
  assert.equal(reached.size, wanted);
  const before = await scene();
  await page.getByRole("slider", { name: "Display plane" }).focus();
  await page.keyboard.press("ArrowRight");
  await renderedAfter(before.version);
  assert.ok((await scene()).plane.distance > before.plane.distance);
});

// A tilted square is in front of an infinitely distant background. From any eye, each row shows the square as one
// connected part.
test("edges before a far background stay in place", async () => {
  writeFileSync(inFolder("sheet.obj"), "v 0 1 0\nv 1 0.1 0\nv 0 -1 0\nv -1 -0.1 0\nf 1 4 3 2\n");
  const page = await open(await view("sheet.obj", "--spp", "8", "--environment", "#ffffff", "--size", "512x128"));
  await page.waitForSelector('#stage[data-rest="true"][data-drawn="true"]', { timeout: 90000 });
  for (const x of [0, 4, 11]) {
    const pieces = await page.evaluate(async (x) => {
      const { eye_mm: eye } = window.lippmann.fields[0], side = 256;
      window.lippmann.set({ eye: [eye[0] + x, eye[1], eye[2]] });
      const codes = await window.lippmann.picture(side, side);
      const isSheet = (x, y) => Math.abs(codes[4 * (y * side + x)] - codes[0]) > 4;
      return [...Array(side).keys()].map((y) => [...Array(side).keys()].filter((x) => isSheet(x, y) && !(x > 0 && isSheet(x - 1, y))).length);
    }, x);
    assert.ok(pieces.filter((count) => count === 1).length > 50);
    assert.deepEqual(pieces.filter((count) => count > 1), [], `from ${x} mm`);
  }
});
