// The controls beside the picture: native elements, so that keyboards and screen readers know them.
import { asksForCrosstalk } from "./data";
import { button, check, chooser, element, group, rounded, slider, type Shown } from "./elements";
import { hasCrosstalk, neighbourShare, shareOfZone, slopeInZone, type Field } from "./field";
import type { Live } from "./live";
import { setUpGroups } from "./live_controls";
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
  save: () => void;
  copy: () => void;
  focusRange: () => [number, number];
  player: Player;
  tilt: Tilt;
  headset: Headset;
  live: Live | null;
  run: Run | null;
  print: Print | null;
  savePrint: () => void;
}

/** Fills `parent`; what is returned brings all controls up to the state. */
export function makeControls(parent: HTMLElement, store: Store, actions: Actions): () => void {
  const shown: Shown[] = [];
  const { fields } = store;
  const field = fields[0];
  const beginsOnPanel = actions.live?.about.plays ?? false;
  const hasViews = () => field.across.views * field.up.views > 1;
  parent.append(
    ...[
      beginsOnPanel ? playGroup(actions.player, true, shown) : null,
      ...(actions.live ? setUpGroups(store, field, actions.live, shown) : []),
      actions.run ? runGroup(actions.run, shown) : null,
      fields.length > 1 ? compareGroup(store, shown) : null,
      onlyIf(() => hasViews() && store.state.show !== "display", eyeGroup(store, field, actions, shown), shown),
      onlyIf(() => hasViews() && store.state.show !== "display", focusGroup(store, actions, shown), shown),
      pictureGroup(store, field, actions, hasViews, shown),
      actions.print ? onlyIf(() => store.state.show !== "display", printGroup(actions.print, actions.savePrint, shown), shown) : null,
      beginsOnPanel ? null : playGroup(actions.player, actions.live !== null, shown),
      element(
        "div",
        { className: "buttons" },
        button("Save picture", actions.save),
        button("Copy link", actions.copy),
        button("Reset", () => store.reset()),
      ),
    ].filter((one): one is HTMLElement => one !== null),
  );
  const update = () => shown.forEach((one) => one.update());
  store.listen(update);
  update();
  return update;
}

/** A button only where the device has the sensor. */
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

/** A button only where there is a headset. */
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

function eyeGroup(store: Store, field: Field, actions: Actions, shown: Shown[]): HTMLElement {
  const { state } = store;
  const showsOne = () => store.fields.length < 2 || state.compare === "first" || state.compare === "second";
  const slope = (axis: 0 | 1) => state.eye[axis] / state.eye[2];
  const move = (axis: 0 | 1, share: number) => {
    const eye = [...state.eye];
    eye[axis] = slopeInZone(axis === 0 ? field.across : field.up, share) * eye[2];
    store.set({ eye });
  };
  const zone = (label: string, axis: 0 | 1) =>
    slider(
      {
        label,
        applies: () => (axis === 0 ? field.across : field.up).views > 1,
        range: () => [0, 1],
        value: () => shareOfZone(axis === 0 ? field.across : field.up, slope(axis)),
        text: () => `${rounded(state.eye[axis], 1)}\u2009mm`,
        set: (share) => move(axis, share),
        reset: () => move(axis, 0.5),
      },
      shown,
    );
  const home = () => field.eye_mm[2];
  return group(
    "Eye",
    zone("Left to right", 0),
    zone("Down to up", 1),
    slider(
      {
        label: "Distance",
        unit: "mm",
        range: () => [-2, 2],
        value: () => Math.log2(state.eye[2] / home()),
        text: () => `${rounded(state.eye[2], 0)}\u2009mm`,
        set: (power) => {
          const z = home() * 2 ** power;
          store.set({ eye: [slope(0) * z, slope(1) * z, z] });
        },
      },
      shown,
    ),
    tiltButton(actions.tilt, shown),
    headsetButton(actions.headset, shown),
    choice("Two eyes", "stereo", [["off", "Off"], ["anaglyph", "Anaglyph, red and cyan"], ["side-by-side", "Side by side"], ["top-bottom", "Top and bottom"]], store, shown, showsOne),
    slider({ label: "Eye separation", unit: "mm", applies: () => showsOne() && state.stereo !== "off", range: () => [0, Math.max(80, state.separation)], value: () => state.separation, set: (separation) => store.set({ separation }) }, shown),
  );
}

function focusGroup(store: Store, actions: Actions, shown: Shown[]): HTMLElement {
  const { state } = store;
  return group(
    "Focus",
    slider({ label: "Aperture", range: () => [0, 1], value: () => state.aperture, text: (value) => (value === 0 ? "all in focus" : `${rounded(100 * value, 0)}\u2009% of the zone`), set: (aperture) => store.set({ aperture }) }, shown),
    slider({ label: "Depth in focus", unit: "mm", applies: () => state.aperture > 0, range: actions.focusRange, value: () => state.focus, set: (focus) => store.set({ focus }) }, shown),
  );
}

function pictureGroup(store: Store, field: Field, actions: Actions, hasViews: () => boolean, shown: Shown[]): HTMLElement {
  const { state } = store;
  return group(
    "Picture",
    showChoice(store, hasViews, shown),
    choice("Between views", "between", [["depth", "Moved by their depth"], ["blend", "Blended"]], store, shown, () => field.depth),
    check("Show single lenses", () => state.lenses, (lenses) => store.set({ lenses }), shown, () => field.lens_samples.some(Boolean)),
    slider({ label: "Crosstalk", late: () => asksForCrosstalk(field), applies: () => (hasCrosstalk(field) || (asksForCrosstalk(field) && actions.live === null && !actions.print?.isSeen)) && state.show === "eye" && state.aperture === 0, range: () => [0, Math.max(2, state.crosstalk)], value: () => state.crosstalk, text: (value) => (value === 0 ? "none" : `${rounded(value, 2)}\u2009px, ${rounded(100 * neighbourShare(value), 1)}\u2009%`), set: (crosstalk) => store.set({ crosstalk: Math.round(100 * crosstalk) / 100 }), reset: () => store.set({ crosstalk: 0 }) }, shown),
    choice("Overlay", "overlay", [["none", "None"], ["provenance", "Where pixels came from"], ["missed", "Missed pixels"]], store, shown, () => field.provenance !== null && state.show !== "display"),
    check("Epipolar-plane image", () => state.line >= 0, (on) => store.set({ line: on ? 0.5 : -1 }), shown, () => field.across.views > 1),
    slider({ label: "Line, from the top", applies: () => state.line >= 0, range: () => [0, 1], value: () => state.line, text: (value) => `${rounded(100 * value, 0)}\u2009%`, set: (line) => store.set({ line }) }, shown),
    slider({ label: "Exposure", applies: () => state.show !== "display", range: () => [-4, 4], steps: 80, value: () => state.exposure, text: (value) => `${value > 0 ? "+" : ""}${rounded(value, 1)}\u2009EV`, set: (exposure) => store.set({ exposure }), reset: () => store.set({ exposure: 0 }) }, shown),
    check("Light background", () => state.theme === "light", (on) => store.set({ theme: on ? "light" : "dark" }), shown),
  );
}

/** Eyes are for light fields, and not for a panel, which shows what it is given wherever they are. */
function onlyIf(applies: () => boolean, made: HTMLElement, shown: Shown[]): HTMLElement {
  shown.push({ update: () => (made.hidden = !applies()) });
  return made;
}

/** A panel to play on may be dropped on the page. */
function showChoice(store: Store, hasViews: () => boolean, shown: Shown[]): HTMLElement {
  const row = choice("Show", "show", [["eye", "What the eye sees"], ["panel", "What the panel shows"], ["display", "Played on a calibrated panel"]], store, shown, () => hasViews() || store.plays);
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
  calibration.title = "visual.json of the panel; it may be dropped on the page, too";
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
