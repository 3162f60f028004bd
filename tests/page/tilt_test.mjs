// A tilt of the device moves the eye if the device reports its orientation.
import assert from "node:assert/strict";
import { test } from "node:test";
import { closeAfterEach, lenslets, open, view } from "./support.mjs";

closeAfterEach();

lenslets();
const address = await view("lenslets");
const kDegree = Math.PI / 180;

const hold = (page, alpha, beta, gamma) => page.evaluate(([alpha, beta, gamma]) => window.dispatchEvent(new DeviceOrientationEvent("deviceorientation", { alpha, beta, gamma })), [alpha, beta, gamma]);
const button = (page) => page.getByRole("button", { name: "Tilt moves the eye" });
/** Clicks the button and waits until it is pressed. The browser may first ask for permission. */
async function press(page) {
  await button(page).click();
  await page.waitForSelector('button[aria-pressed="true"]:not(.icon)');
}
const slopes = async (page) => {
  const { eye } = await page.evaluate(() => window.lippmann.state);
  return [eye[0] / eye[2], eye[1] / eye[2]];
};
const near = (found, wanted) => found.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < 1e-9, `${found}, not ${wanted}`));

test("without a sensor there is no button", async () => {
  const page = await open(address);
  assert.equal(await button(page).isVisible(), false);
  await page.evaluate(() => window.dispatchEvent(new DeviceOrientationEvent("deviceorientation", { alpha: null, beta: null, gamma: null })));
  assert.equal(await button(page).isVisible(), false);
});

test("the eye stays fixed while the device turns", async () => {
  const page = await open(address);
  await hold(page, 10, 40, 0);
  await press(page);
  await hold(page, 10, 40, 0);
  near(await slopes(page), [0, 0]);
  // The right edge of the display moves away from the eye, so the eye is left of the middle.
  await hold(page, 10, 40, 5);
  near(await slopes(page), [-Math.tan(5 * kDegree), 0]);
  // The upper edge of the display moves towards the eye, so the eye is above the middle.
  await hold(page, 10, 46, 0);
  near(await slopes(page), [0, Math.tan(6 * kDegree)]);
  await hold(page, 10, 40, 0);
  near(await slopes(page), [0, 0]);
  await button(page).click();
  await hold(page, 10, 40, 8);
  near(await slopes(page), [0, 0]);
});

// A device at beta = 90 degrees is upright. Turning it about the vertical axis changes only alpha; gamma is undefined.
test("an upright device can turn sideways", async () => {
  const page = await open(address);
  await hold(page, 0, 90, 0);
  await press(page);
  await hold(page, 0, 90, 0);
  await hold(page, 4, 90, 0);
  near(await slopes(page), [-Math.tan(4 * kDegree), 0]);
});

test("the eye stays within the zone", async () => {
  const page = await open(address);
  await hold(page, 0, 40, 0);
  await press(page);
  await hold(page, 0, 40, 0);
  await hold(page, 0, 40, -60);
  const share = await page.evaluate(() => {
    const { eye } = window.lippmann.state;
    const { across } = window.lippmann.fields[0];
    return ((eye[0] / eye[2] - across.first) / across.step + 0.5) / across.views;
  });
  assert.ok(share <= 1 && share > 0.999, `${share}`);
});

for (const [answer, isOn] of [["granted", "true"], ["denied", "false"]])
  test(`${answer} permission decides`, async () => {
    const page = await open(address, { hasTouch: true, script: `DeviceOrientationEvent.requestPermission = async () => "${answer}"` });
    await button(page).click();
    if (answer === "denied") await page.waitForFunction(() => /does not let this page read the device's orientation/.test(document.querySelector("#notice").textContent));
    else await page.waitForSelector(`button[aria-pressed="true"]:not(.icon)`);
    assert.equal(await button(page).getAttribute("aria-pressed"), isOn);
    // The browser grants the permission, but this test sends no sensor events.
    if (answer === "granted") await page.waitForFunction(() => /does not report its orientation/.test(document.querySelector("#notice").textContent));
    if (answer === "granted") assert.equal(await button(page).isVisible(), false);
  });
