// Handles the mouse, touches on the picture, and the keyboard.
import { toggleKeyList } from "./keys";
import type { Live } from "./live";
import { orbitOf, planeDistance, setOrbit, setZoom } from "./live_controls";
import type { Motion } from "./motion";
import type { Rectangle } from "./pair";
import type { Player } from "./player";
import type { Print } from "./print";
import type { Renderer } from "./renderer";
import type { Store } from "./state";
import type { Timeline } from "./timeline";

interface Page {
  readonly canvas: HTMLCanvasElement;
  readonly renderer: Renderer;
  readonly store: Store;
  readonly timeline: Timeline;
  readonly player: Player;
  readonly motion: Motion;
  readonly live: Live | null;
  readonly print: Print | null;
  shown(): number[];
  redraw(): void;
  /** Ends the automatic motion. stays: the eye stays where it was drawn. */
  touched(stays: boolean): void;
  shares(): [number, number];
  moveEye(across: number, up: number): void;
  focusAt(share: [number, number]): void;
  movePlane(from: number, share: number): void;
  putPlaneAt(share: [number, number]): void;
  putZeroPlaneAt(share: [number, number]): void;
}

export interface Place {
  x: number;
  y: number;
}

interface Drag extends Place {
  finger: number;
  moved: boolean;
  what: "eye" | "wipe" | "line" | "turn" | "plane" | "pan" | "zero plane";
  shares: [number, number];
  orbit: [number, number];
  plane: number;
  pan: [number, number];
  shift: number;
  /** The picture whose wipe line is dragged. */
  wiped: Rectangle;
}

/** The distance between two fingers and the point midway between them, at the last event. */
interface Pinch {
  apart: number;
  middle: Place;
}

const kDoubleClickMs = 400;
const kDoubleClickPx = 24;

function isOfControl({ target, key }: KeyboardEvent): boolean {
  if (target instanceof HTMLButtonElement || (target instanceof Element && target.closest("summary"))) return key === " ";
  if (target instanceof HTMLInputElement && target.type === "checkbox") return key === " ";
  if (target instanceof HTMLInputElement && target.type === "range") return key.startsWith("Arrow") || key === "Home";
  return target instanceof HTMLInputElement || target instanceof HTMLSelectElement;
}

export class Hands {
  /** Position of the mouse, of a finger, or of the loupe that arrow keys move. */
  pointer: Place | null = null;
  private drag: Drag | null = null;
  private readonly fingers = new Map<number, Place>();
  private pinch: Pinch | null = null;
  private lastClick: (Place & { at: number }) | null = null;

  constructor(private readonly app: Page) {
    const { canvas } = app;
    canvas.addEventListener("pointerdown", (event) => this.down(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerup", (event) => this.up(event));
    canvas.addEventListener("pointercancel", (event) => {
      this.fingers.delete(event.pointerId);
      this.pinch = null;
      this.giveUpDrag();
    });
    canvas.addEventListener("pointerleave", () => this.leave());
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    window.addEventListener("keydown", (event) => this.key(event));
    // Touching any control also ends the automatic motion of the eye.
    window.addEventListener("pointerdown", (event) => event.target !== canvas && this.app.touched(true), { capture: true });
    // After a click with a pointer, keys apply to the picture instead of the clicked button.
    window.addEventListener("click", (event) => {
      if (event.detail > 0 && event.target instanceof Element && event.target.closest("button") && !event.target.closest("dialog")) canvas.focus({ preventScroll: true });
    });
  }

  // ---- Pointers ----------------------------------------------------------------------------------------------------------

  private at(event: { clientX: number; clientY: number }): Place {
    const box = this.app.canvas.getBoundingClientRect();
    const [width, height] = this.app.renderer.screen;
    return { x: ((event.clientX - box.left) / box.width) * width, y: ((event.clientY - box.top) / box.height) * height };
  }

  private down(event: PointerEvent): void {
    const { app } = this;
    const at = this.at(event);
    this.fingers.set(event.pointerId, at);
    app.touched(true);
    if (this.fingers.size > 1) return this.beginPinch();
    app.canvas.setPointerCapture(event.pointerId);
    const { live, store } = app;
    this.drag = {
      ...at,
      finger: event.pointerId,
      moved: false,
      what: event.button === 0 ? this.graspedAt(at) : "pan",
      shares: app.shares(),
      orbit: live ? orbitOf(live) : [0, 0],
      plane: live ? planeDistance(live) : 1,
      pan: [...store.state.pan],
      shift: app.print?.settings.shift ?? 0,
      wiped: this.wipedAt(at) ?? app.renderer.place,
    };
  }

  private move(event: PointerEvent): void {
    const at = this.at(event);
    this.pointer = at;
    this.app.redraw();
    if (this.fingers.has(event.pointerId)) this.fingers.set(event.pointerId, at);
    if (this.pinch) return this.pinchTo();
    if (event.pointerType === "mouse" && this.fingers.size === 0) this.hover(at);
    const { drag } = this;
    if (!drag || drag.finger !== event.pointerId) return;
    if (Math.hypot(at.x - drag.x, at.y - drag.y) > 4) drag.moved = true;
    if (drag.moved) this.dragTo(drag, at);
  }

  private up(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    this.pinch = null;
    const { drag } = this;
    if (drag && !drag.moved && event.button === 0) this.click(this.at(event));
    if (drag?.moved && drag.what === "zero plane") this.app.print?.dropPlane();
    if (event.pointerType !== "mouse") this.pointer = null;
    this.drag = null;
    this.app.redraw();
  }

  private leave(): void {
    this.pointer = null;
    this.app.motion.hover(null);
    this.app.redraw();
  }

  private hover(at: Place): void {
    const { left, top, width, height } = this.app.renderer.place;
    const within = (share: number) => Math.min(Math.max(share, 0), 1);
    this.app.motion.hover([within((at.x - left) / width), within(1 - (at.y - top) / height)]);
  }

  /** Undoes the drag of the first finger, because a second finger has touched. */
  private giveUpDrag(): void {
    if (this.drag?.moved) this.dragTo(this.drag, this.drag);
    this.drag = null;
  }

  private held(): Pinch {
    const [a, b] = [...this.fingers.values()];
    return { apart: Math.max(1, Math.hypot(a.x - b.x, a.y - b.y)), middle: { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 } };
  }

  private beginPinch(): void {
    this.giveUpDrag();
    this.pinch = this.fingers.size === 2 ? this.held() : null;
  }

  private pinchTo(): void {
    if (!this.pinch || this.fingers.size !== 2) return;
    const now = this.held();
    this.panBy(now.middle.x - this.pinch.middle.x, now.middle.y - this.pinch.middle.y);
    this.zoomAt(now.apart / this.pinch.apart, now.middle);
    this.pinch = now;
  }

  private graspedAt({ x, y }: Place): Drag["what"] {
    const { app } = this;
    const { state } = app.store;
    const { top, height } = app.renderer.place;
    if (this.wipedAt({ x, y })) return "wipe";
    if (state.line >= 0 && Math.abs(y - top - state.line * height) < this.near) return "line";
    if (app.print?.awaitsClick) return "zero plane";
    return app.live ? state.drag : "eye";
  }

  /** Largest distance from a line, in pixels of the canvas, at which a press grasps the line. */
  private get near(): number {
    return 14 * (this.app.renderer.screen[0] / this.app.canvas.clientWidth);
  }

  /** Returns the picture whose wipe line is at a point, or null. */
  private wipedAt({ x, y }: Place): Rectangle | null {
    const { renderer, store } = this.app;
    if (this.app.shown().length < 2 || store.state.compare !== "wipe") return null;
    const isHere = ({ left, top, width, height }: Rectangle) => y >= top && y <= top + height && Math.abs(x - left - store.state.wipe * width) < this.near;
    return [renderer.place, renderer.besidePlace].find((one) => one && isHere(one)) ?? null;
  }

  private dragTo(drag: Drag, at: Place): void {
    const { app } = this;
    const { store, live, print } = app;
    const { top, width, height } = app.renderer.place;
    const [across, down] = [(at.x - drag.x) / width, (at.y - drag.y) / height];
    if (drag.what === "wipe") store.set({ wipe: (at.x - drag.wiped.left) / drag.wiped.width });
    else if (drag.what === "line") store.set({ line: Math.min(Math.max((at.y - top) / height, 0), 1) });
    else if (drag.what === "pan") this.panTo(drag.pan[0] + (at.x - drag.x) / app.renderer.fitted.width, drag.pan[1] + (at.y - drag.y) / app.renderer.fitted.height);
    else if (drag.what === "zero plane") print?.dragPlane(drag.shift, across);
    else if (live && drag.what === "turn") setOrbit(live, drag.orbit[0] - 180 * across, drag.orbit[1] + 90 * down);
    else if (live && drag.what === "plane") app.movePlane(drag.plane, -down);
    else if (store.state.show === "eye") app.moveEye(drag.shares[0] + across, drag.shares[1] - down);
  }

  private click(at: Place): void {
    const { app } = this;
    const { state } = app.store;
    const share = app.renderer.shareAt(state, at.x, at.y);
    const before = this.lastClick;
    const now = performance.now();
    const isDouble = before !== null && now - before.at < kDoubleClickMs && Math.hypot(at.x - before.x, at.y - before.y) < kDoubleClickPx;
    this.lastClick = isDouble ? null : { ...at, at: now };
    if (!share || state.show !== "eye") return;
    if (app.print?.awaitsClick) return app.putZeroPlaneAt(share);
    if (app.live && state.drag === "plane") return app.putPlaneAt(share);
    if (isDouble) app.focusAt(share);
  }

  // ---- Zoom --------------------------------------------------------------------------------------------------------------

  /** Zooms about a point of the canvas, which stays in place. */
  zoomAt(factor: number, at: Place): void {
    const { state } = this.app.store;
    const { fitted, mostMagnified } = this.app.renderer;
    const magnify = Math.min(Math.max(state.magnify * factor, 0.1), mostMagnified);
    const by = magnify / state.magnify;
    const moved = [at.x, at.y].map((place, i) => {
      const side = i === 0 ? fitted.width : fitted.height;
      const centre = fitted.centre[i] + state.pan[i] * side;
      return (place + (centre - place) * by - fitted.centre[i]) / side;
    });
    this.app.store.set({ magnify });
    this.panTo(moved[0], moved[1]);
  }

  fit(): void {
    this.app.store.set({ magnify: 1, pan: [0, 0] });
  }

  /** Shows one pixel of the views or of the panel per pixel of the screen. */
  showTrueSize(): void {
    this.app.store.set({ magnify: this.app.renderer.magnifiedForTrueSize(this.app.store.state), pan: [0, 0] });
  }

  private panBy(x: number, y: number): void {
    const { pan } = this.app.store.state;
    const { fitted } = this.app.renderer;
    this.panTo(pan[0] + x / fitted.width, pan[1] + y / fitted.height);
  }

  /** Keeps the middle of the screen on the picture. */
  private panTo(x: number, y: number): void {
    const most = this.app.store.state.magnify / 2;
    this.app.store.set({ pan: [x, y].map((share) => Math.min(Math.max(share, -most), most)) });
  }

  /** Browsers send pinches on touchpads as wheel events with Ctrl. */
  private wheel(event: WheelEvent): void {
    const { app } = this;
    event.preventDefault();
    app.touched(true);
    if (app.player.isPlaying && !app.live) return;
    const steps = -event.deltaY / (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 3 : 100);
    const limited = Math.min(Math.max(steps, -2), 2);
    if (app.live && app.store.state.drag === "turn" && !event.ctrlKey) return setZoom(app.live, app.live.number("zoom", 1) * 2 ** (limited / 8));
    this.zoomAt(2 ** (limited * (event.ctrlKey ? 1 : 0.25)), this.at(event));
  }

  // ---- Keys --------------------------------------------------------------------------------------------------------------

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || document.querySelector("dialog[open]")) return;
    const action = this.actionOf(event);
    if (!action || isOfControl(event)) return;
    event.preventDefault();
    this.app.touched(event.key.startsWith("Arrow"));
    action();
  }

  private actionOf({ key, shiftKey }: KeyboardEvent): (() => void) | undefined {
    const { app } = this;
    const { store } = app;
    const by = shiftKey ? 0.01 : 0.05;
    const middle = () => ({ x: app.renderer.screen[0] / 2, y: app.renderer.screen[1] / 2 });
    const actions: Record<string, () => void> = {
      ArrowLeft: () => this.arrow(-1, 0, by),
      ArrowRight: () => this.arrow(1, 0, by),
      ArrowUp: () => this.arrow(0, -1, by),
      ArrowDown: () => this.arrow(0, 1, by),
      Home: () => (this.fit(), app.moveEye(0.5, 0.5)),
      " ": () => app.timeline.toggle(),
      ",": () => app.timeline.step(-1),
      ".": () => app.timeline.step(1),
      "+": () => this.zoomAt(2 ** 0.25, middle()),
      "=": () => this.zoomAt(2 ** 0.25, middle()),
      "-": () => this.zoomAt(2 ** -0.25, middle()),
      "0": () => this.fit(),
      "1": () => this.showTrueSize(),
      "?": () => toggleKeyList(app.live !== null),
      f: () => void app.player.toggleFullScreen(),
      c: () => app.focusAt([0.5, 0.5]),
      a: () => store.set({ aperture: store.state.aperture > 0 ? 0 : 0.5 }),
      p: () => store.set({ show: store.state.show === "panel" ? "eye" : "panel" }),
    };
    return actions[key.length === 1 ? key.toLowerCase() : key];
  }

  /** Arrow keys move the eye. If the panel is shown, arrow keys move the loupe instead. If a scene is set up, arrow keys
   *  move what dragging moves. */
  private arrow(x: number, y: number, by: number): void {
    const { app } = this;
    const { live } = app;
    const { show, drag } = app.store.state;
    if (show === "panel") return this.moveLoupe(x, y);
    if (live && drag === "turn") return setOrbit(live, orbitOf(live)[0] + 5 * x, orbitOf(live)[1] - 5 * y);
    if (live && drag === "plane") return app.movePlane(planeDistance(live), -0.02 * y);
    const [across, up] = app.shares();
    if (show === "eye") app.moveEye(across + by * x, up - by * y);
  }

  private moveLoupe(x: number, y: number): void {
    const { left, top, width, height } = this.app.renderer.place;
    const at = this.pointer ?? { x: left + width / 2, y: top + height / 2 };
    this.pointer = { x: Math.min(Math.max(at.x + x * 8, left), left + width), y: Math.min(Math.max(at.y + y * 8, top), top + height) };
    this.app.redraw();
  }
}
