// The controls beside the picture: native elements, which keyboards and screen readers support.
import { asksForCrosstalk } from "./data";
import { button, check, chooser, element, folded, group, rounded, slider, tip, type Shown } from "./elements";
import { hasCrosstalk, neighbourShare, shareOfZone, slopeWithinZone, type Field } from "./field";
import type { Live } from "./live";
import { jobGroup, lightDetails, setUpGroups } from "./live_controls";
import type { Motion } from "./motion";
import type { Player } from "./player";
import type { Print } from "./print";
import { printGroup } from "./print_controls";
import { runGroup } from "./run_controls";
import type { Run } from "./run";
import type { State, Store } from "./state";
import type { Tilt } from "./tilt";
import type { Headset } from "./xr";

function choice<Key extends keyof State>(label: string, key: Key, options: [string, string][], store: Store, shown: Shown[], applies = () => true): HTMLElement {
  const row = chooser(label, () => options, () => String(store.state[key]), (value) => store.set({ [key]: value }), shown, applies);
  shown[shown.length - 1].update();
  return row;
}

export interface Actions {
  savePicture: () => void;
  copyLink: () => void;
  /** Saves the page as one file. Null if this page is a saved page. whyNot: the reason if there is nothing to save yet, or "". */
  savePage: { save: () => void; whyNot: () => string } | null;
  /** Whether the page's address works on this machine only. */
  isLocal: boolean;
  focusRange: () => [number, number];
  zoom: { fit: () => void; trueSize: () => void };
  motion: Motion;
  player: Player;
  tilt: Tilt;
  headset: Headset;
  live: Live | null;
  run: Run | null;
  print: Print | null;
  savePrint: () => void;
}

/** Fills `parent`. Returns a function that updates all controls to the state. */
export function makeControls(parent: HTMLElement, store: Store, actions: Actions): () => void {
  const shown: Shown[] = [];
  const { fields } = store;
  const field = fields[0];
  const { live, player, print } = actions;
  const beginsOnPanel = live ? live.about.plays : store.state.show === "display";
  const isSeen = () => store.state.show !== "display";
  const hasEyes = () => field.across.views * field.up.views > 1 && store.state.show === "eye";
  const groups = [
    beginsOnPanel ? playGroup(player, live !== null, shown) : null,
    ...(live ? setUpGroups(store, field, live, shown) : []),
    actions.run ? runGroup(actions.run, shown) : null,
    fields.length > 1 ? compareGroup(store, shown) : null,
    lookGroup(store, field, actions, hasEyes, shown),
    shareGroup(actions, shown),
    print ? onlyIf(isSeen, folded("Print", printGroup(print, actions.savePrint, shown)), shown) : null,
    folded(
      "More",
      live ? lightDetails(live, shown) : null,
      onlyIf(hasEyes, eyeGroup(store, field, actions, shown), shown),
      pictureGroup(store, field, actions, shown),
      beginsOnPanel ? null : playGroup(player, live !== null, shown),
    ),
  ];
  parent.append(element("div", { className: "groups" }, ...groups.filter((one): one is HTMLElement => one !== null)));
  if (live) parent.append(jobGroup(live, shown));
  const update = () => shown.forEach((one) => one.update());
  store.listen(update);
  update();
  return update;
}

function lookGroup(store: Store, field: Field, actions: Actions, hasEyes: () => boolean, shown: Shown[]): HTMLElement {
  const { state } = store;
  const showsOne = () => store.fields.length < 2 || state.compare === "first" || state.compare === "second";
  const across = zone("Left to right", 0, store, field, hasEyes, shown);
  const up = zone("Down to up", 1, store, field, hasEyes, shown);
  return group(
    "Look",
    showChoice(store, () => field.across.views * field.up.views > 1, shown),
    tip("Position of the eye in the viewing zone. Drag the picture, or use the arrow keys", across),
    up,
    tip("Opens the aperture, which blurs all that is out of focus. Double-click to focus", slider({ label: "Background blur", applies: hasEyes, range: () => [0, 1], value: () => state.aperture, text: (value) => (value === 0 ? "all sharp" : `${rounded(100 * value, 0)}\u2009%`), set: (aperture) => store.set({ aperture }) }, shown)),
    tip("Depth in front of the display's plane", slider({ label: "Sharp at", unit: "mm", applies: () => hasEyes() && state.aperture > 0, range: actions.focusRange, value: () => state.focus, set: (focus) => store.set({ focus }) }, shown)),
    tip("Shows the pictures of two eyes at once", choice("3D glasses", "stereo", [["off", "None"], ["anaglyph", "Red and cyan"], ["side-by-side", "Side by side"], ["top-bottom", "Top and bottom"]], store, shown, () => hasEyes() && showsOne())),
    tip("Brightness on this page, in stops. Does not change the files", slider({ label: "Brightness", applies: () => state.show !== "display", range: () => [-4, 4], steps: 80, value: () => state.exposure, text: (value) => `${value > 0 ? "+" : ""}${rounded(value, 1)}\u2009EV`, set: (exposure) => store.set({ exposure }), reset: () => store.set({ exposure: 0 }) }, shown)),
    onlyIf(() => state.show !== "display", element("div", { className: "buttons" }, tip("The whole picture (0)", button("Fit", actions.zoom.fit)), tip("One pixel of the views per pixel of the screen (1)", button("1:1", actions.zoom.trueSize)), tip("Restores all settings", button("Reset", () => store.reset()))), shown),
  );
}

function shareGroup(actions: Actions, shown: Shown[]): HTMLElement {
  const { savePage, isLocal } = actions;
  const copy = isLocal
    ? tip("An address that shows exactly this. It works on this machine only; others need a file", button("Copy link (this machine)", actions.copyLink))
    : tip("An address that shows exactly this. It works wherever this page can be reached", button("Copy link", actions.copyLink));
  const picture = tip("What is seen now, as a PNG", button("Save picture", actions.savePicture));
  return group("Share", element("div", { className: "buttons" }, ...(savePage ? [savePageButton(savePage, shown)] : []), picture, copy));
}

function savePageButton({ save, whyNot }: NonNullable<Actions["savePage"]>, shown: Shown[]): HTMLElement {
  const made = button("Save page", save);
  shown.push({
    update: () => {
      made.title = whyNot() || "One .html file with all pictures in it: it opens anywhere, without this program";
      made.setAttribute("aria-disabled", String(whyNot() !== ""));
    },
  });
  return made;
}

/** The button is shown only if the device has the sensor. */
function tiltButton(tilt: Tilt, shown: Shown[]): HTMLElement {
  const made = button("Tilt moves the eye", () => void tilt.toggle());
  const row = element("div", { className: "row" }, made);
  shown.push({
    update: () => {
      row.hidden = !tilt.isThere;
      made.setAttribute("aria-pressed", String(tilt.isOn));
    },
  });
  return row;
}

function headsetButton(headset: Headset, shown: Shown[]): HTMLElement {
  const made = button("Enter VR", () => void headset.toggle());
  const row = element("div", { className: "row" }, made);
  shown.push({
    update: () => {
      row.hidden = !headset.isThere;
      made.textContent = headset.isOn ? "Leave VR" : "Enter VR";
    },
  });
  return row;
}

function zone(label: string, axis: 0 | 1, store: Store, field: Field, applies: () => boolean, shown: Shown[]): HTMLElement {
  const { state } = store;
  const its = () => (axis === 0 ? field.across : field.up);
  const move = (share: number) => {
    const eye = [...state.eye];
    eye[axis] = slopeWithinZone(its(), share) * eye[2];
    store.set({ eye });
  };
  return slider(
    {
      label,
      applies: () => applies() && its().views > 1,
      range: () => [0, 1],
      value: () => shareOfZone(its(), state.eye[axis] / state.eye[2]),
      text: () => `${rounded(state.eye[axis], 1)}\u2009mm`,
      set: move,
      reset: () => move(0.5),
    },
    shown,
  );
}

function eyeGroup(store: Store, field: Field, actions: Actions, shown: Shown[]): HTMLElement {
  const { state } = store;
  const showsOne = () => store.fields.length < 2 || state.compare === "first" || state.compare === "second";
  const home = () => field.eye_mm[2];
  const { motion } = actions;
  return group(
    "Eye",
    tip(
      "From the eye to the display",
      slider(
        {
          label: "Distance",
          unit: "mm",
          range: () => [-2, 2],
          value: () => Math.log2(state.eye[2] / home()),
          text: () => `${rounded(state.eye[2], 0)}\u2009mm`,
          set: (power) => {
            const z = home() * 2 ** power;
            store.set({ eye: [(state.eye[0] / state.eye[2]) * z, (state.eye[1] / state.eye[2]) * z, z] });
          },
        },
        shown,
      ),
    ),
    tip("Distance between the two eyes of 3D glasses, in front of the display", slider({ label: "Eye separation", unit: "mm", applies: () => showsOne() && state.stereo !== "off", range: () => [0, Math.max(80, state.separation)], value: () => state.separation, set: (separation) => store.set({ separation }) }, shown)),
    tip("The eye sways and follows the mouse until you touch the picture", check("Sways by itself", () => motion.isOn, (on) => (on ? motion.restart() : motion.end()), shown, () => motion.canMove)),
    tiltButton(actions.tilt, shown),
    headsetButton(actions.headset, shown),
  );
}

function pictureGroup(store: Store, field: Field, actions: Actions, shown: Shown[]): HTMLElement {
  const { state } = store;
  return group(
    "Picture",
    tip("What an eye between two views sees", choice("Between views", "between", [["depth", "Moved by their depth"], ["blend", "Blended"]], store, shown, () => field.depth)),
    tip("Each lens with one colour, as an eye far away sees it", check("Show single lenses", () => state.lenses, (lenses) => store.set({ lenses }), shown, () => field.lens_samples.some(Boolean))),
    tip("Blur of the lenses between views: sigma in pixels below a lens, and the share of each neighbour", slider({ label: "Crosstalk", late: () => asksForCrosstalk(field), applies: () => (hasCrosstalk(field) || (asksForCrosstalk(field) && actions.live === null && !actions.print?.isSeen)) && state.show === "eye" && state.aperture === 0, range: () => [0, Math.max(2, state.crosstalk)], value: () => state.crosstalk, text: (value) => (value === 0 ? "none" : `${rounded(value, 2)}\u2009px, ${rounded(100 * neighbourShare(value), 1)}\u2009%`), set: (crosstalk) => store.set({ crosstalk: Math.round(100 * crosstalk) / 100 }), reset: () => store.set({ crosstalk: 0 }) }, shown)),
    tip("Tints pixels by how the render made them", choice("Overlay", "overlay", [["none", "None"], ["provenance", "Where pixels came from"], ["missed", "Missed pixels"]], store, shown, () => field.provenance !== null && state.show !== "display")),
    tip("One line of the picture for all eyes from left (top) to right (bottom)", check("Epipolar-plane image", () => state.line >= 0, (on) => store.set({ line: on ? 0.5 : -1 }), shown, () => field.across.views > 1)),
    slider({ label: "Line, from the top", applies: () => state.line >= 0, range: () => [0, 1], value: () => state.line, text: (value) => `${rounded(100 * value, 0)}\u2009%`, set: (line) => store.set({ line }) }, shown),
    choice("Colours", "theme", [["system", "As the system"], ["dark", "Dark"], ["light", "Light"]], store, shown),
  );
}

/** Hides a row while applies() is false. */
function onlyIf(applies: () => boolean, made: HTMLElement, shown: Shown[]): HTMLElement {
  shown.push({ update: () => (made.hidden = !applies()) });
  return made;
}

/** Makes a row that is visible if there are views, or if a calibration was dropped on the page. */
function showChoice(store: Store, hasViews: () => boolean, shown: Shown[]): HTMLElement {
  const row = choice("Show", "show", [["eye", "What an eye sees"], ["panel", "Panel without lenses"], ["display", "On a calibrated panel"]], store, shown, () => hasViews() || store.plays);
  const played = row.querySelector<HTMLOptionElement>('option[value="display"]') as HTMLOptionElement;
  shown.push({ update: () => (played.hidden = played.disabled = !store.plays) });
  return row;
}

function playGroup(player: Player, isLive: boolean, shown: Shown[]): HTMLElement {
  const fill = button("Full screen", () => void player.toggleFullScreen());
  const second = button("Set up in another window", () => player.openSetUp());
  const value = element("output", { className: "value" });
  shown.push({
    update: () => {
      value.value = player.describe();
      fill.hidden = !player.isPlaying || !player.canFillScreen;
      second.hidden = !player.isPlaying || !isLive;
    },
  });
  const calibration = button("Calibration\u2026", () => player.choose());
  calibration.title = "The panel's visual.json, which can also be dropped on the page";
  return group("Calibrated panel", element("div", { className: "row panel" }, value), element("div", { className: "buttons" }, fill, second, calibration));
}

function compareGroup(store: Store, shown: Shown[]): HTMLElement {
  const { state, fields } = store;
  return group(
    "Compare",
    choice("Show", "compare", [["wipe", "Both, wiped"], ["side-by-side", "Side by side"], ["difference", "Difference"], ["first", `First: ${fields[0].title}`], ["second", `Second: ${fields[1].title}`]], store, shown),
    slider({ label: "Wipe", applies: () => state.compare === "wipe", range: () => [0, 1], value: () => state.wipe, text: (value) => `${rounded(100 * value, 0)}\u2009%`, set: (wipe) => store.set({ wipe }) }, shown),
    slider({ label: "Scale of differences", applies: () => state.compare === "difference", range: () => [1, 255], steps: 254, value: () => state.scale, text: (value) => `0 to ${rounded(value, 0)} codes`, set: (scale) => store.set({ scale }) }, shown),
  );
}
