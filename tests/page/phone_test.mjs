// Every state of the page fits a phone, upright and on its side: nothing leaves the screen, and controls can be reached and touched.
// LIPPMANN_PICTURES=FOLDER also saves pictures of each state on phones and desktops, dark and light, to be looked at.
import assert from "node:assert/strict";
import { existsSync, mkdirSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";
import { begin, closeAfterEach, inFolder, lippmann, open, play, quilt, sheet, view } from "./support.mjs";

closeAfterEach();

/** Least side of a touch target, in CSS pixels. */
const kTouch = 40;
const kPhones = [[390, 844], [844, 390]];
const kScreens = [[1400, 900], ...kPhones];

const small = ["--size", "128x128", "--lenses", "16", "--frames", "0-8", "-q"];
const room = ["room", "--optics", "lenticular", "--size", "256x256", "--lenses", "32", "--frames", "0"];
const panel = { pitch: 52.3, slope: -7.2, center: 0.37, DPI: 324, screenW: 203, screenH: 151, viewCone: 40 };
writeFileSync(inFolder("panel.json"), JSON.stringify(panel));
quilt();
sheet();

const atRest = (page) => page.waitForSelector('#stage[data-rest="true"][data-drawn="true"]', { timeout: 90000 });
const isHere = (page) => page.waitForSelector('#stage[data-drawn="true"]', { timeout: 90000 });

/** Starts a render and stops the process after the second picture, when the first is in the journal, so that the page shows a render in progress. */
async function halted() {
  const render = begin("render", "room", "--optics", "multiview", "--views", "4x1", "--size", "256x64", "--layout", "quilt", "--integrator", "path", "--spp", "24", "--reuse", "none", "--frames", "0-7", "-o", "run", "-q");
  const pictures = () => (existsSync(inFolder("run")) ? readdirSync(inFolder("run")).filter((name) => /^frame_.*png$/.test(name)).length : 0);
  while (pictures() < 2) await new Promise((resolve) => setTimeout(resolve, 50));
  render.kill("SIGSTOP");
  after(() => render.kill("SIGKILL"));
  return view("run");
}

/** For each state: its address, what to wait for, names of the controls that must be within reach, and which of them are visible
 *  before the user opens the controls. */
const kStates = {
  "a quilt": { address: () => view("quilt"), ready: isHere, reach: ["Background blur", "3D glasses", "Fit", "Save page", "Print"] },
  "a lens sheet": { address: () => view("sheet"), ready: isHere, reach: ["Play", "Next frame", "Left to right", "Save page"], visible: ["Play"] },
  "a comparison": { address: () => view("sheet", "sheet"), ready: isHere, reach: ["Wipe", "Save page"] },
  "a print": {
    address: () => view("quilt"),
    ready: async (page) => {
      await isHere(page);
      await page.locator("summary", { hasText: "Print" }).evaluate((one) => (one.parentElement.open = true));
      await page.getByLabel("See through the sheet").evaluate((one) => one.click());
      await page.waitForSelector('#stage[data-print="shown"][data-drawn="true"]');
    },
    reach: ["Lenses per inch", "See through the sheet", "Zero plane", "Save the print"],
  },
  "a scene": { address: () => view(...room), ready: atRest, reach: ["Zoom", "Surroundings", "Samples a pixel"], visible: ["Render all frames", "Render this frame", "Save job"] },
  "a panel": { address: () => play("sheet", "--display", "panel.json"), ready: isHere, reach: ["Show", "Full screen", "Calibration…"], visible: ["Pause"] },
  "a scene on a panel": {
    address: () => play("room", "--display", "panel.json", "--views", "5x4", "--size", "320x192", "--frames", "0-2"),
    ready: atRest,
    reach: ["Turn", "Full screen", "Set up in another window"],
    visible: ["Render all frames", "Render this frame"],
  },
  "a render in progress": { address: halted, ready: (page) => page.waitForFunction(() => window.lippmann?.run.done > 0), reach: ["Stop", "Save page"] },
  "dropped pictures": { address: () => view(), ready: (page) => page.getByRole("heading", { name: "Drop pictures here" }).waitFor(), reach: ["Choose pictures…", "Choose a folder…"], visible: ["Choose pictures…"] },
  "a report": {
    address: () => {
      lippmann("render", "room", ...small, "--reuse", "interpolate", "--min-psnr", "30", "-o", "made");
      lippmann("report", "made", "-q");
      return pathToFileURL(inFolder("made/report.html")).href;
    },
    ready: (page) => page.locator(".uplot canvas").first().waitFor(),
    reach: ["Figures of every frame (9)"],
  },
};

/** Returns descriptions of visible elements that leave the window, or that lie in a box which hides part of them. */
const leaving = (page) =>
  page.evaluate(() => {
    const kScrolls = /auto|scroll/;
    const isScrolled = (one) => one && (kScrolls.test(getComputedStyle(one).overflowX) || isScrolled(one.parentElement));
    const name = (one) => `${one.localName}#${one.id}.${one.className} '${(one.textContent || "").slice(0, 40)}'`;
    const all = [...document.body.querySelectorAll("*")].filter((one) => one.checkVisibility() && !one.closest("svg, option, datalist"));
    const beyond = all.filter((one) => {
      const { left, right, width } = one.getBoundingClientRect();
      return width > 0 && (left < -0.5 || right > innerWidth + 0.5) && !isScrolled(one.parentElement);
    });
    const cut = all.filter((one) => one.matches("button, label, output, h1, h2, p, td, th") && one.scrollWidth > one.clientWidth + 1 && getComputedStyle(one).display !== "inline");
    return [document.documentElement.scrollWidth - innerWidth, [...beyond, ...cut].map(name)];
  });

/** Returns the visible controls that are too small for fingers, with their sizes. */
const smallTargets = (page, least) =>
  page.evaluate((least) => {
    const size = (one) => (one.labels?.[0] && one.type === "checkbox" ? one.closest(".row") : one).getBoundingClientRect();
    const name = (one) => one.labels?.[0]?.textContent || one.getAttribute("aria-label") || one.textContent;
    return [...document.querySelectorAll("button, input, select, summary")]
      .filter((one) => one.checkVisibility() && Math.min(size(one).width, size(one).height) < least)
      .map((one) => `${name(one)}: ${size(one).width.toFixed(0)}x${size(one).height.toFixed(0)}`);
  }, least);

const control = (page, name) => page.getByRole("button", { name, exact: true }).or(page.getByLabel(name, { exact: true })).or(page.locator("summary", { hasText: name })).first();

/** Fails unless a tap reaches the control, after scrolling if need be. */
const expectReach = (page, name) => control(page, name).click({ trial: true, timeout: 3000 });

async function savePictures(page, state) {
  const folder = process.env.LIPPMANN_PICTURES;
  if (!folder) return;
  mkdirSync(folder, { recursive: true });
  for (const [width, height] of kScreens)
    for (const colorScheme of ["dark", "light"]) {
      await page.setViewportSize({ width, height });
      await page.emulateMedia({ colorScheme });
      await page.waitForTimeout(700);
      const file = (part) => join(folder, `${state.replaceAll(" ", "_")}-${width}x${height}-${colorScheme}${part}.png`);
      await page.screenshot({ path: file("") });
      const toggle = page.getByRole("button", { name: "Controls" });
      if (!(await toggle.isVisible())) continue;
      await toggle.evaluate((one) => one.click());
      await page.waitForTimeout(300);
      await page.screenshot({ path: file("-open") });
      await toggle.evaluate((one) => one.click());
    }
}

for (const [state, { address, ready, reach, visible = [] }] of Object.entries(kStates))
  test(`a phone shows ${state}`, async () => {
    const page = await open(await address(), { width: kPhones[0][0], height: kPhones[0][1], ready: false, hasTouch: true });
    await ready(page);
    await savePictures(page, state);
    for (const [width, height] of kPhones) {
      await page.setViewportSize({ width, height });
      const size = `${width}x${height}`;
      for (const name of visible) await expectReach(page, name);
      const toggle = page.getByRole("button", { name: "Controls" });
      if ((await toggle.isVisible()) && (await toggle.getAttribute("aria-expanded")) === "false") await toggle.click();
      for (const name of [...reach, ...visible]) await expectReach(page, name);
      await page.evaluate(() => document.querySelectorAll("details").forEach((one) => (one.open = true)));
      assert.deepEqual(await leaving(page), [0, []], size);
      assert.deepEqual(await smallTargets(page, kTouch), [], size);
    }
  });
