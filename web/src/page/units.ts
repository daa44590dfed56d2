import { Kept } from "./kept";

/** Lengths in the unit that the user has chosen. The vehicle, its files and the protocol know metres alone. */

export const unit = new Kept("aisle.unit", ["m", "ft"]);

export function metres_per_unit(): number {
  return unit.value === "ft" ? 0.3048 : 1;
}

/** With as many digits behind the point; never "-0.0". */
function fixed(value: number, digits: number): string {
  const rounded = value.toFixed(digits);
  return Number(rounded) === 0 ? rounded.replace("-", "") : rounded;
}

/** A length without its unit. */
export function number_text(length_m: number, digits: number): string {
  return fixed(length_m / metres_per_unit(), digits);
}

export function length_text(length_m: number, digits: number): string {
  return `${number_text(length_m, digits)} ${unit.value}`;
}

export function area_text(area_m2: number): string {
  return `${fixed(area_m2 / metres_per_unit() ** 2, 0)} ${unit.value}²`;
}

export function speed_text(speed_mps: number): string {
  return `${length_text(speed_mps, 2)}/s`;
}

/** A position, such as "3.20, 1.45 m". */
export function position_text({ x, y }: { x: number; y: number }, digits: number): string {
  return `${number_text(x, digits)}, ${length_text(y, digits)}`;
}
