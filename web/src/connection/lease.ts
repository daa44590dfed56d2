import type { LiveConnection } from "./live_connection";
import { Signal } from "../page/signal";

const renew_every_ms = 1000;

/**
 * The right to drive, held by one client at a time. It is renewed until it is released or the connection ends. If it
 * expired while the page was suspended, it is taken again unless another client has it.
 */
export class Lease {
  /** The lease's token; undefined: this page does not hold the lease. */
  readonly token = new Signal<string | undefined>(undefined);
  /** How long the server took to answer last [ms]; undefined: this page does not hold the lease. */
  readonly delay_ms = new Signal<number | undefined>(undefined);
  #taking: Promise<string> | undefined;

  constructor(private readonly connection: LiveConnection) {
    connection.state.watch(() => (this.token.value = undefined));
    this.token.watch(() => (this.delay_ms.value = undefined));
    setInterval(() => void this.#renew(), renew_every_ms);
  }

  /** @returns the token; rejects while another client holds the lease */
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

  /** Calls a service that needs the lease; takes the lease first if it is free. */
  async call<Response = unknown>(service: string, request: object = {}): Promise<Response> {
    const lease = await this.take();
    return this.connection.call<Response>(service, { ...request, lease });
  }

  async #renew(): Promise<void> {
    const lease = this.token.value;
    if (lease === undefined) return;
    const asked_ms = performance.now();
    try {
      await this.connection.call("lease/renew", { lease });
      if (this.token.value === lease) this.delay_ms.value = performance.now() - asked_ms;
    } catch {
      if (this.token.value !== lease) return;
      this.token.value = undefined;
      await this.take().catch(() => undefined);
    }
  }
}
