// Views with light that leaks between pixels match `lippmann replay --crosstalk` with a PSNR of 40 dB, and 30 dB
// outside the viewing zone.
import assert from "node:assert/strict";
import { test } from "node:test";
import { besidePanel } from "./panel.mjs";
import { closeAfterEach, drawn, eyeOfView, grid, inFolder, lenslets, lippmann, open, psnrBeside, quilt, replay, set, sheet, view } from "./support.mjs";

closeAfterEach();

async function compare(name, make, eyes) {
  make();
  const page = await open(await view(name));
  for (const [across, up, sigma] of eyes) {
    const eye = Array.isArray(across) ? across : await eyeOfView(page, across, up);
    await set(page, { eye, lenses: true, between: "blend", crosstalk: sigma });
    const file = replay(name, `${name}-${across}-${up}-${sigma}`, "--eye", eye.join(","), "--crosstalk", String(sigma));
    const psnr = await psnrBeside(page, file);
    await set(page, { crosstalk: 0 });
    const without = await psnrBeside(page, file);
    console.log(`${name}, ${across}, ${up}, sigma ${sigma}: ${psnr.toFixed(1)} dB, without crosstalk ${without.toFixed(1)} dB`);
    assert.ok(psnr >= (Array.isArray(across) ? 30 : 40), `${name}, ${across}, ${up}, sigma ${sigma}: ${psnr} dB`);
    assert.ok(psnr > without + 6, `crosstalk makes no difference: ${psnr} dB with it, ${without} dB without`);
  }
}

test("a lenticular sheet, including its lenses' last pixels", () => compare("sheet", sheet, [[3, 0, 0.4], [0, 0, 0.75], [7, 0, 2], [2.4, 0, 0.6], [[60, 0, 192], 0, 1]]));
test("an array of lenslets, across and up", () => compare("lenslets", lenslets, [[1, 1, 0.5], [0, 3, 0.75], [2.5, 1.3, 1.5]]));
test("a quilt, whose outermost views have one neighbour", () => compare("quilt", quilt, [[6, 0, 1], [0, 0, 1.5], [9.7, 0, 3]]));
test("a grid of cameras", () => compare("grid", grid, [[2, 2, 0.75], [4, 0, 1], [1.5, 2.5, 2]]));

// The server computes these views, because they do not consist of whole pixels.
const slanted = () => lippmann("render", "room", "--optics", "lenticular", "--size", "212x160", "--lens-pixels", "5.3", "--slant", "-9.46", "--frames", "0", "-o", "slanted", "-q");
const hexagonal = () => lippmann("render", "room", "--optics", "microlens", "--packing", "hexagonal", "--size", "192x160", "--lens-pixels", "5", "--frames", "0", "-o", "hexagonal", "-q");
test("a slanted panel", () => compare("slanted", slanted, [[2, 0, 0.4], [4, 0, 1.5]]));
test("hexagonal lenslets", () => compare("hexagonal", hexagonal, [[2, 2, 0.5], [1, 3, 1.25]]));

test("the server computes crosstalk of such panels", async () => {
  slanted();
  const asked = [];
  const page = await open(await view("slanted"), { onRequest: (url) => asked.push(url) });
  const slider = page.getByRole("slider", { name: "Crosstalk" });
  const press = (kind, value) => slider.evaluate((input, [kind, value]) => ((input.value = value), input.dispatchEvent(new Event(kind, { bubbles: true }))), [kind, value]);
  for (const value of ["0.5", "1"]) await press("input", value);
  assert.match(await slider.evaluate((input) => input.closest(".row").querySelector("output").value), /^1.00.px/);
  assert.equal(await page.evaluate(() => window.lippmann.state.crosstalk), 0);
  await press("change", "1");
  await drawn(page);
  assert.deepEqual(asked.filter((url) => /views\/0\/\d/.test(url)).map((url) => url.split("/").slice(-3).join("/")), ["views/0/100"]);
  lippmann("view", "slanted", "--save", "slanted-page");
  const saved = await open(`file://${inFolder("slanted-page")}/index.html#crosstalk=1`);
  assert.equal(await saved.getByRole("slider", { name: "Crosstalk" }).isVisible(), false);
});

test("leaving the zone warns with replay's share", async () => {
  sheet();
  const page = await open(await view("sheet"));
  const notice = () => page.locator("#notice").textContent();
  assert.equal(await page.evaluate(() => window.lippmann.outOfZone), 0);
  assert.equal(await notice(), "");
  for (const eye of [[60, 0, 192], [-30, 0, 120], [45, 0, 192]]) {
    await set(page, { eye });
    const expected = JSON.parse(lippmann("replay", "sheet/frame_0000.png", "-o", "zone", "--eye", eye.join(","), "--json")).out_of_zone;
    const share = await page.evaluate(() => window.lippmann.outOfZone);
    console.log(`from ${eye}: ${share}, replay computes ${expected}`);
    assert.ok(Math.abs(share - expected) < 0.03, `from ${eye}: ${share}, replay computes ${expected}`);
    if (expected > 0) assert.match(await notice(), /outside the viewing zone of \d+.% of the display: there it sees the pictures of neighbouring lenses/);
  }
  await set(page, { show: "panel" });
  assert.equal(await notice(), "");
});

test("crosstalk is stated as each neighbour's share", async () => {
  const page = await open(await view("sheet"));
  for (const [sigma, share] of [[0.3, "4.8"], [0.5, "15.7"], [0.75, "23.0"]]) {
    await set(page, { crosstalk: sigma });
    const slider = page.getByRole("slider", { name: "Crosstalk" });
    assert.match(await slider.getAttribute("aria-valuetext"), new RegExp(`px, ${share.replace(".", "\\.")}.%`));
  }
  await set(page, { show: "panel" });
  assert.equal(await page.getByRole("slider", { name: "Crosstalk" }).isVisible(), false);
});

test("few lenses show their panel pixel for pixel", async () => {
  sheet();
  const page = await open(await view("sheet"), { width: 1400, height: 900 });
  assert.deepEqual(await besidePanel(page, "sheet"), { scale: 2, most: 0, isBelow: false });
  await page.keyboard.press("1");
  assert.deepEqual(await besidePanel(page, "sheet"), { scale: 1, most: 0, isBelow: false });
  await page.keyboard.press("0");
  await page.setViewportSize({ width: 1000, height: 700 });
  assert.deepEqual(await besidePanel(page, "sheet"), { scale: 1, most: 0, isBelow: false });
  await page.setViewportSize({ width: 390, height: 844 });
  assert.deepEqual(await besidePanel(page, "sheet"), { scale: 1, most: 0, isBelow: true });
  for (const [magnify, scale] of [[3, ", 3:1"], [2.5, ""]]) {
    await set(page, { magnify });
    assert.equal(await page.locator("#panel-caption").textContent(), `The panel behind the lenses${scale}`);
  }
  await set(page, { show: "panel", magnify: 1 });
  assert.equal(await page.locator(".caption:visible").count(), 0);
});

// In the small window, lenses are 3 CSS pixels wide at any density, so the page shows no panel beside the eye's view.
test("dense screens judge lenses by CSS pixels", async () => {
  lenslets();
  const address = await view("lenslets");
  for (const density of [1, 2]) {
    const page = await open(address, { width: 820, height: 278, density });
    assert.equal(await page.locator(".caption:visible").count(), 0, `density ${density}`);
    await page.setViewportSize({ width: 1400, height: 900 });
    await page.locator(".caption:visible").nth(1).waitFor();
  }
});

test("a quilt fills the page alone", async () => {
  quilt();
  const page = await open(await view("quilt"), { width: 1400, height: 900 });
  assert.equal(await page.locator(".caption:visible").count(), 0);
});
