import { Lease } from "../connection/lease";
import { LiveConnection } from "../connection/live_connection";
import { follow_state } from "../connection/live_state";
import type { LiveState } from "../connection/live_state";
import { HandDriver } from "../drive/hand_driver";
import { watch_gamepads } from "../drive/gamepad";
import { watch_keys } from "../drive/keys";
import { LivePlan } from "../plan/live_plan";
import { MissionEvents } from "../timeline/mission_events";
import type { Notices } from "./notices";
import { Signal } from "./signal";

/** What all tabs share. */
export interface App {
  connection: LiveConnection;
  state: Signal<LiveState | undefined>;
  /** The last known state, also after the connection was lost. */
  last_state: LiveState | undefined;
  lease: Lease;
  driver: HandDriver;
  plan: LivePlan;
  events: MissionEvents;
  notices: Notices;
  /** Name of the tab that is shown. */
  tab: Signal<string>;
}

/** What is chosen in a tab, by its name; empty: nothing. */
export interface Choice {
  name: Signal<string>;
  choose(name: string): void;
}

/** One tab of the page. */
export interface Tab {
  name: string;
  title: string;
  element: HTMLElement;
  choice?: Choice;
}

/** @param socket address of the server's WebSocket */
export function make_app(socket: string, notices: Notices): App {
  const connection = new LiveConnection(socket);
  const lease = new Lease(connection);
  const state = follow_state(connection);
  const app: App = {
    connection,
    lease,
    notices,
    state,
    last_state: undefined,
    driver: new HandDriver(connection, lease),
    plan: new LivePlan(connection, state),
    events: new MissionEvents(connection, state),
    tab: new Signal("drive"),
  };
  state.watch((present) => (app.last_state = present ?? app.last_state));
  const keys_drive = () => app.tab.value === "drive" && lease.token.value !== undefined;
  watch_keys(keys_drive, (request) => app.driver.press("keys", request));
  watch_gamepads((request) =>
    app.driver.press("gamepad", app.tab.value === "drive" ? request : { ahead: 0, left: 0 }),
  );
  app.tab.watch((tab) => {
    if (tab !== "drive") app.driver.release_all();
  });
  return app;
}
