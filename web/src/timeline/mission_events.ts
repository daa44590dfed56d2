import type { LiveConnection } from "../connection/live_connection";
import type { LiveState } from "../connection/live_state";
import { Signal } from "../page/signal";

/** Something that happened in a mission: docs/reference/live-server.md. */
export interface MissionEvent {
  /** Since the mission, or the session, began. */
  stamp_s: number;
  kind: string;
  text: string;
  at_m?: [number, number];
}

/** The server's answer: the events after the first `from`, which it may no longer have. */
interface Answer {
  from: number;
  events: MissionEvent[];
}

const kept_max = 1000;

/** What has happened in the mission that is shown; asks the server for what is new. */
export class MissionEvents {
  readonly list = new Signal<readonly MissionEvent[]>([]);
  /** How many are known, also those that are no longer kept. */
  #known = 0;
  #is_asking = false;

  constructor(
    private readonly connection: Pick<LiveConnection, "call" | "services">,
    state: Signal<LiveState | undefined>,
  ) {
    connection.services.watch(() => this.#forget());
    state.watch((present) => void this.#follow(present?.events ?? 0));
  }

  /** @param count of what has happened; fewer than are known: another mission, or a replay that jumped back */
  async #follow(count: number): Promise<void> {
    if (count < this.#known) this.#forget();
    if (count === this.#known || this.#is_asking) return;
    if (!this.connection.services.value.has("mission/events")) return;
    this.#is_asking = true;
    const from = this.#known;
    await this.connection
      .call<Answer>("mission/events", { from })
      .then((answer) => this.#take(answer, from))
      .catch(() => undefined)
      .finally(() => (this.#is_asking = false));
  }

  #take({ from, events }: Answer, asked: number): void {
    if (asked !== this.#known || from < asked) return;
    this.#known = from + events.length;
    this.list.value = [...this.list.value, ...events].slice(-kept_max);
  }

  #forget(): void {
    this.#known = 0;
    if (this.list.value.length > 0) this.list.value = [];
  }
}
