// The controls of a render that runs or was stopped: how far it is, and one button that stops or resumes it.
import { button, element, group, type Shown } from "./elements";
import type { Run } from "./run";

const kOrders: Record<string, string> = { running: "Stop", starting: "Stop", stopping: "Stopping\u2026", stopped: "Resume" };

/** One button with two words, so that the keyboard stays on it. */
export function runGroup(run: Run, shown: Shown[]): HTMLElement {
  const said = element("output", { className: "value job" });
  said.setAttribute("aria-live", "off");  // it counts seconds
  const bar = element("progress", {});
  bar.setAttribute("aria-label", "Render");
  const order = button("", () => void run.toggle());
  const buttons = element("div", { className: "buttons" }, order);
  shown.push({
    update: () => {
      const { done, frames, state, folder } = run.state;
      said.value = `${run.describe()}\n${folder}`;
      bar.max = frames;
      bar.value = done;
      bar.hidden = state === "finished";
      order.textContent = kOrders[state] ?? "";
      order.setAttribute("aria-disabled", String(state === "stopping"));
      buttons.hidden = !(state in kOrders);
    },
  });
  return group("Render", element("div", { className: "row panel" }, said), bar, buttons);
}
