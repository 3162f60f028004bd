// A large light field appears at once as a preview, and one line shows the progress.
import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { closeAfterEach, drawn, eyeCodes, inFolder, lippmann, open, sheet, view } from "./support.mjs";

closeAfterEach();
lippmann("render", "room", "--optics", "multiview", "--views", "4x2", "--size", "1440x1440", "--frames", "0", "--layout", "quilt", "-o", "large", "-q");
sheet();

/** Opens a page that is not reused, so that its requests can be delayed. */
const blank = () => open("about:blank", { ready: false, script: "0" });

/** Delays requests whose addresses match a pattern. Returns the function that releases them. */
async function held(page, pattern) {
  let release;
  const released = new Promise((resolve) => (release = resolve));
  await page.route(pattern, async (route) => {
    await released;
    await route.continue();
  });
  return release;
}

test("a preview precedes the full picture", async () => {
  const page = await blank();
  const release = await held(page, "**/0/views/0");
  const preview = page.waitForResponse(/\/0\/preview\/0$/);
  await page.goto(await view("large"));
  await page.waitForSelector('#stage[data-preview="true"]');
  await page.locator("#progress", { hasText: "Loading" }).waitFor();
  const small = await page.evaluate(() => document.querySelector("canvas").toDataURL());
  await page.evaluate(() => window.lippmann.set({ eye: [20, 0, window.lippmann.fields[0].eye_mm[2]] }));
  await page.waitForFunction((small) => document.querySelector("canvas").toDataURL() !== small, small);
  assert.equal(await page.getAttribute("#stage", "data-drawn"), "false");
  // The browser may have dropped the body of the first response, so the preview is requested again.
  const bytes = (await (await page.request.get((await preview).url())).body()).length;
  assert.ok(bytes > 1000 && bytes < 64e3, `${bytes} bytes`);
  const all = await page.evaluate(() => ["navigation", "resource"].flatMap((type) => performance.getEntriesByType(type)).reduce((sum, one) => sum + one.encodedBodySize, 0));
  console.log(`first picture: ${all} bytes, ${bytes} of them for the preview`);
  assert.ok(all > bytes && all <= 100e3, `${all} bytes`);
  release();
  await drawn(page);
  assert.equal(await page.getAttribute("#stage", "data-preview"), "false");
  await page.locator("#progress").waitFor({ state: "hidden" });
});

test("loading frames show progress", async () => {
  const page = await blank();
  const release = await held(page, /0\/views\/[1-9]/);
  await page.goto(await view("sheet"));
  await drawn(page);
  assert.equal(await page.getAttribute("#stage", "data-outdated"), "false");
  await page.evaluate(() => window.lippmann.set({ frame: 3 }));
  await page.waitForSelector('#stage[data-outdated="true"]');
  await page.locator("#progress", { hasText: "Loading" }).waitFor();
  release();
  await page.waitForSelector('#stage[data-outdated="false"][data-frame="3"]');
});

test("a saved page works without the server", async () => {
  const page = await open(await view("large"));
  const [saved] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Save page" }).click()]);
  assert.equal(saved.suggestedFilename(), "large.html");
  await saved.saveAs(inFolder("large.html"));
  const alone = await open(pathToFileURL(inFolder("large.html")).href);
  assert.deepEqual(await eyeCodes(alone, 64), await eyeCodes(page, 64));
  assert.equal(await alone.getByRole("button", { name: "Save page" }).count(), 0);
  lippmann("view", "large", "--save", "same.html");
  assert.equal(statSync(inFolder("same.html")).size, statSync(inFolder("large.html")).size);
  assert.ok(readFileSync(inFolder("same.html")).equals(readFileSync(inFolder("large.html"))));
});
