import { CameraView } from "../camera/camera_view";
import type { App, Room } from "../page/app";
import { element, panel } from "../page/element";
import { BuildingShelf } from "../building/building_shelf";
import { hand_panel } from "./hand_panel";
import { mission_panel } from "./mission_panel";
import { plan_panel } from "./plan_panel";
import { state_panel } from "./state_panel";

/** Watch the vehicle, send it on missions, drive and teach it. */
export function drive_room(app: App): Room {
  const shelf = new BuildingShelf(app);
  const room = element(
    "div",
    { class: "room drive-room" },
    panel("Camera", "camera-panel", new CameraView(app.connection).element),
    plan_panel(app, shelf),
    hand_panel(app),
    state_panel(app),
    mission_panel(app, shelf),
  );
  return { name: "drive", title: "Drive", element: room };
}
