import type { App, Room } from "../page/app";
import { element } from "../page/element";

export function building_room(_app: App): Room {
  return { name: "building", title: "Building", element: element("div", { class: "room" }) };
}
