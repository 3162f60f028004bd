// Measures the page of `lippmann view` in headless Chromium with software graphics: the time until the first of 48 frames is
// visible, the eye views per second, and the size in bytes.
//   node bench/page_speed.mjs [LIPPMANN]     (needs chromium, and npm ci in tests/page)
import { readdirSync, statSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const root = dirname(dirname(fileURLToPath(import.meta.url)));
process.env.LIPPMANN_TOOL = resolve(process.argv[2] ?? join(root, "build/release/lippmann"));
const { inFolder, lippmann, open, view, end } = await import(join(root, "tests/page/support.mjs"));

const bytesOf = (folder) => readdirSync(folder, { withFileTypes: true }).reduce((sum, one) => sum + (one.isDirectory() ? bytesOf(join(folder, one.name)) : statSync(join(folder, one.name)).size), 0);
const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];

async function firstPicture(address) {
  const start = performance.now();
  const page = await open(address, { width: 1280, height: 800 });
  const milliseconds = performance.now() - start;
  await page.context().close();
  return milliseconds;
}

const kNoteFirst = `new MutationObserver((_, observer) => {
  const { preview, drawn } = document.getElementById("stage")?.dataset ?? {};
  if (preview !== "true" && drawn !== "true") return;
  observer.disconnect();
  requestAnimationFrame(() => (window.firstAt = performance.now()));
}).observe(document, { attributes: true, childList: true, subtree: true });`;

/** Returns the milliseconds until a new page shows a light field, and the bytes that it has received. */
async function firstPreview(address) {
  const page = await open(address, { width: 1280, height: 800, script: kNoteFirst });
  const found = await page.evaluate(() => {
    const received = [...performance.getEntriesByType("navigation"), ...performance.getEntriesByType("resource")].filter((one) => one.responseEnd <= window.firstAt);
    return [window.firstAt, received.reduce((sum, one) => sum + one.encodedBodySize, 0)];
  });
  await page.context().close();
  return found;
}

/** Moves the eye in every frame of the screen. Returns the frame rate, and how far the page lowers the resolution, as text. */
async function eyesASecond(page, seconds) {
  const [rate, divisor] = await page.evaluate(async (seconds) => {
    const [x, y, z] = window.lippmann.fields[0].eye_mm;
    const times = [];
    const start = performance.now();
    while (performance.now() - start < 1000 * seconds) {
      window.lippmann.set({ eye: [x + 0.15 * z * Math.sin(times.length / 7), y, z] });
      await new Promise(requestAnimationFrame);
      window.lippmann.valueAt(0.5, 0.5);
      times.push(performance.now());
    }
    return [times.length / ((times[times.length - 1] - start) / 1000), document.getElementById("stage").dataset.divisor];
  }, seconds);
  return `${rate.toFixed(1)}${divisor === "1" ? "" : ` (while it moves, 1/${divisor} of the rows and columns)`}`;
}

const rows = [];
lippmann("render", "teapot", "--frames", "0-47", "-o", "animation", "-q");
const firsts = [];
for (let i = 0; i < 5; i++) firsts.push(await firstPicture(await view("animation")));
rows.push(["first picture, 48 frames of 512x512", `${(median(firsts) / 1000).toFixed(2)} s`]);
const animation = await open(await view("animation"), { width: 850, height: 680 });
await animation.waitForTimeout(3000);
rows.push(["eyes a second, 512x512, 8 views", await eyesASecond(animation, 3)]);
// The page lowers its resolution if frames take long. With this script, every frame appears to take no time, so the resolution
// stays full.
const script = "const inTime = window.requestAnimationFrame.bind(window); window.requestAnimationFrame = (then) => inTime((now) => then(1e-3 * now));";
const fine = await open(await view("animation"), { width: 850, height: 680, script });
await fine.waitForTimeout(3000);
rows.push(["eyes a second, 512x512, as fine as at rest", await eyesASecond(fine, 3)]);
lippmann("render", "room", "--optics", "multiview", "--views", "8x6", "--size", "3360x3360", "--frames", "0", "--layout", "quilt", "--aov", "depth", "-o", "quilt", "-q");
const previews = [];
for (let i = 0; i < 5; i++) previews.push(await firstPreview(await view("quilt")));
const [milliseconds, bytes] = previews.sort(([a], [b]) => a - b)[previews.length >> 1];
rows.push(["first picture, 3360x3360 quilt (a preview)", `${(milliseconds / 1000).toFixed(2)} s (${(previews[0][0] / 1000).toFixed(2)} s at best), ${(bytes / 1000).toFixed(0)} kB`]);
const quilt = await open(await view("quilt"), { width: 1280, height: 800 });
await quilt.evaluate(() => window.lippmann.picture(8, 8));
await quilt.evaluate(() => window.lippmann.set({ between: "blend" }));
rows.push(["eyes a second, 3360x3360 quilt, blended", await eyesASecond(quilt, 3)]);
await quilt.evaluate(() => window.lippmann.set({ between: "depth" }));
rows.push(["eyes a second, 3360x3360 quilt, by depth", await eyesASecond(quilt, 3)]);
const page = ["index.html", "app.js", "app.css"].reduce((sum, name) => sum + statSync(join(root, "web/dist", name)).size, 0);
rows.push(["page", `${(page / 1000).toFixed(1)} kB`]);
lippmann("view", "animation", "--save", "saved");
rows.push(["saved folder, 48 frames of 512x512", `${(bytesOf(inFolder("saved")) / 1e6).toFixed(1)} MB`]);
for (const [name, value] of rows) console.log(`${name.padEnd(44)} ${value}`);
await end();
