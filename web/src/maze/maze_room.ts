import type { App, Room } from "../page/app";
import { element } from "../page/element";

export function maze_room(_app: App): Room {
  return { name: "maze", title: "Maze", element: element("div", { class: "room" }) };
}
