import { is_request, no_request } from "./drive_request";
import type { DriveRequest } from "./drive_request";

const dead_zone = 0.15;

function axis(value: number | undefined): number {
  return value !== undefined && Math.abs(value) > dead_zone ? value : 0;
}

function request_of(pad: Gamepad): DriveRequest {
  return { ahead: -axis(pad.axes[1]) + 0, left: -axis(pad.axes[0]) + 0 };
}

/** Reports the left stick of any gamepad; polls only while one is connected. */
export function watch_gamepads(report: (request: DriveRequest) => void): void {
  let polling = false;
  let reported = no_request;
  const poll = () => {
    const pads = navigator.getGamepads().filter((pad) => pad !== null);
    const request = pads.map(request_of).find(is_request) ?? no_request;
    if (request.ahead !== reported.ahead || request.left !== reported.left) report((reported = request));
    polling = pads.length > 0;
    if (polling) requestAnimationFrame(poll);
  };
  addEventListener("gamepadconnected", () => {
    if (!polling) poll();
  });
}
