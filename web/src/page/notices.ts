import { text } from "../text";
import { button, element } from "./element";

const shown_ms = 8000;
const open_max = 3;
const logged_max = 200;

export type NoticeKind = "good" | "result" | "trouble";

/**
 * Messages at the top of the page, in its flow, so that they cover nothing. Results and trouble stay until they are
 * dismissed; all are kept in a log.
 */
export class Notices {
  readonly element = element("div", { class: "notices", role: "status", "aria-live": "polite" });
  /** Opens the log. */
  readonly opener: HTMLElement;
  readonly #log = element("ol", { class: "log", tabindex: 0, "aria-label": text.messages.title });
  readonly #drawer = element("section", { class: "drawer", hidden: true }, this.#log);
  /** The newest first. */
  #kept: { time: string; message: string; kind: NoticeKind }[] = [];

  constructor() {
    const opener = button(
      text.messages.log,
      () => {
        this.#drawer.hidden = !this.#drawer.hidden;
        opener.setAttribute("aria-expanded", String(!this.#drawer.hidden));
        this.#show_log();
      },
      { "aria-expanded": "false", title: text.messages.show_log },
    );
    this.opener = opener;
  }

  /** The open messages and the log. */
  get area(): HTMLElement {
    return element("div", { class: "message-area" }, this.element, this.#drawer);
  }

  show(message: string, kind: NoticeKind = "good"): void {
    this.#keep(message, kind);
    const open = [...this.element.children].find((child) => child.firstChild?.textContent === message);
    open?.remove();
    if (kind === "result") this.element.querySelector(".result")?.remove();
    const notice = element("p", { class: `notice ${kind}` }, element("span", {}, message));
    notice.append(button("×", () => notice.remove(), { "aria-label": text.messages.close }));
    this.element.append(notice);
    while (this.element.childElementCount > open_max) this.element.firstElementChild?.remove();
    if (kind === "good") setTimeout(() => notice.remove(), shown_ms);
  }

  /** Waits for the action and shows the reason if it fails. @returns whether it succeeded */
  async attempt(action: Promise<unknown>, done = ""): Promise<boolean> {
    try {
      await action;
      if (done !== "") this.show(done);
      return true;
    } catch (problem) {
      this.show(sentence(problem instanceof Error ? problem.message : String(problem)), "trouble");
      return false;
    }
  }

  #keep(message: string, kind: NoticeKind): void {
    const time = new Date().toLocaleTimeString();
    this.#kept = [{ time, message, kind }, ...this.#kept].slice(0, logged_max);
    this.#show_log();
  }

  #show_log(): void {
    if (this.#drawer.hidden) return;
    const lines = this.#kept.map(({ time, message, kind }) =>
      element("li", { class: kind }, element("time", {}, time), " ", message),
    );
    const nothing = element("li", { class: "about" }, text.messages.nothing);
    this.#log.replaceChildren(...(lines.length > 0 ? lines : [nothing]));
  }
}

/** The program's problem as a sentence: a capital first, and a full stop. */
export function sentence(problem: string): string {
  const trimmed = problem.trim();
  return trimmed === "" || /[.!?]$/.test(trimmed) ? trimmed : `${trimmed}.`;
}
