// Shared helpers for tests of panels: compare the page's panel with a picture file, and drop files on the page.
import { codesOf, inFolder, only } from "./support.mjs";

/** Compares the page's panel with a file. Returns the greatest difference of a channel in codes, and the share of
 *  channels that differ. */
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

export const drop = (page, name, text) =>
  page.evaluate(
    ([name, text]) => {
      const data = new DataTransfer();
      data.items.add(new File([text], name, { type: "application/json" }));
      window.dispatchEvent(new DragEvent("drop", { dataTransfer: data, cancelable: true }));
    },
    [name, text],
  );

/** Compares the panel that is shown beside the eye's view with its file, pixel by pixel. from, to: range of columns, as
 *  shares of the file's width. Finds the panel by its caption, which is centred below the panel. shift: offset of the
 *  panel's middle from the caption, in widths of the panel. */
export const besidePanel = async (page, folder, { from = 0, to = 1, shift = 0 } = {}) =>
  page.evaluate(
    ([{ width, height, data }, from, to, shift]) => {
      const canvas = document.querySelector("canvas"), seen = window.lippmann.panel();
      const caption = document.getElementById("panel-caption");
      const scale = Number(/(\d+):1/.exec(caption.textContent)[1]);
      const left = Math.round(parseFloat(caption.style.left) - canvas.offsetLeft + scale * width * (shift - 0.5));
      const top = parseFloat(caption.style.top) - canvas.offsetTop - scale * height;
      let most = 0;
      for (let y = 0; y < scale * height; y++)
        for (let x = Math.max(Math.ceil(from * scale * width), -left); x < Math.min(to * scale * width, canvas.width - left); x++)
          for (let c = 0; c < 3; c++)
            most = Math.max(most, Math.abs(seen[4 * ((top + y) * canvas.width + left + x) + c] - data[4 * (Math.floor(y / scale) * width + Math.floor(x / scale)) + c]));
      const eye = document.getElementById("eye-caption").style;
      return { scale, most, isBelow: parseFloat(eye.top) < parseFloat(caption.style.top) };
    },
    [await codesOf(page, inFolder(`${folder}/${only(folder, /^frame_0000\.png$/)}`)), from, to, shift],
  );
