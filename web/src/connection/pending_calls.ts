/** Service calls waiting for their responses. */
export class PendingCalls {
  readonly #waiting = new Map<number, { resolve: (answer: unknown) => void; reject: (why: Error) => void }>();
  #next = 1;

  begin(): { id: number; answer: Promise<unknown> } {
    const id = this.#next++;
    const answer = new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
    return { id, answer };
  }

  /** @param data the response as JSON; no bytes: an empty response */
  answered(id: number, data: ArrayBufferView): void {
    const call = this.#take(id);
    const text = new TextDecoder().decode(data);
    try {
      call?.resolve(text === "" ? {} : JSON.parse(text));
    } catch {
      call?.reject(new Error("the response could not be read"));
    }
  }

  failed(id: number, why: string): void {
    this.#take(id)?.reject(new Error(why));
  }

  fail_all(why: string): void {
    for (const id of [...this.#waiting.keys()]) this.failed(id, why);
  }

  #take(id: number) {
    const call = this.#waiting.get(id);
    this.#waiting.delete(id);
    return call;
  }
}
