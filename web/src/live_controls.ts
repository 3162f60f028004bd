import { button, check, chooser, element, group, rounded, slider, tip, type Shown } from "./elements";
import type { Field } from "./field";
import type { Live, Rendered } from "./live";
import { minutes } from "./run";
import type { Store } from "./state";

const kNames: Record<string, string> = {
  lenticular: "Lenticular sheet",
  microlens: "Microlens array",
  multiview: "Views of a quilt",
  single: "One view",
  whitted: "Direct light (Whitted)",
  path: "Paths, all light",
  none: "None",
  neutral: "Neutral",
  agx: "AgX",
};
const named = (word: string): [string, string] => [word, kNames[word] ?? word];
const digits = (value: number, count = 3): string => String(Number(value.toPrecision(count)));

/** Yaw and pitch in degrees. */
export function orbitOf(live: Live): [number, number] {
  const [yaw, pitch] = live.value("orbit").split(",").map(Number);
  return [Number.isFinite(yaw) ? yaw : 0, Number.isFinite(pitch) ? pitch : 0];
}

export function setOrbit(live: Live, yaw: number, pitch: number): void {
  const around = ((((yaw + 180) % 360) + 360) % 360) - 180;
  live.set({ orbit: `${rounded(around, 1)},${rounded(Math.min(Math.max(pitch, -89), 89), 1)}`.replace(/\u2212/g, "-") });
}

export function setZoom(live: Live, zoom: number): void {
  live.set({ zoom: digits(Math.min(Math.max(zoom, 0.1), 20)) });
}

/** The nearest and the farthest distance of the display's plane: slightly before and behind the subject. */
export function planeRange(live: Live): [number, number] {
  const plane = live.state?.plane;
  if (!plane) return [0, 1];
  const deep = Math.max(plane.farthest - plane.nearest, 0.02 * plane.distance);
  const now = planeDistance(live);
  return [Math.min(Math.max(plane.nearest - 0.25 * deep, 0.05 * plane.distance), now), Math.max(plane.farthest + 0.25 * deep, now)];
}

export const planeDistance = (live: Live): number => live.pendingNumber("focus") ?? live.state?.plane?.distance ?? 1;

export function setPlaneDistance(live: Live, distance: number): void {
  live.set({ focus: digits(distance, 5) });
}

function coneOf(field: Field): number {
  const { across } = field;
  const last = across.first + across.step * (across.views - 0.5);
  const first = across.first - 0.5 * across.step;
  const angle = (place: number) => (across.by === "angle" ? place : Math.atan(place));
  return Math.abs(((angle(last) - angle(first)) * 180) / Math.PI);
}

function viewGroup(store: Store, live: Live, shown: Shown[]): HTMLElement {
  const { state } = store;
  return group(
    "Set-up",
    chooser(
      "Dragging the picture",
      () => [["turn", "Turns the scene"], ["eye", "Moves the eye"], ["plane", "Moves the display plane"]],
      () => state.drag,
      (drag) => store.set({ drag }),
      shown,
    ),
    slider({ label: "Turn", range: () => [-180, 180], steps: 360, value: () => orbitOf(live)[0], text: (yaw) => `${rounded(yaw, 1)}\u00b0`, set: (yaw) => setOrbit(live, yaw, orbitOf(live)[1]), reset: () => live.set({ orbit: null }) }, shown),
    slider({ label: "Raise", range: () => [-89, 89], steps: 178, value: () => orbitOf(live)[1], text: (pitch) => `${rounded(pitch, 1)}\u00b0`, set: (pitch) => setOrbit(live, orbitOf(live)[0], pitch), reset: () => live.set({ orbit: null }) }, shown),
    slider({ label: "Zoom", range: () => [-2, 4], steps: 120, value: () => Math.log2(live.number("zoom", 1)), text: () => `${digits(live.number("zoom", 1))}\u00d7`, set: (power) => setZoom(live, 2 ** power), reset: () => live.set({ zoom: null }) }, shown),
    tip("Its distance from the viewer, in units of the scene", slider({ label: "Display plane", applies: () => !!live.state?.plane, range: () => planeRange(live), value: () => planeDistance(live), text: (value) => digits(value, 4), set: (value) => setPlaneDistance(live, value), reset: () => live.set({ focus: null }) }, shown)),
    check("Fit the depth to the display", () => live.value("fit-depth") === "true" || (live.value("fit-depth") === "" && fitsByDefault(live)), (on) => live.set({ "fit-depth": String(on) }), shown),
    check("Show the depth budget", () => state.budget, (budget) => store.set({ budget }), shown, () => store.fields[0].depth),
  );
}

/** Default of the setting fit-depth, as in src/job/params.cpp. */
const fitsByDefault = (live: Live): boolean => live.value("display") !== "" || live.value("optics") !== "multiview";

function displayGroup(field: Field, live: Live, shown: Shown[]): HTMLElement {
  const presets = live.about.choices.display ?? [];
  const displays = (): [string, string][] => {
    const chosen = live.value("display");
    const others = chosen === "" || presets.includes(chosen) ? [] : [chosen];
    return [["", "None"], ...[...others, ...presets].map((name): [string, string] => [name, name.split("/").pop() ?? name])];
  };
  const free = () => live.value("display") === "";
  return group(
    "Display",
    chooser("Display", displays, () => live.value("display"), (display) => live.set({ display, optics: null, "view-angle": null }), shown),
    chooser("Optics", () => (live.about.choices.optics ?? []).map(named), () => live.value("optics") || "lenticular", (optics) => live.set({ optics }), shown, free),
    slider({ label: "Viewing cone", applies: () => field.across.views > 1, range: () => [2, 120], steps: 236, value: () => live.number("view-angle", coneOf(field)), text: (value) => `${rounded(value, 1)}\u00b0`, set: (angle) => live.set({ "view-angle": digits(angle) }), reset: () => live.set({ "view-angle": null }) }, shown),
  );
}

function lightGroup(live: Live, shown: Shown[]): HTMLElement {
  const environments = (): [string, string][] => {
    const usual: [string, string][] = [["", "As the scene has it"], ["studio", "Studio"], ["none", "None"], ["#ffffff", "White"], ["#808080", "Grey"], ["#7fa6d9", "Sky blue"]];
    const chosen = live.value("environment");
    return usual.some(([word]) => word === chosen) ? usual : [...usual, [chosen, chosen.split("/").pop() ?? chosen]];
  };
  return group(
    "Light",
    chooser("Shading", () => (live.about.choices.integrator ?? []).map(named), () => live.value("integrator"), (integrator) => live.set({ integrator }), shown),
    slider({ label: "Samples a pixel", range: () => [0, 10], steps: 10, value: () => Math.log2(Math.max(1, samplesOf(live))), text: () => String(samplesOf(live)), set: (power) => live.set({ spp: String(Math.round(2 ** power)) }), reset: () => live.set({ spp: null }) }, shown),
    chooser("Surroundings", environments, () => live.value("environment"), (environment) => live.set({ environment }), shown),
    slider({ label: "Exposure of the render", range: () => [-6, 6], steps: 120, value: () => live.number("exposure", 0), text: (value) => `${value > 0 ? "+" : ""}${rounded(value, 1)}\u2009EV`, set: (stops) => live.set({ exposure: digits(stops) }), reset: () => live.set({ exposure: null }) }, shown),
  );
}

export function lightDetails(live: Live, shown: Shown[]): HTMLElement {
  const paths = () => live.value("integrator") === "path";
  return group(
    "Light, in detail",
    chooser("Tone", () => (live.about.choices.tone ?? []).map(named), () => live.value("tone"), (tone) => live.set({ tone }), shown),
    slider({ label: "Surroundings' strength", applies: paths, range: () => [-4, 4], steps: 80, value: () => Math.log2(live.number("environment-strength", 1)), text: () => `${digits(live.number("environment-strength", 1))}\u00d7`, set: (power) => live.set({ "environment-strength": digits(2 ** power) }), reset: () => live.set({ "environment-strength": null }) }, shown),
    slider({ label: "Surroundings' turn", applies: paths, range: () => [-180, 180], steps: 360, value: () => live.number("environment-rotation", 0), text: (value) => `${rounded(value, 0)}\u00b0`, set: (angle) => live.set({ "environment-rotation": digits(angle) }), reset: () => live.set({ "environment-rotation": null }) }, shown),
  );
}

/** Samples per pixel; the setting 0 stands for the integrator's default (lippmann/frames/frame_params.hpp). */
function samplesOf(live: Live): number {
  const given = live.number("spp", 0);
  return given > 0 ? given : live.value("integrator") === "path" ? 16 : 1;
}

export function renderText(render: Rendered | null): string {
  if (!render) return "";
  const frames = `${render.done} of ${render.frames} frame${render.frames === 1 ? "" : "s"}`;
  if (render.state === "running") return render.frames === 0 ? "Setting up" : `${frames}${render.seconds_left === null ? "" : `, about ${minutes(render.seconds_left)} left`}`;
  if (render.state === "finished") return `Finished: ${render.folder}`;
  if (render.state === "stopped") return `Stopped after ${frames}: ${render.folder}`;
  return render.error;
}

export function jobGroup(live: Live, shown: Shown[]): HTMLElement {
  const status = element("output", { className: "value job" });
  const bar = element("progress", { max: 1 });
  bar.setAttribute("aria-label", "Render");
  const cancel = button("Cancel", () => live.cancel());
  const renders = [button("Render all frames", () => live.render("all")), button("Render this frame", () => live.render("this"))];
  const isRunning = () => live.state?.render?.state === "running";
  shown.push({
    update: () => {
      const { state } = live;
      const saved = state?.saved ? `Saved: ${state.saved}` : "";
      status.value = [saved, renderText(state?.render ?? null)].filter(Boolean).join("\n");
      bar.hidden = cancel.hidden = !isRunning();
      renders.forEach((one) => (one.hidden = isRunning()));
      bar.value = state?.render?.share ?? 0;
    },
  });
  const made = group("Render", element("div", { className: "buttons" }, ...renders, cancel, tip("A .toml that `lippmann render` takes", button("Save job", () => void live.save()))), bar, element("div", { className: "row panel" }, status));
  made.classList.add("job");
  return made;
}

export const setUpGroups = (store: Store, field: Field, live: Live, shown: Shown[]): HTMLElement[] => [
  viewGroup(store, live, shown),
  displayGroup(field, live, shown),
  lightGroup(live, shown),
];
