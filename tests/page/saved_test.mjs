// A saved page opens from disk and from any web server, and shows the same as the served one.
import assert from "node:assert/strict";
import { createReadStream, existsSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";
import { closeAfterEach, inFolder, lippmann, open, psnrBeside, quilt, replay, set, sheet, view } from "./support.mjs";

closeAfterEach();

sheet();
lippmann("view", "sheet", "--save", "saved");

async function check(address) {
  const page = await open(address);
  await set(page, { lenses: true, frame: 2 });
  await page.waitForSelector('#stage[data-frame="2"]');
  const psnr = await psnrBeside(page, replay("sheet", "saved").replace("eye_0000", "eye_0002"));
  assert.ok(psnr >= 38, `${psnr} dB`);
}

/** Checks that an embedding page can control the saved page by messages, and receives its state. */
async function checkEmbedded(address) {
  writeFileSync(inFolder("saved/around.html"), '<link rel="icon" href="data:," /><iframe src="index.html"></iframe>');
  const page = await open(`${address}around.html`, { ready: false });
  await page.frameLocator("iframe").locator('#stage[data-drawn="true"]').waitFor();
  await page.evaluate(async () => {
    const received = new Promise((resolve) => window.addEventListener("message", (event) => event.data.lippmann?.state.frame === 3 && resolve()));
    document.querySelector("iframe").contentWindow.postMessage({ lippmann: { frame: 3 } }, "*");
    await received;
  });
}

test("from a disk", () => check(pathToFileURL(inFolder("saved/index.html")).href));

test("from a web server", async () => {
  const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css" };
  const server = createServer((request, response) => {
    const path = join(inFolder("saved"), request.url === "/" ? "index.html" : request.url.split("?")[0]);
    response.writeHead(existsSync(path) ? 200 : 404, { "Content-Type": types[extname(path)] ?? "application/octet-stream" });
    if (existsSync(path)) createReadStream(path).pipe(response);
    else response.end();
  });
  after(() => server.close().closeAllConnections());
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  const address = `http://127.0.0.1:${server.address().port}/`;
  await check(address);
  await checkEmbedded(address);
});

test("with depth", async () => {
  quilt();
  lippmann("view", "quilt", "--save", "saved-quilt");
  const saved = await open(pathToFileURL(inFolder("saved-quilt/index.html")).href);
  const served = await open(await view("quilt"));
  const sums = [];
  for (const page of [saved, served]) {
    await set(page, { eye: [7, 0, 200] });
    sums.push(await page.evaluate(async () => (await window.lippmann.picture(96, 128)).reduce((a, b) => a + b)));
  }
  assert.equal(sums[0], sums[1]);
});
