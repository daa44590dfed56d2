#include "aisle/vehicle/camera_description.hpp"

namespace aisle {

void CameraDescription::describe(FieldList& fields) {
  fields.count("width_px", width_px, {16, 8192}, "width of its images");
  fields.count("height_px", height_px, {16, 8192}, "height of its images");
  fields.real("fx_px", intrinsics.fx_px, {1, 1e5}, "focal length along u");
  fields.real("fy_px", intrinsics.fy_px, {1, 1e5}, "focal length along v");
  fields.real("cx_px", intrinsics.cx_px, {-1e4, 1e4}, "where the optical axis meets the image");
  fields.real("cy_px", intrinsics.cy_px, {-1e4, 1e4}, "where the optical axis meets the image");
  fields.real("k1", intrinsics.k1, {-1e4, 1e4}, "radial distortion");
  fields.real("k2", intrinsics.k2, {-1e4, 1e4}, "radial distortion");
  fields.real("p1", intrinsics.p1, {-1, 1}, "tangential distortion");
  fields.real("p2", intrinsics.p2, {-1, 1}, "tangential distortion");
  fields.real("k3", intrinsics.k3, {-1e4, 1e4}, "radial distortion");
  fields.real("x_m", mount.p_vehicle_camera.x(), {-10, 10}, "lens ahead of base_link");
  fields.real("y_m", mount.p_vehicle_camera.y(), {-10, 10}, "lens to the left of base_link");
  fields.real("z_m", mount.p_vehicle_camera.z(), {0.01, 10}, "lens above the floor");
  fields.angle("tilt_deg", mount.tilt_rad, {-90, 90}, "tilt of the camera, looking down positive");
  fields.angle("pan_deg", mount.pan_rad, {-180, 180}, "pan of the camera, looking to the left positive");
  fields.angle("roll_deg", mount.roll_rad, {-180, 180}, "roll of the camera, leaning to the right positive");
  fields.real("period_s", period_s, {0.001, 10}, "from one image to the next");
}

}  // namespace aisle
