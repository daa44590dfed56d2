import type { Lease } from "../connection/lease";
import type { LiveConnection } from "../connection/live_connection";
import { Signal } from "../page/signal";
import { command_of, is_request, no_request, strongest } from "./drive_request";
import type { DriveRequest } from "./drive_request";
import { vehicle_shape } from "./vehicle_text";

const topic = "/drive";
const command_every_ms = 50;

/**
 * Sends driving commands while a control is pressed and this page holds the lease. When all controls are released, it
 * sends one stop command and then nothing: without commands the vehicle stops by itself.
 */
export class HandDriver {
  readonly request = new Signal<DriveRequest>(no_request);
  /** Share of the vehicle's maximum speed, 0 to 1. */
  pace = 0.6;
  vehicle = vehicle_shape("");

  readonly #sources = new Map<string, DriveRequest>();
  #sequence = 0;
  #timer: ReturnType<typeof setInterval> | undefined;

  constructor(
    private readonly connection: LiveConnection,
    private readonly lease: Lease,
  ) {
    connection.announce(topic, "aisle/Drive");
    lease.token.watch((token) => {
      this.#sequence = 0;
      if (token === undefined) this.release_all();
    });
  }

  /** @param source the input device: the keys, the pad or the gamepad */
  press(source: string, request: DriveRequest): void {
    if (is_request(request)) this.#sources.set(source, request);
    else this.#sources.delete(source);
    this.request.value = strongest([...this.#sources.values()]);
    if (is_request(this.request.value)) this.#begin();
    else this.#end();
  }

  release_all(): void {
    this.#sources.clear();
    this.request.value = no_request;
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
    const command = command_of(this.request.value, this.pace, this.vehicle);
    this.connection.publish(topic, { lease, sequence: this.#sequence, age_s: 0, ...command });
  }
}
