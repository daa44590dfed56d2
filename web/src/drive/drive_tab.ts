import { CameraView } from "../camera/camera_view";
import type { App, Tab } from "../page/app";
import { element, panel } from "../page/element";
import { BuildingStore } from "../building/building_store";
import { hand_panel } from "./hand_panel";
import { mission_panel } from "./mission_panel";
import { plan_panel } from "./plan_panel";
import { state_panel } from "./state_panel";

/** Watch the vehicle, start missions, drive by hand and teach routes. */
export function drive_tab(app: App): Tab {
  const store = new BuildingStore(app);
  const tab = element(
    "div",
    { class: "tab drive-tab" },
    panel("Camera", "camera-panel", new CameraView(app.connection).element),
    plan_panel(app, store),
    hand_panel(app),
    state_panel(app),
    mission_panel(app, store),
  );
  return { name: "drive", title: "Drive", element: tab };
}
