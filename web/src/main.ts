import { App, fail } from "./app";
import { expectPicture, loadFields } from "./data";
import { readDisplay } from "./display";
import { DropPage } from "./drop";
import { readFields, Refusal } from "./field";
import type { Choices } from "./live";
import { steerFromOutside } from "./outside";
import type { PrintChoices } from "./print";
import type { RunState } from "./run";

async function start(): Promise<void> {
  try {
    const json = await loadFields();
    const described = json as { drops?: boolean; fields?: unknown[] } | null;
    const drops = described?.drops === true;
    document.documentElement.dataset.theme = /[#&]theme=(dark|light)/.exec(location.hash)?.[1] ?? "system";
    if (drops && described?.fields?.length === 0) return void new DropPage(document.getElementById("failure") as HTMLElement);
    const fields = readFields(json);
    const { display, live, run, prints } = json as { display?: unknown; live?: Choices; run?: RunState; prints?: PrintChoices };
    const panel = display ?? live?.display;
    // The server makes the preview while the graphics start.
    if (fields[0].preview && fields.length === 1 && !panel && !run && !/[#&](frame|show|crosstalk)=/.test(location.hash)) expectPicture("0/preview/0");
    const app = new App(fields, panel ? readDisplay(panel) : null, live ?? null, run ?? null, { prints: prints ?? null, drops });
    steerFromOutside(app);
  } catch (error) {
    fail(error);
    if (!(error instanceof Refusal)) throw error;
  }
}

void start();
