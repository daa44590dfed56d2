import { BuildingStore } from "../building/building_store";
import { CameraView } from "../camera/camera_view";
import type { App, Tab } from "../page/app";
import { button, element } from "../page/element";
import type { SessionStore } from "../sessions/session_store";
import { text } from "../text";
import { timeline } from "../timeline/timeline";
import { details_panel } from "./details_panel";
import { hand_panel } from "./hand_panel";
import { mission_panel } from "./mission_panel";
import { plan_stage } from "./plan_stage";

/** Plan and camera: one fills the stage, the other is an inset; a tap on the inset's corner swaps them. */
function stage(app: App, plan: HTMLElement): HTMLElement {
  const is_phone = matchMedia("(max-width: 599px), (max-height: 499px)");
  const view = new CameraView(app.connection, () => false);
  const swap = button("⇄", () => show(made.dataset["main"] === "plan" ? "camera" : "plan"), {
    class: "swap",
  });
  swap.setAttribute("aria-label", text.camera.swap);
  swap.title = text.camera.swap;
  const camera = element("div", { class: "camera-box camera-panel" }, view.element);
  const made = element("div", { class: "stage" }, plan, camera, swap);
  for (const box of [plan, camera])
    box.addEventListener("click", () => {
      if (is_phone.matches && box === inset()) swap.click();
    });
  const inset = () => (made.dataset["main"] === "plan" ? camera : plan);
  const show = (main: "plan" | "camera") => (made.dataset["main"] = main);
  const drives = () => app.lease.token.value !== undefined && (app.state.value?.driven_by_hand ?? false);
  let was_driving = false;
  const show_for_driving = () => show(is_phone.matches && drives() ? "camera" : "plan");
  const follow_driving = () => {
    if (drives() === was_driving) return;
    was_driving = drives();
    show_for_driving();
  };
  show_for_driving();
  app.lease.token.watch(follow_driving);
  app.state.watch(follow_driving);
  is_phone.addEventListener("change", show_for_driving);
  return made;
}

/** Watch the vehicle, start missions, drive by hand and teach routes. */
export function drive_tab(app: App, sessions: SessionStore): Tab {
  const store = new BuildingStore(app);
  const { plan, layers } = plan_stage(app, store);
  const hand = hand_panel(app);
  const mission = mission_panel(app, store, sessions);
  const tab = element(
    "div",
    { class: "tab drive-tab" },
    element("div", { class: "stage-area" }, stage(app, plan), timeline(app)),
    hand.steering,
    element("div", { class: "sheet" }, mission.panel, hand.panel, details_panel(app, layers)),
  );
  return { name: "drive", title: text.tabs.drive, element: tab, choice: mission.choice };
}
