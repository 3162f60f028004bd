// Shared helpers. A test is skipped (exit code 77) if Chromium, playwright-core or the tool is missing.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach } from "node:test";

function skip(reason) {
  console.log(`SKIPPED: ${reason}`);
  process.exit(77);
}

const tool = process.env.LIPPMANN_TOOL ?? "";
if (!existsSync(tool)) skip("LIPPMANN_TOOL is not the path of a program");
const chromiumPath = ["/usr/bin/chromium", "/usr/bin/chromium-browser"].find(existsSync);
if (!chromiumPath) skip("Chromium is not installed (scripts/bootstrap installs it)");
let playwright;
try {
  playwright = await import("playwright-core");
} catch {
  skip("playwright-core is not installed (npm ci in tests/page, as scripts/bootstrap does)");
}

export const folder = mkdtempSync(join(tmpdir(), "lippmann-page-"));
// LIPPMANN_ANGLE=vulkan or gl-egl draws on a graphics card instead of the processor.
const angle = process.env.LIPPMANN_ANGLE ?? "swiftshader";
const browser = await playwright.chromium.launch({
  executablePath: chromiumPath,
  args: ["--no-sandbox", "--use-gl=angle", `--use-angle=${angle}`, "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"],
});
const servers = [];
const opened = [];
const idle = [];

export async function end() {
  await browser.close();
  servers.forEach((server) => server.kill());
  rmSync(folder, { recursive: true, force: true });
  assert.deepEqual(takeComplaints(), []);
}
after(end);

// Errors and warnings in the console fail the test, except those about closed idle connections.
const kUsual = /SOCKET_NOT_CONNECTED/;
const complaints = [];
let expected = [];

/** Declares patterns of console errors that the running test provokes. */
export const expectComplaints = (...patterns) => expected.push(...patterns);

function takeComplaints() {
  const found = complaints.splice(0).filter((text) => ![kUsual, ...expected].some((pattern) => pattern.test(text)));
  expected = [];
  return found;
}
afterEach(() => assert.deepEqual(takeComplaints(), []));

function watch(page) {
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(error.stack || String(error)));
}

/** Closes all pages after each test, because open pages slow down others. Files whose tests share a page must not use
 *  this. */
export const closeAfterEach = () => afterEach(() => Promise.all(opened.splice(0).map(release)));

/** Reusing a page takes a third of the CPU time of opening a new one. */
async function release(page) {
  if (page.isClosed()) return;
  if (!page.isPlain) return page.context().close();
  await page.goto("about:blank");
  idle.push(page);
}

/** Opens a new page. sways: whether the page may sway, which is disabled for most tests. */
async function newPage({ width, height, script, hasTouch, sways, density }) {
  const context = await browser.newContext({ viewport: { width, height }, deviceScaleFactor: density, hasTouch, reducedMotion: sways ? "no-preference" : "reduce" });
  context.on("page", watch);
  const page = await context.newPage();
  if (script) await page.addInitScript(script);
  page.isPlain = !script && !hasTouch && !sways && density === 1;
  page.on("request", (request) => page.onRequest(request.url()));
  return page;
}

export const lippmann = (...words) => execFileSync(tool, words, { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });

/** Starts the tool as a process beside the tests. */
export function begin(...words) {
  const process = spawn(tool, words, { cwd: folder, stdio: "ignore" });
  servers.push(process);
  return process;
}

export const inFolder = (name) => join(folder, name);

export function only(name, pattern) {
  const found = readdirSync(inFolder(name)).filter((file) => pattern.test(file));
  if (found.length !== 1) throw new Error(`${name} has ${found.length} files like ${pattern}: ${found}`);
  return found[0];
}

export const view = (...words) => serve("view", ...words);
export const play = (...words) => serve("play", ...words);

async function serve(...words) {
  const server = spawn(tool, [...words, "--port", "0"], { cwd: folder, stdio: ["ignore", "pipe", "pipe"] });
  servers.push(server);
  let errors = "";
  server.stderr.on("data", (text) => (errors += text));
  return new Promise((resolve, reject) => {
    server.stdout.once("data", (text) => resolve(String(text).trim()));
    // "close" comes after all output, but "exit" may come before the last output.
    server.once("close", () => reject(new Error(errors)));
  });
}

/** Loads a page with retries. A busy server may close a connection that the browser opened in advance, and the browser's
 *  error page may interrupt the next attempt. */
async function load(page, address, attempts = 4) {
  await page.goto(address).catch(async (error) => {
    const isLate = error.message.includes("ERR_SOCKET_NOT_CONNECTED") || error.message.includes("chrome-error:");
    if (!isLate || attempts <= 1) throw error;
    await page.waitForURL(/^chrome-error:/, { timeout: 1000 }).catch(() => {});
    await load(page, address, attempts - 1);
  });
}

export const unfold = (page) => page.evaluate(() => document.querySelectorAll("details").forEach((one) => (one.open = true)));

/** Opens a page. ready: waits until the page shows a picture, and opens the groups of its controls. density: pixels of the screen per CSS
 *  pixel. */
export async function open(address, { width = 820, height = 420, ready = true, onRequest = () => {}, script = "", hasTouch = false, sways = false, density = 1 } = {}) {
  const used = script || hasTouch || sways || density !== 1 ? undefined : idle.pop();
  const page = used ?? (await newPage({ width, height, script, hasTouch, sways, density }));
  await page.setViewportSize({ width, height });
  opened.push(page);
  page.onRequest = onRequest;
  await load(page, address);
  if (!ready) return page;
  await page.waitForSelector('#stage[data-drawn="true"]', { timeout: 120000 });
  await unfold(page);
  return page;
}

/** Waits until the page shows its state. Changing the state resets data-drawn at once. */
export const drawn = (page) => page.waitForSelector('#stage[data-drawn="true"]');

export async function set(page, changes) {
  await page.evaluate((changes) => window.lippmann.set(changes), changes);
  await drawn(page);
}

export const eyeCodes = (page, side) => bytesOf(page, side);
export const panelCodes = (page) => bytesOf(page);

/** The bytes are transferred as a string, because an array takes 10 us per number. */
async function bytesOf(page, side) {
  const text = await page.evaluate(async (side) => {
    const codes = side ? await window.lippmann.picture(side, side) : window.lippmann.panel();
    let bytes = "";
    for (let i = 0; i < codes.length; i += 8192) bytes += String.fromCharCode(...codes.subarray(i, i + 8192));
    return btoa(bytes);
  }, side);
  return [...Buffer.from(text, "base64")];
}

/** Returns a handle to a file's codes in the page: { width, height, data }, data as RGBA. */
export function codesOf(page, file) {
  const url = `data:image/png;base64,${readFileSync(file).toString("base64")}`;
  return page.evaluateHandle(async (url) => {
    const bytes = Uint8Array.from(atob(url.split(",")[1]), (c) => c.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }), { colorSpaceConversion: "none" });
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext("2d");
    context.drawImage(bitmap, 0, 0);
    return context.getImageData(0, 0, bitmap.width, bitmap.height);
  }, url);
}

/** PSNR in dB of the page's picture for an eye against a file. */
export async function psnrBeside(page, file) {
  return page.evaluate(async ({ width, height, data: wanted }) => {
    const seen = await window.lippmann.picture(width, height);
    let sum = 0;
    for (let i = 0; i < wanted.length; i++) sum += (wanted[i] - seen[i]) ** 2;
    return sum === 0 ? 200 : 10 * Math.log10((255 ** 2 * 0.75 * wanted.length) / sum);
  }, await codesOf(page, file));
}

export function replay(input, name, ...flags) {
  lippmann("replay", input, "-o", `replayed-${name}`, ...flags);
  const [file] = readdirSync(inFolder(`replayed-${name}`)).sort();
  return join(inFolder(`replayed-${name}`), file);
}

/** Position of the eye that sees view (across, up) from the display's intended distance. Both numbers may be fractions. */
export const eyeOfView = (page, across, up) =>
  page.evaluate(
    ([across, up]) => {
      const field = window.lippmann.fields[0];
      const slope = (axis, view) => (axis.by === "angle" ? Math.tan : (x) => x)(axis.first + axis.step * view);
      const z = field.eye_mm[2];
      return [slope(field.across, across) * z, field.up.views > 1 ? slope(field.up, up) * z : field.eye_mm[1], z];
    },
    [across, up],
  );

export const sheet = () => lippmann("render", "teapot", "--size", "256x256", "--lenses", "32", "--frames", "0-5", "-o", "sheet", "-q");
export const fractional = () => lippmann("render", "teapot", "--size", "212x160", "--lens-pixels", "5.3", "--frames", "0", "-o", "fractional", "-q");
export const lenslets = () => lippmann("render", "room", "--optics", "microlens", "--size", "256x256", "--lenses", "64x64", "--lens-pixels", "4x4", "--frames", "0", "-o", "lenslets", "-q");
export const quilt = () => lippmann("render", "room", "--optics", "multiview", "--views", "4x3", "--size", "384x384", "--frames", "0", "--layout", "quilt", "--aov", "depth", "-o", "quilt", "-q");
export const grid = () => lippmann("render", "room", "--optics", "multiview", "--camera-grid", "--views", "5x5", "--size", "640x640", "--view-angle", "6", "--frames", "0", "--aov", "depth", "-o", "grid", "-q");
