/** The versions of a value, oldest first, and the present one. */
export class UndoList<T> {
  #versions: T[];
  #at = 0;

  constructor(first: T) {
    this.#versions = [first];
  }

  get present(): T {
    return this.#versions[this.#at] as T;
  }

  get can_undo(): boolean {
    return this.#at > 0;
  }

  get can_redo(): boolean {
    return this.#at + 1 < this.#versions.length;
  }

  /** @param begins false: continues the last stroke; undo removes both together */
  put(version: T, begins = true): void {
    if (begins) this.#at += 1;
    this.#versions.splice(this.#at, Infinity, version);
  }

  undo(): void {
    if (this.can_undo) this.#at -= 1;
  }

  redo(): void {
    if (this.can_redo) this.#at += 1;
  }
}
