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
