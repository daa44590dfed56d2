import { Lease } from "../connection/lease";
import { LiveConnection } from "../connection/live_connection";
import { follow_state } from "../connection/live_state";
import type { LiveState } from "../connection/live_state";
import { HandDriver } from "../drive/hand_driver";
import { watch_gamepads } from "../drive/gamepad";
import { watch_keys } from "../drive/keys";
import type { Notices } from "./notices";
import { Signal } from "./signal";

/** What all rooms share. */
export interface App {
  connection: LiveConnection;
  state: Signal<LiveState | undefined>;
  lease: Lease;
  driver: HandDriver;
  notices: Notices;
  /** The room that is shown. */
  room: Signal<string>;
}

/** One room of the page. */
export interface Room {
  name: string;
  title: string;
  element: HTMLElement;
}

/** @param address of the page; a token in it opens the server's doors */
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
    room: new Signal("drive"),
  };
  const keys_drive = () => app.room.value === "drive" && lease.token.value !== undefined;
  watch_keys(keys_drive, (wish) => app.driver.press("keys", wish));
  watch_gamepads((wish) =>
    app.driver.press("gamepad", app.room.value === "drive" ? wish : { ahead: 0, left: 0 }),
  );
  app.room.watch((room) => {
    if (room !== "drive") app.driver.let_go();
  });
  return app;
}
