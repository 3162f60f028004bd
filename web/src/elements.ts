// Makes controls: rows of a label and a native element, groups of rows, and buttons.

export interface Shown {
  update: () => void;
}

export function element<Name extends keyof HTMLElementTagNameMap>(name: Name, properties: Partial<HTMLElementTagNameMap[Name]> = {}, ...children: (Node | string)[]): HTMLElementTagNameMap[Name] {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

export const rounded = (value: number, digits: number): string => value.toFixed(digits).replace(/^-0(\.0*)?$/, "0$1").replace("-", "\u2212");

let nextId = 0;

interface SliderSettings {
  label: string;
  unit?: string;
  range: () => [number, number];
  steps?: number;
  value: () => number;
  text?: (value: number) => string;
  set: (value: number) => void;
  reset?: () => void;
  /** If true, the value is set only when the slider is released, because the server must compute the result. */
  late?: () => boolean;
  applies?: () => boolean;
}

export function slider(settings: SliderSettings, shown: Shown[]): HTMLElement {
  const id = `control-${nextId++}`;
  const input = element("input", { type: "range", id });
  const text = settings.text ?? ((value: number) => `${rounded(value, 1)}${settings.unit ? `\u2009${settings.unit}` : ""}`);
  const output = element("output", { className: "value" });
  output.setAttribute("for", id);
  input.addEventListener("input", () => (settings.late?.() ? (output.value = text(Number(input.value))) : settings.set(Number(input.value))));
  input.addEventListener("change", () => settings.late?.() && settings.set(Number(input.value)));
  if (settings.reset) input.addEventListener("dblclick", settings.reset);
  const row = element("div", { className: "row" }, element("label", { htmlFor: id }, settings.label), output, input);
  shown.push({
    update: () => {
      row.hidden = settings.applies !== undefined && !settings.applies();
      const [least, most] = settings.range();
      input.min = String(least);
      input.max = String(most);
      input.step = String((most - least) / (settings.steps ?? 200) || "any");
      const value = settings.value();
      if (document.activeElement !== input || Math.abs(Number(input.value) - value) > Number(input.step)) input.value = String(value);
      output.value = text(value);
      input.setAttribute("aria-valuetext", output.value);
    },
  });
  return row;
}

export function chooser(label: string, options: () => [string, string][], value: () => string, set: (value: string) => void, shown: Shown[], applies = () => true): HTMLElement {
  const id = `control-${nextId++}`;
  const select = element("select", { id });
  select.addEventListener("change", () => set(select.value));
  const row = element("div", { className: "row choice" }, element("label", { htmlFor: id }, label), select);
  let listed = "";
  shown.push({
    update: () => {
      row.hidden = !applies();
      const wanted = options();
      if (JSON.stringify(wanted) !== listed) select.replaceChildren(...wanted.map(([word, text]) => element("option", { value: word }, text)));
      listed = JSON.stringify(wanted);
      select.value = value();
    },
  });
  return row;
}

interface EntrySettings {
  label: string;
  value: () => string;
  set: (value: string) => void;
  applies: () => boolean;
  numeric?: boolean;
  /** Suggestions while typing. */
  choices?: string[];
}

/** Makes a row with a short text. The value is set when editing ends. */
export function entry(settings: EntrySettings, shown: Shown[]): HTMLElement {
  const id = `control-${nextId++}`;
  const input = element("input", { type: "text", id, inputMode: settings.numeric ? "decimal" : "text", autocomplete: "off", spellcheck: false });
  const row = element("div", { className: "row entry" }, element("label", { htmlFor: id }, settings.label), input);
  if (settings.choices) {
    input.setAttribute("list", `${id}-choices`);
    row.append(element("datalist", { id: `${id}-choices` }, ...settings.choices.map((value) => element("option", { value }))));
  }
  input.addEventListener("change", () => settings.set(input.value.trim()));
  shown.push({
    update: () => {
      row.hidden = !settings.applies();
      if (document.activeElement !== input) input.value = settings.value();
    },
  });
  return row;
}

export function check(label: string, value: () => boolean, set: (on: boolean) => void, shown: Shown[], applies = () => true): HTMLElement {
  const id = `control-${nextId++}`;
  const input = element("input", { type: "checkbox", id });
  input.addEventListener("change", () => set(input.checked));
  const row = element("div", { className: "row check" }, input, element("label", { htmlFor: id }, label));
  shown.push({
    update: () => {
      row.hidden = !applies();
      input.checked = value();
    },
  });
  return row;
}

export function group(title: string, ...rows: (HTMLElement | null)[]): HTMLElement {
  const kept = rows.filter((row): row is HTMLElement => row !== null);
  const id = `group-${nextId++}`;
  const section = element("section", {}, element("h2", { id }, title), ...kept);
  section.setAttribute("aria-labelledby", id);
  return section;
}

export function tip<Row extends HTMLElement | null>(text: string, row: Row): Row {
  if (row) row.title = text;
  return row;
}

export function folded(title: string, ...groups: (HTMLElement | null)[]): HTMLElement {
  return element("details", {}, element("summary", {}, title), ...groups.filter((one): one is HTMLElement => one !== null));
}

export function button(text: string, action: () => void): HTMLButtonElement {
  const made = element("button", { type: "button" }, text);
  made.addEventListener("click", action);
  return made;
}
