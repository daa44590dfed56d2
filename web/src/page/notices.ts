import { button, element } from "./element";

const shown_ms = 8000;

/** Short messages at the edge of the page; screen readers read them out. */
export class Notices {
  readonly element = element("div", { class: "notices", role: "status", "aria-live": "polite" });

  show(text: string, kind: "good" | "trouble" = "good"): void {
    const notice = element("p", { class: `notice ${kind}` }, text);
    const close = button("×", () => notice.remove(), { "aria-label": "Close this message" });
    notice.append(close);
    this.element.append(notice);
    while (this.element.childElementCount > 3) this.element.firstElementChild?.remove();
    setTimeout(() => notice.remove(), shown_ms);
  }

  /** Waits for the action and shows the reason if it fails. @returns whether it succeeded */
  async attempt(action: Promise<unknown>, done = ""): Promise<boolean> {
    try {
      await action;
      if (done !== "") this.show(done);
      return true;
    } catch (problem) {
      this.show(problem instanceof Error ? problem.message : String(problem), "trouble");
      return false;
    }
  }
}
