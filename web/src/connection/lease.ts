import type { LiveConnection } from "./live_connection";
import { Signal } from "../page/signal";

const renew_every_ms = 1000;

/**
 * The right to drive, which one client at a time holds. Renewed until it is given back or the connection ends; one that
 * ran out while the page was held up is taken again where nobody else has it.
 */
export class Lease {
  /** The token; undefined: not held here. */
  readonly token = new Signal<string | undefined>(undefined);
  #taking: Promise<string> | undefined;

  constructor(private readonly connection: LiveConnection) {
    connection.state.watch(() => (this.token.value = undefined));
    setInterval(() => void this.#renew(), renew_every_ms);
  }

  /** @returns the token; rejects where somebody else drives */
  take(): Promise<string> {
    if (this.token.value !== undefined) return Promise.resolve(this.token.value);
    this.#taking ??= this.connection
      .call<{ lease: string }>("lease/take", { name: "page" })
      .then(({ lease }) => (this.token.value = lease))
      .finally(() => (this.#taking = undefined));
    return this.#taking;
  }

  async release(): Promise<void> {
    const lease = this.token.value;
    this.token.value = undefined;
    if (lease !== undefined) await this.connection.call("lease/release", { lease });
  }

  /** Calls a service that only who drives may call; takes the lease where nobody has it. */
  async call<Response = unknown>(service: string, request: object = {}): Promise<Response> {
    const lease = await this.take();
    return this.connection.call<Response>(service, { ...request, lease });
  }

  async #renew(): Promise<void> {
    const lease = this.token.value;
    if (lease === undefined) return;
    try {
      await this.connection.call("lease/renew", { lease });
    } catch {
      if (this.token.value !== lease) return;
      this.token.value = undefined;
      await this.take().catch(() => undefined);
    }
  }
}
