// The keyboard reaches all controls, screen readers know their names, and phones need no horizontal scrolling.
import assert from "node:assert/strict";
import { cpSync } from "node:fs";
import { test } from "node:test";
import { closeAfterEach, grid, inFolder, lippmann, only, open, set, sheet, view } from "./support.mjs";

closeAfterEach();

sheet();
grid();
const address = await view("sheet");

test("Tab reaches every control by name", async () => {
  const page = await open(await view("grid", "grid"));
  await set(page, { stereo: "anaglyph", aperture: 0.5, line: 0.5 });
  const wanted = await page.evaluate(
    () => [...document.querySelectorAll("button, input, select, canvas, summary")].filter((one) => one.checkVisibility()).length,
  );
  const reached = new Set();
  for (let i = 0; i < wanted + 2; i++) {
    await page.keyboard.press("Tab");
    const name = await page.evaluate(() => {
      const one = document.activeElement;
      return one === document.body ? null : (one.labels?.[0]?.textContent || one.getAttribute("aria-label") || one.textContent || "");
    });
    if (name === null) continue;
    assert.notEqual(name.trim(), "");
    reached.add(await page.evaluate(() => [...document.querySelectorAll("*")].indexOf(document.activeElement)));
  }
  assert.equal(reached.size, wanted);
});

test("arrow keys and Home move the eye", async () => {
  const page = await open(address);
  await page.locator("#canvas").focus();
  const eye = () => page.evaluate(() => window.lippmann.state.eye[0]);
  await page.keyboard.press("ArrowRight");
  assert.ok((await eye()) > 1);
  for (let i = 0; i < 25; i++) await page.keyboard.press("ArrowRight");
  const end = await eye();
  await page.keyboard.press("ArrowRight");
  assert.equal(await eye(), end);
  const half = await page.evaluate(() => 4 * window.lippmann.fields[0].across.step * window.lippmann.fields[0].eye_mm[2]);
  assert.ok(end <= half && end > 0.999 * half, `almost four views on either side of the middle, ${half} mm: ${end}`);
  await page.keyboard.press("Home");
  assert.ok(Math.abs(await eye()) < 1e-6);
  for (const [key, changed] of [["a", { aperture: 0.5 }], ["p", { show: "panel" }], [".", { frame: 1 }], [",", { frame: 0 }]]) {
    await page.keyboard.press(key);
    const state = await page.evaluate(() => window.lippmann.state);
    for (const [name, value] of Object.entries(changed)) assert.equal(state[name], value, key);
  }
});

test("keys work wherever the focus is", async () => {
  const page = await open(address);
  const state = () => page.evaluate(() => window.lippmann.state);
  await page.keyboard.press("ArrowRight");
  const moved = (await state()).eye[0];
  assert.ok(moved > 1, `${moved}`);
  await page.getByRole("button", { name: "Next frame" }).click();
  await page.keyboard.press("ArrowRight");
  assert.ok((await state()).eye[0] > moved + 1);
  await page.keyboard.press(" ");
  await page.getByRole("button", { name: "Pause" }).waitFor();
  await page.keyboard.press(" ");
  await page.getByRole("button", { name: "Play" }).waitFor();
  await page.getByLabel("Brightness").focus();
  const { eye, exposure } = await state();
  await page.keyboard.press("ArrowRight");
  assert.deepEqual((await state()).eye, eye);
  assert.ok((await state()).exposure > exposure);
  await page.keyboard.press("a");
  assert.equal((await state()).aperture, 0.5);
  await page.getByLabel("Show", { exact: true }).focus();
  await page.keyboard.press("a");
  assert.equal((await state()).aperture, 0.5);
});

test("two fingers and pinches leave the eye", async () => {
  const page = await open(address, { hasTouch: true });
  const eye = () => page.evaluate(() => window.lippmann.state.eye);
  const before = await eye();
  const box = await page.locator("#canvas").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const browser = await page.context().newCDPSession(page);
  const touch = (type, ...places) => browser.send("Input.dispatchTouchEvent", { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
  await touch("touchStart", [x - 20, y]);
  await touch("touchMove", [x - 30, y]);
  await touch("touchStart", [x - 30, y], [x + 20, y]);
  for (const by of [10, 20, 30]) await touch("touchMove", [x - 30 - by, y - by], [x + 20 + by, y]);
  await touch("touchEnd");
  assert.deepEqual(await eye(), before);
  await page.mouse.move(x, y);
  await page.evaluate(([clientX, clientY]) => document.querySelector("#canvas").dispatchEvent(new WheelEvent("wheel", { deltaY: -40, ctrlKey: true, clientX, clientY, bubbles: true, cancelable: true })), [x, y]);
  assert.deepEqual(await eye(), before);
});

test("a phone shows the controls on request", async () => {
  const page = await open(address, { width: 390, height: 844 });
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  assert.equal(await page.locator("#controls").isVisible(), false);
  await page.getByRole("button", { name: "Controls" }).click();
  assert.equal(await page.getByLabel("Brightness").isVisible(), true);
  const canvas = await page.locator("#canvas").boundingBox();
  assert.ok(canvas.height > 200, `the picture keeps ${canvas.height} pixels`);
});

test("dragging moves the eye", async () => {
  const page = await open(address);
  const box = await page.locator("#canvas").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 80, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  const state = await page.evaluate(() => window.lippmann.state);
  assert.ok(state.eye[0] > 5, `${state.eye}`);
  assert.equal(state.aperture, 0, "a drag does not count as a click");
});

test("a phone shows the whole heading", async () => {
  lippmann("render", "room", "--optics", "multiview", "--views", "8x6", "--size", "128x96", "--frames", "0", "--layout", "quilt", "--aov", "depth", "-o", "made", "-q");
  cpSync(inFolder(`made/${only("made", /^frame.*png$/)}`), inFolder("a_quilt_with_a_long_name_qs8x6a1.333.png"));
  for (const one of ["made", "a_quilt_with_a_long_name_qs8x6a1.333.png"]) {
    const page = await open(await view(one), { width: 390, height: 844 });
    for (const id of ["title", "facts"]) {
      const [cut, right, text] = await page.evaluate((id) => {
        const part = document.getElementById(id), { right } = part.getBoundingClientRect();
        return [part.scrollHeight > part.clientHeight || part.scrollWidth > part.clientWidth, right, part.textContent];
      }, id);
      assert.equal(cut, false, `${id}: ${text}`);
      assert.ok(right <= (await page.locator("#corner").boundingBox()).x, `${id} is below the buttons`);
    }
    const [heading, canvas] = await Promise.all(["#heading", "#canvas"].map((id) => page.locator(id).boundingBox()));
    assert.ok(heading.y + heading.height <= canvas.y, "the heading covers the picture");
  }
});
