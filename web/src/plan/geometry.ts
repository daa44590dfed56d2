/** A point in the map frame [m], see docs/reference/frames.md. */
export interface Point {
  x: number;
  y: number;
}

export interface Pose extends Point {
  heading_rad: number;
}

export interface Bounds {
  low: Point;
  high: Point;
}

export function heading_of(q: { x: number; y: number; z: number; w: number }): number {
  return Math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
}

export function moved_by(pose: Pose, point: Point): Point {
  const c = Math.cos(pose.heading_rad);
  const s = Math.sin(pose.heading_rad);
  return { x: pose.x + c * point.x - s * point.y, y: pose.y + s * point.x + c * point.y };
}

/** From one point to another, counter-clockwise from the x axis: whole degrees from 0 to 359. */
export function direction_deg(from: Point, to: Point): number {
  const degrees = Math.round((Math.atan2(to.y - from.y, to.x - from.x) * 180) / Math.PI);
  return (degrees + 360) % 360;
}

export function distance(a: Point, b: Point): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

/** The closed outline of the rectangle with these opposite corners. */
export function rectangle(from: Point, to: Point): Point[] {
  return [from, { x: to.x, y: from.y }, to, { x: from.x, y: to.y }, from];
}

/** Distance from `p` to the segment from `a` to `b`. */
export function distance_to_segment(p: Point, a: Point, b: Point): number {
  const length2 = (b.x - a.x) ** 2 + (b.y - a.y) ** 2;
  const share = length2 === 0 ? 0 : ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length2;
  const t = Math.min(1, Math.max(0, share));
  return distance(p, { x: a.x + t * (b.x - a.x), y: a.y + t * (b.y - a.y) });
}

export function bounds_of(points: Iterable<Point>): Bounds | undefined {
  const low = { x: Infinity, y: Infinity };
  const high = { x: -Infinity, y: -Infinity };
  for (const { x, y } of points) {
    low.x = Math.min(low.x, x);
    low.y = Math.min(low.y, y);
    high.x = Math.max(high.x, x);
    high.y = Math.max(high.y, y);
  }
  return low.x <= high.x ? { low, high } : undefined;
}

export interface Ellipse {
  /** Semi-axes [m], the longer one first. */
  a_m: number;
  b_m: number;
  /** Direction of the longer axis. */
  heading_rad: number;
}

/** The 1-sigma ellipse of a covariance [[xx, xy], [xy, yy]] in m^2. */
export function ellipse_of(xx: number, xy: number, yy: number): Ellipse {
  const middle = (xx + yy) / 2;
  const half = Math.hypot((xx - yy) / 2, xy);
  return {
    a_m: Math.sqrt(Math.max(0, middle + half)),
    b_m: Math.sqrt(Math.max(0, middle - half)),
    heading_rad: Math.atan2(2 * xy, xx - yy) / 2,
  };
}
