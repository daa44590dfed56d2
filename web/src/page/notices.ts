import { button, element } from "./element";

const shown_ms = 8000;

/** Short messages at the edge of the page, read out by screen readers. */
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

  /** Does it and tells why it could not be done. */
  async attempt(what: Promise<unknown>, done = ""): Promise<boolean> {
    try {
      await what;
      if (done !== "") this.show(done);
      return true;
    } catch (problem) {
      this.show(problem instanceof Error ? problem.message : String(problem), "trouble");
      return false;
    }
  }
}
