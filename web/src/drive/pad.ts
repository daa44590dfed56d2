import { text } from "../text";
import { element } from "../page/element";
import { no_request } from "./drive_request";
import type { DriveRequest } from "./drive_request";

const dead_zone = 0.12;

function beyond_dead_zone(value: number): number {
  const size = Math.min(1, Math.max(0, (Math.abs(value) - dead_zone) / (1 - dead_zone)));
  return Math.sign(value) * size;
}

/** A round pad for a finger or the mouse: up drives ahead, left steers left. */
export function drive_pad(report: (request: DriveRequest) => void): HTMLElement {
  const knob = element("div", { class: "knob" });
  const pad = element("div", { class: "pad", role: "application", "aria-label": text.hand.pad }, knob);

  const show = (request: DriveRequest) => {
    knob.style.transform = `translate(${-request.left * 40}%, ${-request.ahead * 40}%)`;
    report(request);
  };
  const move = (event: PointerEvent) => {
    const box = pad.getBoundingClientRect();
    const right = ((event.clientX - box.left) / box.width) * 2 - 1;
    const down = ((event.clientY - box.top) / box.height) * 2 - 1;
    show({ ahead: beyond_dead_zone(-down), left: beyond_dead_zone(-right) });
  };
  pad.addEventListener("pointerdown", (event) => {
    pad.setPointerCapture(event.pointerId);
    move(event);
  });
  pad.addEventListener("pointermove", (event) => {
    if (pad.hasPointerCapture(event.pointerId)) move(event);
  });
  for (const end of ["pointerup", "pointercancel", "lostpointercapture"])
    pad.addEventListener(end, () => show(no_request));
  return pad;
}
