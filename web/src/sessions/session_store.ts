import type { App } from "../page/app";
import { keep_fresh } from "../page/server_list";
import { Signal } from "../page/signal";

export interface SessionEntry {
  name: string;
  /** The file beside metadata.yaml. */
  file: string;
  duration_s: number;
  messages: number;
  bytes: number;
  recorded_s: number;
  navigator?: string;
  simulated?: boolean;
  route?: string;
}

const by_name = new Intl.Collator(undefined, { numeric: true });

/** The sessions stored on the server. */
export class SessionStore {
  /** undefined: the list was not received yet. */
  readonly sessions = new Signal<SessionEntry[] | undefined>(undefined);

  constructor(private readonly app: App) {
    keep_fresh(app, "sessions", () => this.refresh());
  }

  async refresh(): Promise<void> {
    if (!this.app.connection.services.value.has("sessions/list")) return;
    const { sessions } = await this.app.connection.call<{ sessions: SessionEntry[] }>("sessions/list");
    sessions.sort((a, b) => by_name.compare(a.name, b.name));
    if (JSON.stringify(sessions) !== JSON.stringify(this.sessions.value)) this.sessions.value = sessions;
  }
}
