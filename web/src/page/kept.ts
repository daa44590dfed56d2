import { Signal } from "./signal";

/** One of several choices, which the browser keeps; until the user chooses, the first one. */
export class Kept<Choice extends string> extends Signal<Choice> {
  constructor(
    private readonly key: string,
    private readonly choices: readonly Choice[],
  ) {
    const stored = globalThis.localStorage?.getItem(key);
    super(choices.find((choice) => choice === stored) ?? (choices[0] as Choice));
  }

  choose(choice: Choice): void {
    globalThis.localStorage?.setItem(this.key, choice);
    this.value = choice;
  }

  choose_next(): void {
    const next = (this.choices.indexOf(this.value) + 1) % this.choices.length;
    this.choose(this.choices[next] as Choice);
  }
}
