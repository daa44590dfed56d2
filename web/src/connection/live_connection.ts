import { FoxgloveClient } from "@foxglove/ws-protocol";
import type { Channel, Service } from "@foxglove/ws-protocol";

import { Signal } from "../page/signal";
import { decoder_of } from "./decoder";
import type { Decode } from "./decoder";
import { PendingCalls } from "./pending_calls";

export type ConnectionState = "connecting" | "connected" | "lost";

const subprotocols = ["foxglove.sdk.v1", "foxglove.websocket.v1"];
const retry_after_ms = [250, 500, 1000, 2000];

/** @param stamp_ns on the vehicle's clock */
export type Listener = (message: unknown, stamp_ns: bigint) => void;

interface Subscription {
  channel: Channel;
  decode: Decode;
}

/**
 * The connection to the vehicle's program: topics by name, services, and published messages. It reconnects by itself;
 * listeners and publications survive that.
 */
export class LiveConnection {
  readonly state = new Signal<ConnectionState>("connecting");
  /** Incremented whenever the set of advertised topics changes. */
  readonly channels = new Signal(0);
  readonly services = new Signal<ReadonlySet<string>>(new Set());
  /** The latest warning or error reported by the server. */
  readonly trouble = new Signal("");
  /** Time of the last message, by performance.now(); -Infinity: none yet. */
  last_message_ms = -Infinity;

  readonly #listeners = new Map<string, Set<Listener>>();
  readonly #published = new Map<string, string>();
  readonly #calls = new PendingCalls();
  #client: FoxgloveClient | undefined;
  #channels = new Map<number, Channel>();
  #subscriptions = new Map<number, Subscription>();
  #subscribed = new Map<string, number>();
  #client_channels = new Map<string, number>();
  #services = new Map<string, Service>();
  #failures = 0;

  constructor(private readonly url: string) {
    this.#connect();
  }

  /** @returns a function that removes the listener */
  listen(topic: string, listener: Listener): () => void {
    const listeners = this.#listeners.get(topic) ?? new Set();
    this.#listeners.set(topic, listeners.add(listener));
    this.#subscribe_to(topic);
    return () => {
      listeners.delete(listener);
      if (listeners.size === 0) this.#unsubscribe_from(topic);
    };
  }

  /** The channels that are advertised now. */
  topics(): Channel[] {
    return [...this.#channels.values()];
  }

  /** Calls a service with a JSON request; rejects with the server's reason. */
  call<Response = unknown>(name: string, request: object = {}): Promise<Response> {
    const service = this.#services.get(name);
    if (!this.#client || !service) return Promise.reject(new Error(this.#refusal(name)));
    const { id, answer } = this.#calls.begin();
    const data = new TextEncoder().encode(JSON.stringify(request));
    this.#client.sendServiceCallRequest({ serviceId: service.id, callId: id, encoding: "json", data });
    return answer as Promise<Response>;
  }

  /** Announces that JSON messages will be published on `topic`. */
  announce(topic: string, schema_name: string): void {
    this.#published.set(topic, schema_name);
    this.#announce_all();
  }

  publish(topic: string, message: object): void {
    const channel = this.#client_channels.get(topic);
    if (channel !== undefined) {
      this.#client?.sendMessage(channel, new TextEncoder().encode(JSON.stringify(message)));
    }
  }

  #refusal(service: string): string {
    return this.#client ? `this server does not offer ${service}` : "not connected to the vehicle";
  }

  #connect(): void {
    const socket = new WebSocket(this.url, subprotocols);
    const client = new FoxgloveClient({ ws: socket });
    client.on("open", () => {
      this.#client = client;
      this.#failures = 0;
      this.trouble.value = "";
      this.#announce_all();
      this.state.value = "connected";
    });
    client.on("close", () => this.#lost());
    client.on("error", () => undefined);
    client.on("status", ({ level, message }) => {
      if (level >= 1) this.trouble.value = message;
    });
    client.on("advertise", (channels) => this.#advertised(channels));
    client.on("unadvertise", (ids) => this.#unadvertised(ids));
    client.on("advertiseServices", (services) => {
      for (const service of services) this.#services.set(service.name, service);
      this.services.value = new Set(this.#services.keys());
    });
    client.on("unadvertiseServices", (ids) => {
      for (const [name, { id }] of this.#services) if (ids.includes(id)) this.#services.delete(name);
      this.services.value = new Set(this.#services.keys());
    });
    client.on("serviceCallResponse", ({ callId, data }) => this.#calls.answered(callId, data));
    client.on("serviceCallFailure", ({ callId, message }) => this.#calls.failed(callId, message));
    client.on("message", ({ subscriptionId, timestamp, data }) => {
      this.last_message_ms = performance.now();
      this.#deliver(subscriptionId, timestamp, data);
    });
  }

  #lost(): void {
    this.#client = undefined;
    this.#channels.clear();
    this.#subscriptions.clear();
    this.#subscribed.clear();
    this.#client_channels.clear();
    this.#services.clear();
    this.#calls.fail_all("the connection to the vehicle was lost");
    this.services.value = new Set();
    this.state.value = "lost";
    const wait_ms = retry_after_ms[Math.min(this.#failures, retry_after_ms.length - 1)];
    this.#failures += 1;
    setTimeout(() => this.#connect(), wait_ms);
  }

  #advertised(channels: Channel[]): void {
    for (const channel of channels) {
      this.#channels.set(channel.id, channel);
      this.#subscribe_to(channel.topic);
    }
    this.channels.value += 1;
  }

  #unadvertised(ids: number[]): void {
    for (const id of ids) {
      const topic = this.#channels.get(id)?.topic;
      this.#channels.delete(id);
      if (topic === undefined) continue;
      const subscription = this.#subscribed.get(topic);
      if (subscription !== undefined) this.#subscriptions.delete(subscription);
      this.#subscribed.delete(topic);
    }
    this.channels.value += 1;
  }

  #subscribe_to(topic: string): void {
    if (!this.#client || this.#subscribed.has(topic) || !this.#listeners.get(topic)?.size) return;
    const channel = this.topics().find((offered) => offered.topic === topic);
    if (!channel) return;
    const id = this.#client.subscribe(channel.id);
    this.#subscriptions.set(id, { channel, decode: decoder_of(channel) });
    this.#subscribed.set(topic, id);
  }

  #unsubscribe_from(topic: string): void {
    const id = this.#subscribed.get(topic);
    if (id === undefined) return;
    this.#client?.unsubscribe(id);
    this.#subscriptions.delete(id);
    this.#subscribed.delete(topic);
  }

  #announce_all(): void {
    if (!this.#client) return;
    for (const [topic, schemaName] of this.#published) {
      if (this.#client_channels.has(topic)) continue;
      this.#client_channels.set(topic, this.#client.advertise({ topic, encoding: "json", schemaName }));
    }
  }

  #deliver(subscription: number, stamp_ns: bigint, data: ArrayBufferView): void {
    const found = this.#subscriptions.get(subscription);
    if (!found) return;
    const message = found.decode(data);
    for (const listener of this.#listeners.get(found.channel.topic) ?? []) listener(message, stamp_ns);
  }
}
