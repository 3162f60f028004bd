import { button, element } from "./elements";

const kRows = (isLive: boolean): [string, string][] => [
  ["Drag", isLive ? "turn the scene, or do what Set-up has selected" : "look around"],
  ["Wheel, pinch", isLive ? "zoom (a pinch zooms the picture)" : "zoom the picture"],
  ["Right drag", "pan the picture"],
  ["Double click", "focus there"],
  ["\u2190 \u2192 \u2191 \u2193", isLive ? "move as dragging does, in steps" : "move the eye; hold Shift for small steps"],
  ["Home", "centre the eye, show the whole picture"],
  ["+ \u2212 0 1", "zoom in, zoom out, fit, true size (1:1)"],
  ["Space , .", "start and stop, previous frame, next frame"],
  ["A, C", "open or close the aperture; focus on the middle"],
  ["P", "show the panel behind the lenses"],
  ["F", "full screen"],
  ["?", "this list"],
];

let shown: HTMLDialogElement | null = null;

export function toggleKeyList(isLive: boolean): void {
  if (shown) return shown.close();
  const rows = kRows(isLive).map(([keys, does]) => element("tr", {}, element("th", { scope: "row" }, keys), element("td", {}, does)));
  const dialog = element("dialog", { id: "keys" }, element("h2", {}, "Mouse and keys"), element("table", {}, ...rows), button("Close", () => dialog.close()));
  dialog.setAttribute("aria-label", "Mouse and keys");
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  dialog.addEventListener("keydown", (event) => event.key === "?" && (event.preventDefault(), event.stopPropagation(), dialog.close()));
  dialog.addEventListener("close", () => {
    shown = null;
    dialog.remove();
    document.getElementById("canvas")?.focus({ preventScroll: true });
  });
  document.body.append(dialog);
  shown = dialog;
  dialog.showModal();
  // showModal() focuses the button at the bottom of the dialog, which scrolls the dialog down.
  dialog.scrollTop = 0;
}
