import type { VehicleShape } from "./vehicle_text";

/** The requested motion, each component from -1 to 1: ahead, and to the left. */
export interface DriveRequest {
  ahead: number;
  left: number;
}

export interface DriveCommand {
  speed_mps: number;
  steering_rad: number;
  turn_rate_rad_s: number;
}

export const no_request: DriveRequest = { ahead: 0, left: 0 };

export function is_request({ ahead, left }: DriveRequest): boolean {
  return ahead !== 0 || left !== 0;
}

/** The strongest request along each axis. */
export function strongest(requests: DriveRequest[]): DriveRequest {
  const stronger = (a: number, b: number) => (Math.abs(b) > Math.abs(a) ? b : a);
  return {
    ahead: requests.map((request) => request.ahead).reduce(stronger, 0),
    left: requests.map((request) => request.left).reduce(stronger, 0),
  };
}

/**
 * The driving command for a request. In reverse, a front-steered vehicle's wheels still point to the requested side; a
 * differential vehicle turns to that side as seen from above.
 * @param pace share of the vehicle's maximum speed, 0 to 1
 */
export function command_of(request: DriveRequest, pace: number, vehicle: VehicleShape): DriveCommand {
  const speed = request.ahead < 0 ? vehicle.reverse_speed_max_mps : vehicle.speed_max_mps;
  return {
    speed_mps: request.ahead * pace * speed,
    steering_rad: vehicle.is_differential ? 0 : request.left * vehicle.steering_max_rad,
    turn_rate_rad_s: vehicle.is_differential ? request.left * pace * vehicle.turn_rate_max_rad_s : 0,
  };
}
