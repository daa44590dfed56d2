import type { Floor } from "../building/building_file";
import type { LiveConnection } from "../connection/live_connection";
import { json_of } from "../connection/live_state";
import type { LiveState } from "../connection/live_state";
import { marker_type } from "../connection/messages";
import type {
  LaserScan,
  Marker,
  MarkerArray,
  Odometry,
  Path,
  PoseWithCovarianceStamped,
  RosPose,
  TFMessage,
} from "../connection/messages";
import { vehicle_shape } from "../drive/vehicle_text";
import type { Signal } from "../page/signal";
import { area_text } from "../page/units";
import { text } from "../text";
import { floor_points, free_floor_m2 } from "./building_geometry";
import { distance, ellipse_of, heading_of, moved_by } from "./geometry";
import type { Ellipse, Point, Pose } from "./geometry";

const trail_every_m = 0.05;

function pose_of({ position, orientation }: RosPose): Pose {
  return { x: position.x, y: position.y, heading_rad: heading_of(orientation) };
}

function points_of(marker: Marker): Point[] {
  const pose = pose_of(marker.pose);
  return marker.points.length > 0 ? marker.points.map((point) => moved_by(pose, point)) : [pose];
}

/** A pose of a frame whose origin lies at `origin`. */
function placed(origin: Pose | undefined, pose: Pose): Pose {
  if (!origin) return pose;
  return { ...moved_by(origin, pose), heading_rad: origin.heading_rad + pose.heading_rad };
}

/** One marker in the form in which it is drawn. */
export interface Mark {
  namespace: string;
  kind: "segments" | "line" | "points" | "text";
  points: Point[];
  text: string;
}

function mark_of(marker: Marker): Mark {
  const { line_list, line_strip, text } = marker_type;
  const kind =
    marker.type === line_list
      ? "segments"
      : marker.type === line_strip
        ? "line"
        : marker.type === text
          ? "text"
          : "points";
  return { namespace: marker.ns, kind, points: points_of(marker), text: marker.text };
}

/** The vehicle's map, pose, path and scan as received from the topics of the connection. */
export class LivePlan {
  marks = new Map<string, Mark>();
  path: Point[] = [];
  trail: Point[] = [];
  scan: Point[] = [];
  floor: Floor | undefined;
  shape = vehicle_shape("");
  /** In the frame `map` if the navigator localises in it, else in `odom`. */
  pose: Pose | undefined;
  ellipse: Ellipse | undefined;
  /** Where the event was that the user looks at. */
  pointed: Point | undefined;
  heading_sigma_rad = 0;

  readonly #viewers = new Set<() => void>();
  /** Where the odometry began on the map; the map stays when the vehicle waits after a mission. */
  #odom_origin: Pose | undefined;
  #laser: Pose = { x: 0, y: 0, heading_rad: 0 };
  #stamp_ns = 0n;
  #has_map_pose = false;

  constructor(
    private readonly connection: LiveConnection,
    state: Signal<LiveState | undefined>,
  ) {
    const listen = <T>(topic: string, take: (message: T, stamp_ns: bigint) => void) =>
      connection.listen(topic, (message, stamp_ns) => {
        take(message as T, stamp_ns);
        this.#changed();
      });
    listen("/session", () => this.#begin(state.value?.map_origin));
    connection.services.watch(() => void this.fetch_trail());
    listen<PoseWithCovarianceStamped>("/pose", (message, stamp_ns) => {
      this.#keep_time(stamp_ns);
      this.#take_pose(message);
    });
    listen<Odometry>("/odom", ({ pose }, stamp_ns) => {
      this.#keep_time(stamp_ns);
      if (!this.#has_map_pose) this.#move_to(placed(this.#odom_origin, pose_of(pose.pose)));
    });
    listen<MarkerArray>("/map", ({ markers }) => this.#take_map(markers));
    listen<Path>("/plan", ({ poses }) => (this.path = poses.map(({ pose }) => pose_of(pose))));
    listen<unknown>("/floor", (message) => (this.floor = json_of<Floor>(message)));
    listen<LaserScan>("/scan", (scan) => this.#take_scan(scan));
    listen<TFMessage>("/tf_static", ({ transforms }) => this.#take_mounts(transforms));
    listen<{ data: string }>("/vehicle_description", ({ data }) => (this.shape = vehicle_shape(data)));
  }

  /** Calls the viewer after every change. */
  watch(viewer: () => void): void {
    this.#viewers.add(viewer);
  }

  #changed(): void {
    for (const viewer of this.#viewers) viewer();
  }

  point_to(at_m: [number, number] | undefined): void {
    this.pointed = at_m && { x: at_m[0], y: at_m[1] };
    this.#changed();
  }

  /** What was driven before this page was opened, or before the time to which a replay has jumped. */
  async fetch_trail(): Promise<void> {
    if (!this.connection.services.value.has("mission/trail")) return;
    const { points } = await this.connection.call<{ points: [number, number][] }>("mission/trail");
    this.trail = points.map(([x, y]) => ({ x, y }));
    this.#changed();
  }

  /** How much floor is known to be free; empty: nothing is known. */
  free_floor_text(): string {
    return this.floor ? text.mission.area(area_text(free_floor_m2(this.floor))) : "";
  }

  /** The named places of the map. */
  places(): (Point & { name: string })[] {
    return [...this.marks.values()].flatMap(({ namespace, text: name, points: [point] }) =>
      namespace === "places" && point ? [{ x: point.x, y: point.y, name }] : [],
    );
  }

  /** All points that the plan should show. */
  *points(): Iterable<Point> {
    if (this.floor) yield* floor_points(this.floor);
    for (const { points } of this.marks.values()) yield* points;
    yield* this.path;
    yield* this.trail;
    if (this.pose) {
      yield { x: this.pose.x - 1.5, y: this.pose.y - 1.5 };
      yield { x: this.pose.x + 1.5, y: this.pose.y + 1.5 };
    }
  }

  /** A mission begins: clears the trail, the path and the map of the previous one, unless that map stays. */
  #begin(origin: LiveState["map_origin"]): void {
    const trail = this.trail;
    const pose = this.pose;
    this.#clear_drive();
    this.#odom_origin = origin && {
      x: origin.x_m,
      y: origin.y_m,
      heading_rad: (origin.heading_deg * Math.PI) / 180,
    };
    if (origin) {
      this.trail = trail;
      this.pose = pose;
      return;
    }
    this.marks.clear();
    this.floor = undefined;
  }

  /** Clears the drive when the stamps go back in time, as a replay may. */
  #keep_time(stamp_ns: bigint): void {
    if (stamp_ns < this.#stamp_ns) this.#clear_drive();
    this.#stamp_ns = stamp_ns;
  }

  #clear_drive(): void {
    this.trail = [];
    this.path = [];
    this.scan = [];
    this.pose = undefined;
    this.ellipse = undefined;
    this.#has_map_pose = false;
    this.#stamp_ns = 0n;
  }

  #take_pose({ pose: { pose, covariance } }: PoseWithCovarianceStamped): void {
    if (!this.#has_map_pose) this.trail = [];
    this.#has_map_pose = true;
    this.#move_to(pose_of(pose));
    this.ellipse = ellipse_of(covariance[0] ?? 0, covariance[1] ?? 0, covariance[7] ?? 0);
    this.heading_sigma_rad = Math.sqrt(Math.max(0, covariance[35] ?? 0));
  }

  #move_to(pose: Pose): void {
    this.pose = pose;
    const last = this.trail.at(-1);
    if (!last || distance(last, pose) > trail_every_m) this.trail.push({ x: pose.x, y: pose.y });
  }

  #take_map(markers: Marker[]): void {
    for (const marker of markers) {
      const key = `${marker.ns}/${marker.id}`;
      if (marker.action === 3) this.marks.clear();
      else if (marker.action === 2) this.marks.delete(key);
      else this.marks.set(key, mark_of(marker));
    }
  }

  #take_mounts(transforms: TFMessage["transforms"]): void {
    const laser = transforms.find(({ child_frame_id }) => child_frame_id === "laser");
    if (!laser) return;
    const { translation, rotation } = laser.transform;
    this.#laser = { x: translation.x, y: translation.y, heading_rad: heading_of(rotation) };
  }

  #take_scan({ angle_min, angle_increment, range_max, ranges }: LaserScan): void {
    if (!this.pose) return;
    const points: Point[] = [];
    for (let beam = 0; beam < ranges.length; beam += 1) {
      const range_m = ranges[beam] ?? 0;
      if (range_m <= 0 || range_m >= range_max) continue;
      const heading = angle_min + beam * angle_increment;
      const p_laser = { x: range_m * Math.cos(heading), y: range_m * Math.sin(heading) };
      points.push(moved_by(this.pose, moved_by(this.#laser, p_laser)));
    }
    this.scan = points;
  }
}
