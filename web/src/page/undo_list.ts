/** Versions of a thing, oldest first, and which one is present. */
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

  /** @param begins false: the stroke of before goes on, and is undone together with it */
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
