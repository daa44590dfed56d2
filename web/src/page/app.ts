import { Lease } from "../connection/lease";
import { LiveConnection } from "../connection/live_connection";
import { follow_state } from "../connection/live_state";
import type { LiveState } from "../connection/live_state";
import { HandDriver } from "../drive/hand_driver";
import { watch_gamepads } from "../drive/gamepad";
import { watch_keys } from "../drive/keys";
import type { Notices } from "./notices";
import { Signal } from "./signal";

/** What all tabs share. */
export interface App {
  connection: LiveConnection;
  state: Signal<LiveState | undefined>;
  lease: Lease;
  driver: HandDriver;
  notices: Notices;
  /** Name of the tab that is shown. */
  tab: Signal<string>;
}

/** One tab of the page. */
export interface Tab {
  name: string;
  title: string;
  element: HTMLElement;
}

/** @param address of the page, with the access token if the server needs one */
export function make_app(address: URL, notices: Notices): App {
  const socket = new URL(address);
  socket.protocol = address.protocol === "https:" ? "wss:" : "ws:";
  socket.hash = "";
  const connection = new LiveConnection(socket.href);
  const lease = new Lease(connection);
  const app: App = {
    connection,
    lease,
    notices,
    state: follow_state(connection),
    driver: new HandDriver(connection, lease),
    tab: new Signal("drive"),
  };
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
