// Reads data from a server, from scripts beside the page, or from the page itself. Pages opened from a disk cannot send
// requests, so they load scripts.
import { Refusal, type Field } from "./field";

interface Waiting {
  resolve: (blob: Blob) => void;
  reject: (error: Error) => void;
}

declare global {
  interface Window {
    lippmann_fields?: (json: unknown) => void;
    lippmann_data?: (name: string, type: string, base64: string) => void;
  }
}

type Source = "server" | "scripts" | "within";

const source = (): Source => (document.querySelector('meta[name="lippmann-data"]')?.getAttribute("content") ?? "server") as Source;
const isSaved = (): boolean => source() !== "server";

/** Whether the page can be saved as one file, which needs a server. */
export const canSavePage = (): boolean => !isSaved();

/** Returns whether the page's address works on this machine only. */
export const isLocalPage = (): boolean => /^(127\.|localhost(:|$)|\[::1\])/.test(location.host) || location.protocol === "file:";

/** Progress of a download; `of` is null if its size is unknown. */
export interface Progress {
  bytes: number;
  of: number | null;
}

function runScript(path: string): Promise<void> {
  return new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = path;
    script.onload = () => (script.remove(), resolve());
    script.onerror = () => (script.remove(), reject(new Refusal(`${path} is missing or cannot be read.`)));
    document.head.append(script);
  });
}

/** Retries a request once, because it fails if the server has just closed the connection. Requests that start a render are
 *  not retried, because they could start it twice. */
async function fetched(path: string, settings: RequestInit): Promise<Response> {
  try {
    return await fetch(path, settings);
  } catch (error) {
    if (path === "live/render") throw error;
    return fetch(path, settings);
  }
}

async function answerOf(path: string, settings: RequestInit = {}): Promise<Response> {
  let response: Response;
  try {
    response = await fetched(path, settings);
  } catch {
    throw new Refusal("The server does not answer; it may have been stopped.");
  }
  if (response.ok) return response;
  const text = await response.text();
  let reason = text.trim();
  try {
    reason = (JSON.parse(text) as { error: string }).error;
  } catch {
    // The error is plain text instead of JSON.
  }
  throw new Refusal(reason || `${path}: the server answers ${response.status}.`);
}

export async function postBytes(path: string, body: Blob): Promise<void> {
  await answerOf(path, { method: "POST", body, headers: { "Content-Type": "application/octet-stream" } });
}

export async function postText(path: string, body: string): Promise<string> {
  if (isSaved()) throw new Refusal("A saved page cannot read calibrations. Use `lippmann play`.");
  return (await answerOf(path, { method: "POST", body, headers: { "Content-Type": "text/plain" } })).text();
}

/** Returns whether the server must compute views with crosstalk, because the views are not made of whole pixels of the
 *  panel. */
export const asksForCrosstalk = (field: Field): boolean => !isSaved() && field.panel.is === "own" && field.across.views * field.up.views > 1;

export const readState = async (path: string): Promise<unknown> => (await answerOf(path)).json();

export async function loadFields(): Promise<unknown> {
  if (!isSaved()) {
    const text = await (await answerOf("fields.json")).text();
    try {
      return JSON.parse(text);
    } catch {
      throw new Refusal("The description of the light field is damaged: it is not JSON.");
    }
  }
  if (source() === "within") return JSON.parse(textWithin("fields"));
  let found: unknown;
  window.lippmann_fields = (json) => (found = json);
  await runScript("fields.js");
  if (found === undefined) throw new Refusal("fields.js is damaged: it has no description of this light field.");
  return found;
}

const waiting = new Map<string, Waiting>();

function blobOf(base64: string, type: string): Blob {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return new Blob([bytes], { type });
}

function receive(name: string, type: string, base64: string): void {
  const one = waiting.get(name);
  waiting.delete(name);
  try {
    one?.resolve(blobOf(base64, type));
  } catch {
    one?.reject(new Refusal(`${name}.js is damaged.`));
  }
}

function fromScript(name: string): Promise<Blob> {
  window.lippmann_data ??= receive;
  return new Promise((resolve, reject) => {
    waiting.set(name, { resolve, reject });
    runScript(`${name}.js`).then(() => {
      if (waiting.delete(name)) reject(new Refusal(`${name}.js is damaged: it contains no picture.`));
    }, reject);
  });
}

function textWithin(name: string): string {
  const text = document.getElementById(`data:${name}`)?.textContent;
  if (!text) throw new Refusal(`The page is damaged: it lacks ${name}.`);
  return text;
}

function pictureWithin(name: string): Blob {
  const text = textWithin(name);
  try {
    return blobOf(text, document.getElementById(`data:${name}`)?.dataset.type ?? "");
  } catch {
    throw new Refusal(`The page is damaged: ${name} cannot be read.`);
  }
}

/** Loads a path. Calls `progress` for each piece that arrives. */
export async function loadBytes(path: string, progress: (now: Progress) => void): Promise<Blob> {
  progress({ bytes: 0, of: null });
  const response = await answerOf(path);
  const stated = Number(response.headers.get("Content-Length"));
  const reader = response.body?.getReader();
  if (!reader) return response.blob();
  const pieces: Uint8Array<ArrayBuffer>[] = [];
  let bytes = 0;
  for (let next = await reader.read(); !next.done; next = await reader.read()) {
    pieces.push(next.value as Uint8Array<ArrayBuffer>);
    bytes += next.value.length;
    progress({ bytes, of: stated > 0 ? stated : null });
  }
  return new Blob(pieces, { type: response.headers.get("Content-Type") ?? "" });
}

const expected = new Map<string, Promise<Blob | null>>();

/** Requests a picture before the page is ready to show it. loadPicture() returns it later. */
export function expectPicture(name: string): void {
  if (!isSaved()) expected.set(name, loadBytes(name, () => {}).catch(() => null));
}

/** name: FIELD/views/FRAME, FIELD/preview/FRAME, FIELD/depth/FRAME or FIELD/panel/FRAME. */
export async function loadPicture(name: string, progress: (now: Progress) => void = () => {}): Promise<Blob> {
  if (source() === "within") return pictureWithin(name);
  const early = await expected.get(name);
  expected.delete(name);
  if (early) return early;
  return isSaved() ? fromScript(name) : loadBytes(name, progress);
}

export function download(blob: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // A busy browser may read the file after click() has returned.
  window.setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
