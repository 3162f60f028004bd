// Pictures that are dropped on the page or chosen in a dialog become views, in natural order of their names.
import assert from "node:assert/strict";
import { copyFileSync, mkdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { closeAfterEach, expectComplaints, eyeOfView, inFolder, lippmann, open, psnrBeside, set, view } from "./support.mjs";

closeAfterEach();

lippmann("render", "room", "--optics", "multiview", "--views", "7x1", "--size", "1120x120", "--frames", "0", "--layout", "views", "-o", "seven", "-q");

const dropped = (names) => names.map((name, i) => ({ name, base64: readFileSync(inFolder(`seven/frame_0000/view_00${i}.png`)).toString("base64") }));

const drop = (page, files) =>
  page.evaluate((files) => {
    const data = new DataTransfer();
    for (const { name, base64 } of files) data.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name, { type: "image/png" }));
    window.dispatchEvent(new DragEvent("drop", { dataTransfer: data, cancelable: true }));
  }, files);

test("dropped pictures become views in natural order", async () => {
  const page = await open(await view(), { ready: false });
  await page.getByRole("heading", { name: "Drop pictures here" }).waitFor();
  await drop(page, dropped(["p10.png", "p9.png", "p11.png"]));
  await page.waitForSelector('#stage[data-drawn="true"]');
  const [title, views] = await page.evaluate(() => [window.lippmann.fields[0].title, window.lippmann.fields[0].across.views]);
  assert.deepEqual([title, views], ["Pictures", 3]);
  await set(page, { eye: await eyeOfView(page, 0, 0) });
  const psnr = await psnrBeside(page, inFolder("seven/frame_0000/view_001.png"));
  assert.ok(psnr > 50, `the view from the left is p9: ${psnr} dB`);
  expectComplaints(/422/);
  await drop(page, dropped(["a.png", "b.svg"]));
  await page.locator("#notice", { hasText: "b.svg: is not a picture that can be read" }).waitFor();
  assert.equal(await page.evaluate(() => window.lippmann.fields[0].across.views), 3);
});

test("a chosen folder is shown under its name", async () => {
  const page = await open(await view(), { ready: false });
  mkdirSync(inFolder("photos"));
  for (let i = 0; i < 7; i++) copyFileSync(inFolder(`seven/frame_0000/view_00${i}.png`), inFolder(`photos/${i}.png`));
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), page.getByRole("button", { name: "Choose a folder" }).click()]);
  await chooser.setFiles(inFolder("photos"));
  await page.waitForSelector('#stage[data-drawn="true"]');
  assert.deepEqual(await page.evaluate(() => [window.lippmann.fields[0].title, window.lippmann.fields[0].across.views]), ["photos", 7]);
});

test("a light field's page explains dropping pictures", async () => {
  const page = await open(await view("seven"));
  await drop(page, dropped(["a.png", "b.png"]));
  await page.locator("#notice", { hasText: "start `lippmann view` without a name" }).waitFor();
});
