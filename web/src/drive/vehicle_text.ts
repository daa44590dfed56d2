/** What the page needs to know about the vehicle, from the text of its file (docs/formats/vehicle.md). */
export interface VehicleShape {
  is_differential: boolean;
  speed_max_mps: number;
  reverse_speed_max_mps: number;
  steering_max_rad: number;
  turn_rate_max_rad_s: number;
  front_m: number;
  rear_m: number;
  width_m: number;
}

const radians = Math.PI / 180;

/** The value of `key`, whatever its section; each of these keys occurs once in the text. */
function number_at(text: string, key: string, fallback: number): number {
  const found = new RegExp(`^\\s*${key}:\\s*([-+.\\deE]+)\\s*$`, "m").exec(text);
  const value = Number(found?.[1]);
  return found && Number.isFinite(value) ? value : fallback;
}

export function vehicle_shape(text: string): VehicleShape {
  return {
    is_differential: /^is_differential:\s*true\b/m.test(text),
    speed_max_mps: number_at(text, "speed_max_mps", 0.5),
    reverse_speed_max_mps: number_at(text, "reverse_speed_max_mps", 0.3),
    steering_max_rad: number_at(text, "steering_max_deg", 30) * radians,
    turn_rate_max_rad_s: number_at(text, "turn_rate_max_deg_s", 45) * radians,
    front_m: number_at(text, "front_m", 0.3),
    rear_m: number_at(text, "rear_m", 0.3),
    width_m: number_at(text, "width_m", 0.4),
  };
}
