import { text } from "../text";

/** Makes DOM elements: attributes, listeners (`onclick`), children. */

type Child = Node | string | undefined;
type Attributes = Record<string, unknown>;

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value as EventListener);
    else made.setAttribute(name, value === true ? "" : String(value));
  }
  made.append(...children.filter((child): child is Node | string => child !== undefined));
  return made;
}

/** A labelled button that does not submit a form. */
export function button(label: string, onclick: () => void, attributes: Attributes = {}): HTMLButtonElement {
  return element("button", { type: "button", onclick, ...attributes }, label);
}

/** Sets the text; leaves the DOM alone if it is already the same. */
export function set_text(target: HTMLElement, text: string): void {
  if (target.textContent !== text) target.textContent = text;
}

export interface Choice {
  value: string;
  label: string;
}

/** A labelled drop-down list. */
export function select(label: string, choices: Choice[], onchange: (value: string) => void) {
  const list = element(
    "select",
    { onchange: () => onchange(list.value) },
    ...choices.map(({ value, label }) => element("option", { value }, label)),
  );
  return { field: element("label", { class: "field" }, element("span", {}, label), list), list };
}

/** A labelled check box. */
export function tick(
  label: string,
  checked: boolean,
  onchange: (checked: boolean) => void,
): HTMLLabelElement {
  const box = element("input", { type: "checkbox", checked, onchange: () => onchange(box.checked) });
  return element("label", { class: "tick" }, box, element("span", {}, label));
}

/** A panel with a heading. */
export function panel(title: string, name: string, ...children: Child[]): HTMLElement {
  const id = `${name}-title`;
  return element(
    "section",
    { class: `panel ${name}`, "aria-labelledby": id },
    element("h2", { id }, title),
    ...children,
  );
}

/** A button that acts once it has been held down, by a finger, the mouse or a key. */
export function hold_button(
  label: string,
  action: () => void,
  attributes: Attributes = {},
): HTMLButtonElement {
  const held_ms = 700;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const made = element(
    "button",
    { type: "button", title: text.held.hold, "aria-description": text.held.hold, ...attributes },
    label,
  );
  made.classList.add("hold");
  const release = () => {
    clearTimeout(timer);
    timer = undefined;
    made.classList.remove("held");
  };
  const press = () => {
    if (timer !== undefined || made.disabled) return;
    made.classList.add("held");
    timer = setTimeout(() => {
      release();
      action();
    }, held_ms);
  };
  made.addEventListener("pointerdown", press);
  for (const end of ["pointerup", "pointerleave", "pointercancel", "blur"])
    made.addEventListener(end, release);
  made.addEventListener("contextmenu", (event) => event.preventDefault());
  made.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    if (!event.repeat) press();
  });
  made.addEventListener("keyup", release);
  return made;
}
