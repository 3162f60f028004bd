// The saved print equals that of `lippmann convert`. The view through the sheet matches `lippmann replay` with a PSNR
// of 40 dB.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { closeAfterEach, drawn, expectComplaints, eyeOfView, inFolder, lippmann, open, psnrBeside, replay, set, view } from "./support.mjs";

closeAfterEach();

const kLine = "lpi=10 dpi=97 paper=96x72mm";

async function setSheet(page) {
  for (const [name, value] of [["Lenses per inch", "10"], ["Dots per inch", "97"], ["Paper", "96x72mm"]]) {
    await page.getByLabel(name, { exact: true }).fill(value);
    await page.getByLabel(name, { exact: true }).press("Enter");
  }
  await page.getByLabel("Landscape").setChecked(false);
}

const shown = (page) => page.waitForSelector('#stage[data-print="shown"][data-drawn="true"]');
const see = async (page) => (await page.getByLabel("See through the sheet").check(), await shown(page));

const seven = () => lippmann("render", "room", "--optics", "multiview", "--views", "7x1", "--size", "1120x120", "--frames", "0", "--layout", "views", "--aov", "depth", "-o", "seven", "-q");

async function saved(page) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Save the print" }).click()]);
  return [download.suggestedFilename(), readFileSync(await download.path())];
}

test("saving matches convert", async () => {
  seven();
  const page = await open(await view("seven"));
  await setSheet(page);
  lippmann("convert", "seven/frame_0000", "plain.png", "--display", kLine);
  const [name, bytes] = await saved(page);
  assert.equal(name, "seven-print.png");
  assert.deepEqual(bytes, readFileSync(inFolder("plain.png")));
  await page.getByLabel("Views of another shape").selectOption("pad");
  const slider = page.getByRole("slider", { name: "Zero plane" });
  await slider.evaluate((input) => ((input.value = String(2 * Number(input.step))), input.dispatchEvent(new Event("change", { bubbles: true }))));
  await shown(page);
  const shift = await slider.inputValue();
  lippmann("convert", "seven/frame_0000", "shifted.png", "--display", kLine, "--fit", "pad", "--view-shift", shift);
  assert.deepEqual((await saved(page))[1], readFileSync(inFolder("shifted.png")));
  assert.notDeepEqual(readFileSync(inFolder("shifted.png")), bytes);
});

test("the view through the sheet matches replay", async () => {
  const page = await open(await view("seven"));
  await setSheet(page);
  const before = await page.evaluate(() => window.lippmann.fields[0].across.views);
  await see(page);
  const field = await page.evaluate(() => window.lippmann.fields[0]);
  const z = field.eye_mm[2];
  for (const view of [2, 5]) {
    const eye = [Math.tan(field.across.by === "angle" ? field.across.first + view * field.across.step : Math.atan(field.across.first + view * field.across.step)) * z, 0, z];
    await set(page, { eye });
    const psnr = await psnrBeside(page, replay("plain.png", `print-${view}`, "--display", kLine, "--eye", eye.join(",")));
    console.log(`view ${view} of ${field.across.views}: ${psnr.toFixed(1)} dB`);
    assert.ok(psnr >= 40, `${psnr} dB`);
  }
  await page.getByLabel("See through the sheet").uncheck();
  await page.waitForSelector('#stage[data-print=""][data-drawn="true"]');
  assert.equal(await page.evaluate(() => window.lippmann.fields[0].across.views), before);
});

/** Returns the mean difference, in codes, of two eyes' pictures around a point. */
const apart = (page, [x, y], eyes) =>
  page.evaluate(
    async ([x, y, eyes]) => {
      const [width, height, reach] = [400, 300, 24];
      const seen = [];
      for (const eye of eyes) (window.lippmann.set({ eye }), seen.push(await window.lippmann.picture(width, height)));
      let sum = 0;
      for (let v = Math.round(y * height) - reach; v < Math.round(y * height) + reach; v++)
        for (let u = Math.round(x * width) - reach; u < Math.round(x * width) + reach; u++)
          for (let c = 0; c < 3; c++) sum += Math.abs(seen[0][4 * (v * width + u) + c] - seen[1][4 * (v * width + u) + c]);
      return sum / (12 * reach * reach);
    },
    [x, y, eyes],
  );

test("a click moves the zero plane", async () => {
  const page = await open(await view("seven"));
  await setSheet(page);
  const field = await page.evaluate(() => window.lippmann.fields[0]);
  await see(page);
  const eyes = [await eyeOfView(page, 2, 0), await eyeOfView(page, 7, 0)];
  const place = [0.7, 0.34];
  const before = await apart(page, place, eyes);
  await page.getByRole("button", { name: "Zero plane on the picture" }).click();
  await page.waitForSelector('#stage[data-print=""][data-drawn="true"]');
  // The picture is in the middle of the canvas and has the aspect of the display's window.
  const box = await page.locator("#canvas").boundingBox();
  const aspect = field.window_mm.size[0] / field.window_mm.size[1];
  const width = Math.min(box.width, box.height * aspect);
  const [x, y] = [box.x + box.width / 2 + (place[0] - 0.5) * width, box.y + box.height / 2 + ((place[1] - 0.5) * width) / aspect];
  await page.mouse.move(x, y);
  await page.locator("#values", { hasText: /z .* mm/ }).waitFor();
  const z = Number((await page.locator("#values").textContent()).match(/z (\S+) mm/)[1].replace("\u2212", "-"));
  await page.mouse.click(x, y);
  await shown(page);
  const shift = Number(await page.getByRole("slider", { name: "Zero plane" }).inputValue());
  const slope = (view) => (field.across.by === "angle" ? Math.tan : (x) => x)(field.across.first + view * field.across.step);
  const distance = field.eye_mm[2];
  const wanted = (((-z * distance) / (distance - z)) * (slope(6) - slope(0)) * field.view_size[0]) / 6 / field.window_mm.size[0];
  // Shifting the views crops them to their common part, which enlarges the picture.
  const scale = field.view_size[0] / (field.view_size[0] - 6 * Math.abs(shift));
  const after = await apart(page, place.map((share) => 0.5 + scale * (share - 0.5)), eyes);
  console.log(`z ${z} mm: ${shift.toFixed(2)} px a view, ${wanted.toFixed(2)} by hand; two eyes differ by ${before.toFixed(1)} codes before, ${after.toFixed(1)} after`);
  assert.ok(Math.abs(shift - wanted) < 0.02 + 0.01 * Math.abs(wanted));
  assert.ok(after < 0.6 * before);
});

test("invalid prints give a message", async () => {
  const page = await open(await view("seven"));
  expectComplaints(/422/);
  await setSheet(page);
  await page.getByLabel("Lenses per inch").fill("0");
  await page.getByLabel("Lenses per inch").press("Enter");
  await page.getByLabel("See through the sheet").click();
  await page.locator("#notice", { hasText: /lpi/ }).waitFor();
  assert.equal(await page.getByLabel("See through the sheet").isChecked(), false);
  await drawn(page);
});
