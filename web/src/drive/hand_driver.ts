import type { Lease } from "../connection/lease";
import type { LiveConnection } from "../connection/live_connection";
import { Signal } from "../page/signal";
import { command_of, is_wish, no_wish, strongest } from "./wish";
import type { Wish } from "./wish";
import { vehicle_shape } from "./vehicle_text";

const topic = "/drive";
const command_every_ms = 50;

/**
 * Sends drive commands while anything is pressed and this page holds the lease. When all is released it says "stand"
 * once and falls silent: the vehicle stops without commands.
 */
export class HandDriver {
  readonly wish = new Signal<Wish>(no_wish);
  /** Share of the vehicle's greatest speed. */
  pace = 0.6;
  vehicle = vehicle_shape("");

  readonly #sources = new Map<string, Wish>();
  #sequence = 0;
  #timer: ReturnType<typeof setInterval> | undefined;

  constructor(
    private readonly connection: LiveConnection,
    private readonly lease: Lease,
  ) {
    connection.announce(topic, "aisle/Drive");
    lease.token.watch((token) => {
      this.#sequence = 0;
      if (token === undefined) this.let_go();
    });
  }

  /** @param source who wishes it: the keys, the pad, the gamepad */
  press(source: string, wish: Wish): void {
    if (is_wish(wish)) this.#sources.set(source, wish);
    else this.#sources.delete(source);
    this.wish.value = strongest([...this.#sources.values()]);
    if (is_wish(this.wish.value)) this.#begin();
    else this.#end();
  }

  let_go(): void {
    this.#sources.clear();
    this.wish.value = no_wish;
    this.#end();
  }

  #begin(): void {
    if (this.#timer !== undefined) return;
    this.#send();
    this.#timer = setInterval(() => this.#send(), command_every_ms);
  }

  #end(): void {
    if (this.#timer === undefined) return;
    clearInterval(this.#timer);
    this.#timer = undefined;
    this.#send();
  }

  #send(): void {
    const lease = this.lease.token.value;
    if (lease === undefined) return;
    this.#sequence += 1;
    const command = command_of(this.wish.value, this.pace, this.vehicle);
    this.connection.publish(topic, { lease, sequence: this.#sequence, age_s: 0, ...command });
  }
}
