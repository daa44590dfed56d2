import { building_tab } from "./building/building_tab";
import { drive_tab } from "./drive/drive_tab";
import { maze_tab } from "./maze/maze_tab";
import { make_app } from "./page/app";
import { element } from "./page/element";
import { header } from "./page/header";
import { Notices } from "./page/notices";
import { follow_theme } from "./page/theme";
import { token_form } from "./page/token_form";
import { sessions_tab } from "./sessions/sessions_tab";
import "./style.css";

follow_theme();
const notices = new Notices();
const app = make_app(new URL(location.href), notices);
const tabs = [drive_tab(app), maze_tab(app), sessions_tab(app), building_tab(app)];

const main = element("main", { id: "main" }, ...tabs.map((tab) => tab.element));
document.body.append(header(app, tabs), token_form(app.connection), main, notices.element);

function enter(): void {
  const wanted = location.hash.slice(1);
  app.tab.value = tabs.some(({ name }) => name === wanted) ? wanted : "drive";
}

app.tab.watch((shown) => {
  for (const { name, title, element: container } of tabs) {
    container.hidden = name !== shown;
    if (name === shown) document.title = `${title} · aisle`;
  }
});
addEventListener("hashchange", enter);
app.connection.trouble.watch((text) => {
  if (text !== "") notices.show(text, "trouble");
});
enter();
