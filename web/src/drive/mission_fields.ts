import type { BuildingStore } from "../building/building_store";
import { element } from "../page/element";
import { name_pattern } from "../page/names";
import type { SessionStore } from "../sessions/session_store";
import { text } from "../text";
import { fresh_name } from "./mission_forms";
import type { Field, MissionForm } from "./mission_forms";

type Input = HTMLInputElement | HTMLSelectElement;

function option(value: string, label = value): HTMLOptionElement {
  return element("option", { value }, label);
}

/** The fields of one mission's form; their lists show what is stored on the server. */
export class MissionFields {
  readonly elements: HTMLElement[];
  readonly #inputs = new Map<Field, Input>();
  readonly #proposals = new Map<Field, string>();

  constructor(
    form: MissionForm,
    private readonly buildings: BuildingStore,
    private readonly sessions: SessionStore,
    private readonly keeps_buildings: () => boolean,
  ) {
    this.elements = form.fields.map((field) => this.#labelled(field));
    this.refill();
  }

  values(): Record<string, string | boolean> {
    const read = (input: Input) =>
      input instanceof HTMLInputElement && input.type === "checkbox" ? input.checked : input.value.trim();
    return Object.fromEntries([...this.#inputs].map(([{ key }, input]) => [key, read(input)]));
  }

  refill(): void {
    for (const [field, input] of this.#inputs) {
      if (input instanceof HTMLSelectElement) this.#refill_list(field, input);
      else if (this.#shall_propose(field)) this.#propose(field, input);
    }
  }

  /** Proposes a name that is not taken, unless the user has written one. */
  #propose(field: Field, input: HTMLInputElement): void {
    if (input.value !== (this.#proposals.get(field) ?? "")) return;
    input.value = this.#proposed(field);
    this.#proposals.set(field, input.value);
  }

  #shall_propose(field: Field): boolean {
    return field.is_needed === true || (field.is_proposed === true && this.keeps_buildings());
  }

  #labelled(field: Field): HTMLElement {
    const input = this.#input(field);
    this.#inputs.set(field, input);
    const caption = element("span", {}, field.label);
    return field.kind === "yes"
      ? element("label", { class: "tick" }, input, caption)
      : element("label", { class: "field" }, caption, input);
  }

  #input(field: Field): Input {
    if (field.kind === "yes") return element("input", { type: "checkbox" });
    if (["building", "session", "route", "place", "method"].includes(field.kind)) {
      const list = element("select", { required: field.is_needed });
      if (field.kind === "building")
        list.addEventListener("change", () => void this.buildings.choose(list.value));
      return list;
    }
    const placeholder = field.is_needed
      ? ""
      : field.kind === "text"
        ? text.fields.default
        : text.fields.not_saved;
    if (field.kind === "count")
      return element("input", { type: "number", min: 1, max: 1000, step: 1, placeholder: "1" });
    const pattern = field.kind === "text" ? undefined : name_pattern;
    return element("input", {
      type: "text",
      placeholder,
      pattern,
      required: field.is_needed,
      autocomplete: "off",
      spellcheck: "false",
    });
  }

  #refill_list(field: Field, list: HTMLSelectElement): void {
    const selected = field.kind === "building" ? this.buildings.chosen.value : list.value;
    const names = this.#names(field);
    const first = field.is_needed ? [] : [option("", text.fields.default)];
    list.replaceChildren(...first, ...names.map((name) => option(name)));
    if (names.includes(selected)) list.value = selected;
  }

  #names(field: Field): string[] {
    const building = this.buildings.building.value;
    if (field.kind === "building") return this.buildings.names.value;
    if (field.kind === "session") return (this.sessions.sessions.value ?? []).map(({ name }) => name);
    if (field.kind === "route") return (building?.routes ?? []).map(({ name }) => name);
    if (field.kind === "place") return (building?.places ?? []).map(({ name }) => name);
    return field.choices ?? [];
  }

  #proposed({ kind }: Field): string {
    if (kind === "new_building") return fresh_name("building", this.buildings.names.value);
    if (kind === "new_session")
      return fresh_name(
        "taught-",
        (this.sessions.sessions.value ?? []).map(({ name }) => name),
      );
    return "";
  }
}
