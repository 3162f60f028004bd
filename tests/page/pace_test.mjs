// With slow graphics, pictures have fewer pixels while the view moves, and full resolution when it rests.
import assert from "node:assert/strict";
import { test } from "node:test";
import { closeAfterEach, open, quilt, set, view } from "./support.mjs";

closeAfterEach();
quilt();
const address = await view("quilt");

/** Returns a script that simulates a slow screen: it multiplies the time stamp of every frame of the screen by `times`. */
const slowed = (times) => `
  const inTime = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (then) => inTime((now) => then(${times} * now));`;

/** Moves the eye from one side to the other. Returns the factor by which each picture's sides were divided. */
const move = (page, pictures) =>
  page.evaluate(async (pictures) => {
    const [x, y, z] = window.lippmann.fields[0].eye_mm, divisors = [];
    for (let i = 0; i <= pictures; i++) {
      window.lippmann.set({ eye: [x + 20 * (i / pictures), y, z] });
      await new Promise(requestAnimationFrame);
      divisors.push(Number(document.getElementById("stage").dataset.divisor));
    }
    return divisors;
  }, pictures);

const atRest = (page) => page.waitForSelector('#stage[data-drawn="true"][data-divisor="1"]');
const canvas = (page) => page.evaluate(() => document.querySelector("canvas").toDataURL());

test("movement on slow graphics is coarse", async () => {
  const page = await open(address, { script: slowed(20) });
  const divisors = await move(page, 30);
  await atRest(page);
  const moved = await canvas(page);
  assert.equal(divisors[0], 1);
  assert.equal(divisors.at(-1), 4, String(divisors));
  await set(page, { exposure: 1 });
  await set(page, { exposure: 0 });
  await atRest(page);
  assert.ok((await canvas(page)) === moved, "another picture than at rest");
});

test("a coarse picture shows the same scene", async () => {
  const page = await open(address, { script: slowed(20) });
  await page.evaluate(() => {
    window.codes = () => {
      const canvas = document.querySelector("canvas"), [width, height] = [canvas.clientWidth, canvas.clientHeight];
      const context = new OffscreenCanvas(width, height).getContext("2d");
      context.drawImage(canvas, 0, 0, width, height);
      return context.getImageData(0, 0, width, height).data;
    };
  });
  // Moves without a pause, because the page draws at full resolution as soon as the view rests.
  const divisor = await page.evaluate(async () => {
    const [x, y, z] = window.lippmann.fields[0].eye_mm;
    for (let i = 1; i <= 30; i++) {
      window.lippmann.set({ eye: [x + (20 * i) / 30, y, z] });
      await new Promise(requestAnimationFrame);
    }
    window.away = window.codes();
    window.lippmann.set({ eye: [x, y, z] });
    await new Promise(requestAnimationFrame);
    window.coarse = window.codes();
    return document.getElementById("stage").dataset.divisor;
  });
  assert.equal(divisor, "4");
  await atRest(page);
  const [error, errorAway] = await page.evaluate(() => {
    const fine = window.codes();
    return [window.coarse, window.away].map((other) => fine.reduce((sum, code, i) => sum + (code - other[i]) ** 2, 0));
  });
  assert.ok(error > 0, "it has fewer pixels");
  assert.ok(error < errorAway / 2, `${error} is no less than half of ${errorAway}, seen from elsewhere`);
});

test("fast graphics draw all pictures finely", async () => {
  const page = await open(address, { script: slowed(1e-3) });
  assert.deepEqual(new Set(await move(page, 30)), new Set([1]));
});

test("a pointer over the picture moves nothing", async () => {
  const page = await open(address, { script: slowed(20) });
  await move(page, 30);
  await atRest(page);
  for (let i = 0; i < 30; i++) {
    await page.mouse.move(100 + 5 * i, 150);
    assert.equal(await page.getAttribute("#stage", "data-divisor"), "1");
  }
});
