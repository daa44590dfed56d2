import type { App } from "../page/app";
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

/** A list that cannot be had now is asked for again at the next change. */
const ignore = (): void => undefined;

/** The sessions that the server keeps. */
export class SessionShelf {
  readonly sessions = new Signal<SessionEntry[]>([]);

  constructor(private readonly app: App) {
    let mode: string | undefined;
    app.state.watch((state) => {
      if (state && state.mode !== mode) void this.refresh().catch(ignore);
      mode = state?.mode;
    });
    app.connection.services.watch(() => void this.refresh().catch(ignore));
  }

  async refresh(): Promise<void> {
    if (!this.app.connection.services.value.has("sessions/list")) return;
    const { sessions } = await this.app.connection.call<{ sessions: SessionEntry[] }>("sessions/list");
    this.sessions.value = sessions.sort((a, b) => a.name.localeCompare(b.name));
  }
}
