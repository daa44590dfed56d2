import { building_room } from "./building/building_room";
import { drive_room } from "./drive/drive_room";
import { maze_room } from "./maze/maze_room";
import { make_app } from "./page/app";
import { element } from "./page/element";
import { header } from "./page/header";
import { Notices } from "./page/notices";
import { follow_theme } from "./page/theme";
import { token_gate } from "./page/token_gate";
import { sessions_room } from "./sessions/sessions_room";
import "./style.css";

follow_theme();
const notices = new Notices();
const app = make_app(new URL(location.href), notices);
const rooms = [drive_room(app), maze_room(app), sessions_room(app), building_room(app)];

const main = element("main", { id: "main" }, ...rooms.map((room) => room.element));
document.body.append(header(app, rooms), token_gate(app.connection), main, notices.element);

function enter(): void {
  const wanted = location.hash.slice(1);
  app.room.value = rooms.some(({ name }) => name === wanted) ? wanted : "drive";
}

app.room.watch((shown) => {
  for (const { name, title, element: shell } of rooms) {
    shell.hidden = name !== shown;
    if (name === shown) document.title = `${title} · aisle`;
  }
});
addEventListener("hashchange", enter);
app.connection.trouble.watch((text) => {
  if (text !== "") notices.tell(text, "trouble");
});
enter();
