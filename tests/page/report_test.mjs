// The page of figures opens from a disk, without a script, and fits windows of every width.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { closeAfterEach, inFolder, lippmann, open } from "./support.mjs";

closeAfterEach();

const small = ["--size", "128x128", "--lenses", "16", "--frames", "0-8", "-q"];
lippmann("render", "room", ...small, "--reuse", "interpolate", "--min-psnr", "30", "-o", "made");
lippmann("render", "room", ...small, "--reuse", "none", "-o", "traced");
lippmann("report", "made", "-q");
lippmann("report", "traced", "made", "-o", "both.html", "-q");

const openFile = (name, options) => open(pathToFileURL(inFolder(name)).href, { ready: false, ...options });
const report = (name) => JSON.parse(readFileSync(inFolder(`${name}/report.json`), "utf8"));

test("it opens from a disk, shows pictures, and the console has nothing to say", async () => {
  const asked = [];
  const page = await openFile("made/report.html", { onRequest: (url) => asked.push(url) });
  assert.match(await page.title(), /^made/);
  const widths = await page.locator(".pictures img").evaluateAll((images) => images.map((image) => image.naturalWidth));
  assert.ok(widths.length > 1 && widths.every((width) => width > 0), `${widths}`);
  assert.ok(asked.every((url) => url.startsWith("file:") || url.startsWith("data:")), `${asked}`);
});

test("every frame tells the figures that the report has", async () => {
  const page = await openFile("made/report.html");
  const titles = await page.locator("rect.tip title").evaluateAll((all) => all.map((title) => title.textContent));
  for (const frame of report("made").frames.filter((frame) => frame.psnr_at_least_db !== null)) {
    const bound = Number(frame.psnr_at_least_db.toPrecision(4));
    const told = titles.find((title) => title.startsWith(`Frame ${frame.frame}\n`) && title.includes("at least"));
    assert.ok(told?.includes(`at least (95 % confidence): ${bound} dB`), `${frame.frame}: ${told}`);
  }
});

test("bars are drawn in colours that can be told apart, in light and dark", async () => {
  const page = await openFile("made/report.html");
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    const colors = await page.locator(".chart:has(.bar) >> nth=0").locator(".bar").evaluateAll((bars) => bars.map((bar) => getComputedStyle(bar).fill));
    assert.ok(colors.length > 1 && new Set(colors).size === colors.length, `${colorScheme}: ${colors}`);
  }
  await page.emulateMedia({ colorScheme: null });
});

test("no window is too narrow, and the table scrolls in its own box", async () => {
  for (const width of [340, 820, 1400]) {
    const page = await openFile("both.html", { width, height: 700 });
    await page.locator("details").evaluateAll((all) => all.forEach((details) => (details.open = true)));
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
  }
});

test("two renders stand side by side", async () => {
  const page = await openFile("both.html");
  assert.deepEqual(await page.locator(".compare thead th").allTextContents(), ["", "traced", "made"]);
  assert.equal(await page.locator("h2").count(), 3);
});

test("a truncated report is an error in one line", () => {
  writeFileSync(inFolder("cut.json"), readFileSync(inFolder("made/report.json"), "utf8").slice(0, 2000));
  assert.throws(() => lippmann("report", "cut.json"), /cut\.json: is not JSON, or ends before its end/);
});
