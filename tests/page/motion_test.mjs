// The eye sways until the user touches the page, and follows the mouse. Mouse and fingers zoom and pan.
import assert from "node:assert/strict";
import { test } from "node:test";
import { closeAfterEach, open, sheet, view } from "./support.mjs";

closeAfterEach();
sheet();
const address = await view("sheet");

const canvas = (page) => page.evaluate(() => document.querySelector("canvas").toDataURL());
const state = (page) => page.evaluate(() => window.lippmann.state);
const hint = (page) => page.locator("#hint").textContent();
const changed = (page, before) => page.waitForFunction((before) => document.querySelector("canvas").toDataURL() !== before, before);
const frames = (page, count) => page.evaluate(async (count) => {
  for (let i = 0; i < count; i++) await new Promise(requestAnimationFrame);
}, count);

async function middle(page) {
  const box = await page.locator("#canvas").boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
}

test("the eye sways until the picture is touched", async () => {
  const page = await open(address, { sways: true });
  const { eye } = await state(page);
  assert.equal(await hint(page), "Drag to look around");
  await changed(page, await canvas(page));
  assert.deepEqual((await state(page)).eye, eye);
  await page.mouse.click(...(await middle(page)));
  assert.equal(await hint(page), "");
  const touched = await canvas(page);
  await frames(page, 30);
  assert.ok((await canvas(page)) === touched, "it keeps swaying");
});

test("the mouse moves the eye before a drag", async () => {
  const page = await open(address, { sways: true });
  const [x, y] = await middle(page);
  await page.mouse.move(x + 100, y);
  await changed(page, await canvas(page));
  assert.ok(Math.abs((await state(page)).eye[0]) < 1e-9);
  await frames(page, 60);
  await page.mouse.down();
  await page.mouse.up();
  assert.ok((await state(page)).eye[0] > 5, `${(await state(page)).eye}`);
});

test("reduced motion disables the sway", async () => {
  const page = await open(address);
  const before = await canvas(page);
  await page.mouse.move(...(await middle(page)));
  await frames(page, 90);
  assert.ok((await canvas(page)) === before, "it moved");
});

test("wheel, right button and 0 zoom and pan", async () => {
  const page = await open(address);
  const before = await canvas(page);
  const [x, y] = await middle(page);
  await page.mouse.move(x + 60, y + 40);
  await page.mouse.wheel(0, -200);
  await page.waitForFunction(() => window.lippmann.state.magnify > 1.3);
  const zoomed = await state(page);
  assert.ok(zoomed.pan[0] < 0 && zoomed.pan[1] < 0, `what is at the pointer stays there: ${zoomed.pan}`);
  assert.deepEqual(zoomed.eye, await page.evaluate(() => window.lippmann.fields[0].eye_mm));
  await page.mouse.down({ button: "right" });
  await page.mouse.move(x + 100, y + 40, { steps: 4 });
  await page.mouse.up({ button: "right" });
  assert.ok((await state(page)).pan[0] > zoomed.pan[0] + 0.05);
  await page.keyboard.press("1");
  assert.equal((await state(page)).magnify, 1, "a sheet of few lenses is fitted at true size");
  await page.keyboard.press("0");
  await page.waitForFunction((before) => document.querySelector("canvas").toDataURL() === before, before);
});

test("two fingers zoom", async () => {
  const page = await open(address, { hasTouch: true });
  const [x, y] = await middle(page);
  const browser = await page.context().newCDPSession(page);
  const touch = (type, ...places) => browser.send("Input.dispatchTouchEvent", { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
  await touch("touchStart", [x - 30, y], [x + 30, y]);
  await touch("touchMove", [x - 60, y], [x + 60, y]);
  await touch("touchEnd");
  const { magnify } = await state(page);
  assert.ok(Math.abs(magnify - 2) < 0.2, `${magnify}`);
});

test("the question mark toggles the list of keys", async () => {
  const page = await open(address);
  await page.keyboard.press("?");
  await page.getByRole("dialog", { name: "Mouse and keys" }).waitFor();
  await page.keyboard.press("?");
  await page.getByRole("dialog", { name: "Mouse and keys" }).waitFor({ state: "hidden" });
  await page.getByRole("button", { name: "Mouse and keys" }).click();
  await page.keyboard.press("Escape");
  await page.getByRole("dialog", { name: "Mouse and keys" }).waitFor({ state: "hidden" });
});
