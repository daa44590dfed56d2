import { building_tab } from "./building/building_tab";
import { drive_tab } from "./drive/drive_tab";
import { maze_tab } from "./maze/maze_tab";
import { socket_address, take_token_from_address } from "./page/access";
import { follow_address } from "./page/address";
import { make_app } from "./page/app";
import { element } from "./page/element";
import { unseen } from "./page/elsewhere";
import { header } from "./page/header";
import { Notices } from "./page/notices";
import { announce_results } from "./page/results";
import { emergency_stop, held_bar } from "./page/stop";
import { follow_theme } from "./page/theme";
import { token_form } from "./page/token_form";
import { SessionStore } from "./sessions/session_store";
import { sessions_tab } from "./sessions/sessions_tab";
import { language } from "./text";
import "./style.css";

document.documentElement.lang = language;
follow_theme();
take_token_from_address();
const notices = new Notices();
const app = make_app(socket_address(), notices);
const sessions = new SessionStore(app);
const tabs = [drive_tab(app, sessions), maze_tab(app), sessions_tab(app, sessions), building_tab(app)];

const main = element("main", { id: "main" }, ...tabs.map((tab) => tab.element));
document.body.append(
  header(app, tabs),
  element("div", { class: "stopper" }, emergency_stop(app)),
  element("div", { class: "top" }, held_bar(app), notices.area, token_form(app.connection)),
  main,
);

const show_title = () => {
  const shown = tabs.find(({ name }) => name === app.tab.value);
  document.title = [unseen.value, shown?.title, "· aisle"].filter(Boolean).join(" ");
};
app.tab.watch((shown) => {
  for (const { name, element: container } of tabs) container.hidden = name !== shown;
  show_title();
});
unseen.watch(show_title);
app.connection.trouble.watch((problem) => {
  if (problem !== "") notices.show(problem, "trouble");
});
announce_results(app);
follow_address(app, tabs);
