/** The fields of ROS 2 messages that the page reads. */

export interface Vector3 {
  x: number;
  y: number;
  z: number;
}

export interface Quaternion extends Vector3 {
  w: number;
}

export interface RosPose {
  position: Vector3;
  orientation: Quaternion;
}

export interface Header {
  stamp: { sec: number; nanosec: number };
  frame_id: string;
}

export interface PoseWithCovarianceStamped {
  header: Header;
  /** Row-major, 6 x 6: x, y, z and the rotations about x, y, z. */
  pose: { pose: RosPose; covariance: ArrayLike<number> };
}

export interface Odometry {
  header: Header;
  pose: { pose: RosPose };
  twist: { twist: { linear: Vector3; angular: Vector3 } };
}

export interface Path {
  poses: { pose: RosPose }[];
}

export interface TFMessage {
  transforms: {
    header: Header;
    child_frame_id: string;
    transform: { translation: Vector3; rotation: Quaternion };
  }[];
}

export interface LaserScan {
  angle_min: number;
  angle_increment: number;
  range_max: number;
  ranges: ArrayLike<number>;
}

export interface Marker {
  ns: string;
  id: number;
  type: number;
  action: number;
  pose: RosPose;
  scale: Vector3;
  points: Vector3[];
  text: string;
}

export interface MarkerArray {
  markers: Marker[];
}

export interface CompressedImage {
  header: Header;
  format: string;
  data: Uint8Array;
}

export interface Image {
  header: Header;
  width: number;
  height: number;
  encoding: string;
  step: number;
  data: Uint8Array;
}

export const marker_type = {
  cube: 1,
  line_strip: 4,
  line_list: 5,
  cube_list: 6,
  sphere_list: 7,
  points: 8,
  text: 9,
};
