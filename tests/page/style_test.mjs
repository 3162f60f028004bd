// Checks the size of the page's files, and the contrast of its colours in both schemes. Needs no browser.
import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

const web = join(import.meta.dirname, "../../web");
const style = readFileSync(join(web, "public/app.css"), "utf8");

/** Returns the red, green and blue codes of a variable. scheme: 0 for light, 1 for dark. */
function colour(name, scheme) {
  const [, light, dark] = new RegExp(`--${name}: light-dark\\(#([0-9a-f]{6}), #([0-9a-f]{6})\\)`).exec(style);
  return [0, 2, 4].map((at) => parseInt([light, dark][scheme].slice(at, at + 2), 16));
}

// WCAG 2.2: relative luminance and contrast ratio.
const linear = (code) => (code / 255 <= 0.04045 ? code / 255 / 12.92 : ((code / 255 + 0.055) / 1.055) ** 2.4);
const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);

function contrast(a, b) {
  const [dark, light] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (light + 0.05) / (dark + 0.05);
}

/** Name of the CSS variable with the colour of unfinished frames on the time line. */
const [, pending] = /\.marks \.pending \{\s*fill: var\(--(\w+)\);/.exec(style);

test("black on white has a contrast of 21", () => assert.equal(contrast([0, 0, 0], [255, 255, 255]), 21));

for (const [scheme, name] of ["light", "dark"].entries())
  test(`contrast, ${name}`, () => {
    for (const [front, least] of [["border", 3], [pending, 3], ["accent", 3], ["text", 4.5], ["quiet", 4.5]])
      for (const back of ["panel", "ground"]) {
        const ratio = contrast(colour(front, scheme), colour(back, scheme));
        console.log(`${front} on ${back}, ${name}: ${ratio.toFixed(2)}`);
        assert.ok(ratio >= least, `${front} on ${back}: ${ratio}`);
      }
  });

test("the page has at most 200 kB", () => {
  const bytes = ["index.html", "app.js", "app.css"].reduce((sum, name) => sum + statSync(join(web, "dist", name)).size, 0);
  console.log(`${bytes} bytes`);
  assert.ok(bytes <= 200e3, `${bytes} bytes`);
});
