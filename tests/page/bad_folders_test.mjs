// Damaged or missing data give a message, and the page shows the rest.
import assert from "node:assert/strict";
import { cpSync, mkdirSync, rmSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { closeAfterEach, expectComplaints, inFolder, lippmann, open, set, sheet, view } from "./support.mjs";

closeAfterEach();

sheet();
lippmann("view", "sheet", "--save", "saved");

/** Copies the saved page, damages the copy by `spoil`, and returns the error that it shows. */
async function failureOf(name, spoil) {
  cpSync(inFolder("saved"), inFolder(name), { recursive: true });
  spoil((file, text) => writeFileSync(inFolder(`${name}/${file}`), text));
  const page = await open(pathToFileURL(inFolder(`${name}/index.html`)).href, { ready: false });
  await page.locator("#failure").waitFor();
  return page.locator("#failure").textContent();
}

test("damaged descriptions are refused with a message", async () => {
  expectComplaints(/ERR_FILE_NOT_FOUND/, /Unexpected identifier/);
  assert.match(await failureOf("no-fields", () => rmSync(inFolder("no-fields/fields.js"))), /fields\.js is missing/);
  assert.match(await failureOf("no-script", (write) => write("fields.js", "no script")), /fields\.js is damaged/);
  assert.match(await failureOf("empty", (write) => write("fields.js", 'lippmann_fields({"fields":[]})')), /lists no light field/);
  assert.match(await failureOf("numbers", (write) => write("fields.js", 'lippmann_fields({"fields":[{"view_size":[1,-1]}]})')), /it has no size of views/);
  assert.match(await failureOf("null", (write) => write("fields.js", "lippmann_fields(null)")), /lists no light field/);
});

/** Returns whether the page stops drawing: within 600 frames of the screen, 30 frames in a row show no new picture. */
const settles = (page) =>
  page.evaluate(async () => {
    let quiet = 0;
    new MutationObserver(() => (quiet = 0)).observe(document.getElementById("stage"), { attributes: true, attributeFilter: ["data-divisor"] });
    for (let i = 0; i < 600 && quiet < 30; i++, quiet++) await new Promise(requestAnimationFrame);
    return quiet >= 30;
  });

test("a damaged frame is named, others shown", async () => {
  expectComplaints(/status of 422/);
  cpSync(inFolder("sheet"), inFolder("damaged"), { recursive: true });
  const page = await open(await view("damaged"));
  writeFileSync(inFolder("damaged/frame_0003.png"), "no picture");
  const asked = [];
  const fresh = await open(await view("damaged"), { onRequest: (url) => asked.push(url) });
  await fresh.evaluate(() => window.lippmann.set({ frame: 3 }));
  await fresh.waitForFunction(() => document.querySelector("#notice").textContent.includes("frame_0003.png"));
  await set(fresh, { frame: 5 });
  await fresh.waitForFunction(() => document.querySelector("#notice").textContent === "");
  assert.ok(await settles(fresh), "it keeps drawing");
  assert.ok(asked.filter((url) => url.endsWith("/views/3")).length <= 2, "it keeps requesting the frame");
  void page;
});

test("pictures of the wrong size are refused", async () => {
  cpSync(inFolder("saved"), inFolder("other-size"), { recursive: true });
  const { readFileSync } = await import("node:fs");
  const fields = readFileSync(inFolder("other-size/fields.js"), "utf8");
  writeFileSync(inFolder("other-size/fields.js"), fields.replace('"view_size":[32,256]', '"view_size":[32,128]'));
  const page = await open(pathToFileURL(inFolder("other-size/index.html")).href, { ready: false });
  await page.waitForFunction(() => /has \d+x\d+ pixels in place of \d+x\d+/.test(document.querySelector("#notice").textContent));
});

test("folders without a light field are refused", async () => {
  await assert.rejects(view("saved"), /contains no frames or views|are not named as frames|contains only one picture/);
  await assert.rejects(view("missing"), /there is no such file or folder/);
  const folders = { nothing: [], videos: ["a.mp4"], jobs: ["job.toml"], others: ["ein Bild.png"] };
  for (const [name, files] of Object.entries(folders)) {
    mkdirSync(inFolder(name));
    for (const file of files) writeFileSync(inFolder(`${name}/${file}`), "nothing");
  }
  await assert.rejects(view("nothing"), /nothing: is an empty folder/);
  await assert.rejects(view("videos"), /only videos \(a\.mp4\), no frames or views/);
  await assert.rejects(view("videos/a.mp4"), /only `lippmann convert` reads views from a video/);
  await assert.rejects(view("jobs"), /`lippmann render jobs\/job\.toml` first/);
  await assert.rejects(view("others"), /contains only one picture, ein Bild\.png/);
  await assert.rejects(view("others/ein Bild.png"), /the format of others\/ein Bild\.png is unknown/);
  writeFileSync(inFolder("text.txt"), "no picture");
  await assert.rejects(view("text.txt"), /is not a picture/);
  writeFileSync(inFolder("wrong.toml"), 'scene = "room"\nzom = 2\n');
  await assert.rejects(view("wrong.toml"), /wrong\.toml:2: there is no key 'zom', did you mean 'zoom'/);
});

test("spaces, umlauts and views of one pixel work", async () => {
  cpSync(inFolder("sheet"), inFolder("B\u00fchne mit Licht"), { recursive: true });
  const page = await open(await view("B\u00fchne mit Licht"));
  assert.equal(await page.locator("#title").textContent(), "B\u00fchne mit Licht");
  const pixel = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGOIqtAAAAIqAPt5WLeaAAAAAElFTkSuQmCC";
  writeFileSync(inFolder("tiny_qs1x1a1.png"), Buffer.from(pixel, "base64"));
  const tiny = await open(await view("tiny_qs1x1a1.png"));
  assert.match(await tiny.locator("#facts").textContent(), /1 view of 1\u00d71/);
  const codes = await tiny.evaluate(async () => [...(await window.lippmann.picture(1, 1))]);
  assert.equal(codes.length, 4);
});
