import { button, check, chooser, element, entry, group, rounded, slider, type Shown } from "./elements";
import { kFile, kSheet, type Print } from "./print";

const kPapers = ["A3", "A4", "A5", "A6", "letter", "5x7in", "100x150mm"];

export function printGroup(print: Print, save: () => void, shown: Shown[]): HTMLElement {
  const { settings } = print;
  const displays = (): [string, string][] => [
    [kSheet, "Lens sheet on paper"],
    ...(print.file ? [[kFile, print.file.name] as [string, string]] : []),
    ...print.about.displays.map((name): [string, string] => [name, name]),
  ];
  const isSheet = () => settings.display === kSheet;
  const click = button("Zero plane on the picture", () => print.awaitClick(!print.awaitsClick));
  click.title = "Drag the picture left or right, or click on the point that should lie in the plane of the paper";
  const saving = button("Save the print", save);
  const status = element("output", { className: "job value" });
  shown.push({
    update: () => {
      click.setAttribute("aria-pressed", String(print.awaitsClick));
      saving.disabled = print.isBusy;
      status.value = print.isBusy ? "The print is being made\u2026" : print.isSeen && print.made ? [print.made.description, print.made.fitted].filter(Boolean).join("\n") : "";
    },
  });
  const made = group(
    "Print",
    chooser("Display", displays, () => settings.display, (display) => print.set({ display }), shown),
    entry({ label: "Lenses per inch", value: () => settings.lpi, set: (lpi) => print.set({ lpi }), applies: isSheet, numeric: true }, shown),
    entry({ label: "Dots per inch", value: () => settings.dpi, set: (dpi) => print.set({ dpi }), applies: isSheet, numeric: true }, shown),
    entry({ label: "Paper", value: () => settings.paper, set: (paper) => print.set({ paper }), applies: isSheet, choices: kPapers }, shown),
    check("Landscape", () => settings.landscape, (landscape) => print.set({ landscape }), shown, isSheet),
    chooser(
      "Views of another shape",
      () => [["", "Automatic"], ["crop", "Crop"], ["pad", "Black bars"], ["stretch", "Stretch"]],
      () => settings.fit,
      (fit) => print.set({ fit: fit as typeof settings.fit }),
      shown,
    ),
    check("See through the sheet", () => print.isWanted, (on) => print.see(on), shown),
    slider({ label: "Zero plane", late: () => true, range: () => print.shiftRange, steps: 600, value: () => settings.shift, text: (shift) => `${shift > 0 ? "+" : ""}${rounded(shift, 2)}\u2009px a view`, set: (shift) => print.setShift(shift), reset: () => print.setShift(0) }, shown),
    status,
    element("div", { className: "buttons" }, saving, click, button("From a file\u2026", () => choose(print))),
  );
  made.classList.add("is-named-above");
  return made;
}

function choose(print: Print): void {
  const input = document.createElement("input");
  Object.assign(input, { type: "file", accept: ".toml,.json,application/json" });
  input.addEventListener("change", () => input.files?.[0] && void print.chooseFile(input.files[0]));
  input.click();
}
