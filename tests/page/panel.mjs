// What tests of panels that are played on share: the codes of the page's panel beside a file, and calibrations that are dropped.
import { readFileSync } from "node:fs";
import { inFolder } from "./support.mjs";

/** The greatest difference of a channel between the page's panel and a file, and the share of channels that differ at all. */
export async function differenceFrom(page, file) {
  const url = `data:image/png;base64,${readFileSync(inFolder(file)).toString("base64")}`;
  return page.evaluate(async (url) => {
    const bytes = Uint8Array.from(atob(url.split(",")[1]), (c) => c.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }), { colorSpaceConversion: "none" });
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext("2d");
    context.drawImage(bitmap, 0, 0);
    const wanted = context.getImageData(0, 0, bitmap.width, bitmap.height).data;
    const shown = window.lippmann.panel();
    const { width, height } = document.querySelector("#canvas");
    if (width !== bitmap.width || height !== bitmap.height) throw new Error(`the canvas has ${width}x${height} pixels, the file ${bitmap.width}x${bitmap.height}`);
    let most = 0, differ = 0;
    for (let i = 0; i < wanted.length; i++) {
      const by = Math.abs(wanted[i] - shown[i]);
      most = Math.max(most, by);
      if (by > 0) differ++;
    }
    return { most, differ: differ / wanted.length };
  }, url);
}

/** Drops a file on the page. */
export const drop = (page, name, text) =>
  page.evaluate(
    ([name, text]) => {
      const data = new DataTransfer();
      data.items.add(new File([text], name, { type: "application/json" }));
      window.dispatchEvent(new DragEvent("drop", { dataTransfer: data, cancelable: true }));
    },
    [name, text],
  );
