// The page follows the colour scheme of the system until the user chooses one.
import assert from "node:assert/strict";
import { test } from "node:test";
import { closeAfterEach, drawn, open, sheet, view } from "./support.mjs";

closeAfterEach();

sheet();
const address = await view("sheet");

/** Returns the background of the page, and the codes of the canvas beside the picture. */
const grounds = (page) =>
  page.evaluate(() => {
    const ground = getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number);
    return [ground, [...window.lippmann.panel().slice(0, 3)]];
  });

async function expectGround(page, code) {
  await drawn(page);
  const [page_, canvas] = await grounds(page);
  assert.equal(page_[0], code);
  assert.deepEqual(canvas, page_);
}

test("the system's scheme is followed while the page is open", async () => {
  const page = await open(address);
  for (const [colorScheme, code] of [["light", 0xed], ["dark", 0x0e], ["light", 0xed]]) {
    await page.emulateMedia({ colorScheme });
    await expectGround(page, code);
  }
});

test("a chosen scheme stays", async () => {
  const page = await open(address);
  await page.emulateMedia({ colorScheme: "light" });
  await page.getByLabel("Colours").selectOption("dark");
  await expectGround(page, 0x0e);
  await page.waitForFunction(() => location.hash === "#theme=dark");
  await page.reload();
  await expectGround(page, 0x0e);
});
