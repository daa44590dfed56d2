import { text } from "../text";
import { set_text } from "./element";

const old_after_s = 2;
const look_every_ms = 500;

/** Dims an element while what it shows is old, and says in `label` how old. */
export class Age {
  #since_ms: number | undefined;

  /**
   * @param stands whether what is shown stays true without news, as in a replay that is paused
   * @param words for an age such as "12 s"
   */
  constructor(
    private readonly shown: HTMLElement,
    private readonly label: HTMLElement,
    private readonly stands: () => boolean,
    private readonly words: (age: string) => string,
  ) {
    setInterval(() => this.#look(), look_every_ms);
  }

  /** What is shown is new; `forget`: nothing is shown any more. */
  renew(): void {
    this.#since_ms = performance.now();
    this.#look();
  }

  forget(): void {
    this.#since_ms = undefined;
    this.#look();
  }

  #look(): void {
    const age_s = this.#since_ms === undefined ? 0 : (performance.now() - this.#since_ms) / 1000;
    const is_old = age_s > old_after_s && !this.stands();
    this.shown.classList.toggle("old", is_old);
    this.label.hidden = !is_old;
    set_text(this.label, is_old ? this.words(text.age(age_s)) : "");
  }
}
