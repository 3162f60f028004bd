// Tests the page while a scene is set up. Panels of few lenses look as in a finished render, and the main controls need
// little scrolling.
import assert from "node:assert/strict";
import { test } from "node:test";
import { besidePanel } from "./panel.mjs";
import { closeAfterEach, lippmann, open, view } from "./support.mjs";

closeAfterEach();

const room = ["room", "--optics", "lenticular", "--size", "256x256", "--lenses", "32", "--frames", "0"];
const address = await view(...room);
const atRest = (page) => page.waitForSelector('#stage[data-rest="true"][data-drawn="true"]', { timeout: 90000 });

/** The controls that set a scene up, in the order of the page. */
const kControls = ["Dragging the picture", "Turn", "Raise", "Zoom", "Display plane", "Fit the depth to the display", "Display", "Optics", "Viewing cone", "Shading", "Samples a pixel", "Surroundings"];
const kRender = ["Render all frames", "Render this frame"];

test("few lenses show their panel pixel for pixel", async () => {
  lippmann("render", ...room, "-o", "rendered", "-q");
  const page = await open(address, { width: 1400, height: 900 });
  await atRest(page);
  assert.deepEqual(await besidePanel(page, "rendered"), { scale: 2, most: 0, isBelow: false });
});

/** Returns the lowest edge of the controls in the list's own coordinates, and the height of the list's visible part. */
const reach = (page) =>
  page.evaluate((names) => {
    const list = document.querySelector(".groups");
    const from = list.getBoundingClientRect().top - list.scrollTop;
    const label = (name) => [...list.querySelectorAll("label")].find((one) => one.textContent === name);
    return { lowest: Math.max(...names.map((name) => label(name).closest(".row").getBoundingClientRect().bottom - from)), seen: list.clientHeight };
  }, kControls);

async function expectRenderButtons(page) {
  for (const name of kRender) await page.getByRole("button", { name }).click({ trial: true, timeout: 1000 });
}

test("a desktop shows the controls without scrolling", async () => {
  const page = await open(address, { width: 1400, height: 900 });
  const { lowest, seen } = await reach(page);
  assert.ok(lowest <= seen, `the controls end at ${lowest} of ${seen} pixels`);
  await expectRenderButtons(page);
});

// A swipe scrolls by the height of the list.
test("a phone reaches the controls in two swipes", async () => {
  for (const [width, height] of [[390, 844], [844, 390]]) {
    const page = await open(address, { width, height, hasTouch: true });
    await expectRenderButtons(page);
    const toggle = page.getByRole("button", { name: "Controls" });
    if (await toggle.isVisible()) await toggle.click();
    const { lowest, seen } = await reach(page);
    assert.ok(lowest <= 3 * seen, `${width}x${height}: the controls end at ${lowest} pixels; three screens have ${3 * seen}`);
    await expectRenderButtons(page);
  }
});
