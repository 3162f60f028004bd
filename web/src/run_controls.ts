import { button, element, group, type Shown } from "./elements";
import type { Run } from "./run";

const kOrders: Record<string, string> = { running: "Stop", starting: "Stop", stopping: "Stopping\u2026", stopped: "Resume" };

/** Stop and Resume are one button with a changing label, so that the keyboard focus stays. */
export function runGroup(run: Run, shown: Shown[]): HTMLElement {
  const status = element("output", { className: "value job" });
  status.setAttribute("aria-live", "off");  // screen readers must not read the text, which changes every second
  const bar = element("progress", {});
  bar.setAttribute("aria-label", "Render");
  const order = button("", () => void run.toggle());
  const buttons = element("div", { className: "buttons" }, order);
  shown.push({
    update: () => {
      const { done, frames, state, folder } = run.state;
      status.value = `${run.describe()}\n${folder}`;
      bar.max = frames;
      if (done === 0 && run.isUnderWay) bar.removeAttribute("value");
      else bar.value = done;
      bar.hidden = state === "finished";
      order.textContent = kOrders[state] ?? "";
      order.setAttribute("aria-disabled", String(state === "stopping"));
      buttons.hidden = !(state in kOrders);
    },
  });
  return group("Render", element("div", { className: "row panel" }, status), bar, buttons);
}
