// Compares the page's panel with a picture file, and drops files on the page.
import { codesOf, inFolder } from "./support.mjs";

/** Compares the page's panel with a picture file. Returns the greatest difference of a channel in codes, and the share of channels that
 *  differ. */
export async function differenceFrom(page, file) {
  return page.evaluate(({ width, height, data: wanted }) => {
    const shown = window.lippmann.panel();
    const canvas = document.querySelector("#canvas");
    if (canvas.width !== width || canvas.height !== height) throw new Error(`the canvas has ${canvas.width}x${canvas.height} pixels, the file ${width}x${height}`);
    let most = 0, differ = 0;
    for (let i = 0; i < wanted.length; i++) {
      const by = Math.abs(wanted[i] - shown[i]);
      most = Math.max(most, by);
      if (by > 0) differ++;
    }
    return { most, differ: differ / wanted.length };
  }, await codesOf(page, inFolder(file)));
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
