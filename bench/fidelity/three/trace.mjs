// Renders a scenario with three-gpu-pathtracer in headless Chromium:
//   node trace.mjs JOB.json
// The job has the members file, panorama (or null), skybox, width, height, vertices, camera, and renders, a list of {samples,
// out}. Writes RGBA as 32-bit floats to each `out`, with the lowest row first, and prints one line of JSON for each picture.
// Run `npm ci` in this folder first.
import fs from "node:fs";
import http from "node:http";
import path from "node:path";
import { chromium } from "playwright-core";

const here = import.meta.dirname;
const job = JSON.parse(fs.readFileSync(process.argv[2], "utf8"));
const types = { ".html": "text/html", ".js": "text/javascript", ".mjs": "text/javascript", ".wasm": "application/wasm" };
const given = { "/": path.join(here, "index.html"), "/scenario/scene.glb": job.file, "/scenario/panorama": job.panorama };

function answer(request, response) {
  const name = new URL(request.url, "http://localhost").pathname, file = given[name] ?? path.join(here, path.normalize(name));
  if (!fs.existsSync(file)) return response.writeHead(404).end();
  response.writeHead(200, { "content-type": types[path.extname(file)] ?? "application/octet-stream" });
  fs.createReadStream(file).pipe(response);
}

/** LIPPMANN_ANGLE=vulkan or gl-egl draws on a graphics card instead of the processor. */
function launch() {
  const graphics = ["--use-gl=angle", `--use-angle=${process.env.LIPPMANN_ANGLE ?? "swiftshader"}`, "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
  return chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox", ...graphics] });
}

async function open(browser, port) {
  const page = await browser.newPage();
  page.setDefaultTimeout(0);
  page.on("pageerror", (error) => console.error(`three-gpu-pathtracer: ${error.message}`));
  await page.goto(`http://127.0.0.1:${port}/`);
  await page.waitForFunction(() => window.picture);
  return page;
}

async function render(page, { samples, out }) {
  await page.evaluate(() => window.begin());
  for (let has = 0; has < samples;) has = await page.evaluate((wanted) => window.sample(wanted), samples);
  fs.writeFileSync(out, Buffer.from(await page.evaluate(() => window.picture()), "base64"));
  console.log(`RENDER ${JSON.stringify({ out, samples })}`);
}

const server = http.createServer(answer);
await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
const browser = await launch();
try {
  const page = await open(browser, server.address().port);
  await page.evaluate((asked) => window.setUp(asked), job);
  for (const wanted of job.renders) await render(page, wanted);
} finally {
  await browser.close();
  server.close();
}
