import type { App } from "../page/app";
import { keep_fresh } from "../page/server_list";
import { Signal } from "../page/signal";

export interface SessionEntry {
  name: string;
  duration_s: number;
  messages: number;
  bytes: number;
  navigator: string;
  simulated: boolean;
  route: string;
}

/** The sessions stored on the server. */
export class SessionStore {
  readonly sessions = new Signal<SessionEntry[]>([]);

  constructor(private readonly app: App) {
    keep_fresh(app, "sessions", () => this.refresh());
  }

  async refresh(): Promise<void> {
    if (!this.app.connection.services.value.has("sessions/list")) return;
    const { sessions } = await this.app.connection.call<{ sessions: SessionEntry[] }>("sessions/list");
    this.sessions.value = sessions.sort((a, b) => a.name.localeCompare(b.name));
  }
}
