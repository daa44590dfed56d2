import type { App, Room } from "../page/app";
import { element } from "../page/element";

export function sessions_room(_app: App): Room {
  return { name: "sessions", title: "Sessions", element: element("div", { class: "room" }) };
}
