#include "camera_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "aisle/core/median.hpp"
#include "aisle/formats/bags/bag_camera.hpp"
#include "aisle/vehicle/same_camera.hpp"
#include "first_contact.hpp"

namespace aisle {
namespace {

constexpr const char* kVehicleFile = "the vehicle file";

/// Says where the lens that is used differs from the vehicle file's.
void compare_lenses(const CameraDescription& in_file, const CameraDescription& used, const Place& place,
                    Problems& notes) {
  CameraDescription same_mount = used;
  same_mount.mount = in_file.mount;
  for (const Problem& difference : check_same_camera(in_file, same_mount))
    notes.push_back({place, fmt::format("{} differs from that of the vehicle file, which is not used",
                                        difference.where.key)});
}

/// @return where the lens is from; empty: nobody says it
std::string take_lens(const SeenCamera& seen, const CameraDescription* in_file, const ArrivingImages& state,
                      const std::string& calibration_topic, CameraDescription& camera, Problems& notes) {
  if (state.calibration) {
    const auto lens = bag_lens(*state.calibration, seen.images, camera.width_px, camera.height_px,
                               {{calibration_topic}, {}}, notes);
    if (lens) {
      camera.intrinsics = *lens;
      if (in_file != nullptr) compare_lenses(*in_file, camera, {calibration_topic}, notes);
      return calibration_topic;
    }
  }
  if (in_file == nullptr || in_file->width_px != camera.width_px || in_file->height_px != camera.height_px)
    return {};
  camera.intrinsics = in_file->intrinsics;
  return kVehicleFile;
}

/// In the vehicle's frame, whose origin may lie elsewhere than the robot's base frame.
std::optional<CameraMount> mount_by_transforms(const Connection& connection, const RobotState& state,
                                               const std::string& frame, const Place& place,
                                               Problems& notes) {
  auto mount = bag_mount(state.transforms, connection.frames.base, frame, {place, {}}, notes);
  if (!mount) return mount;
  mount->p_vehicle_camera.head<2>() -= connection.frames.p_base_axle_m;
  return mount;
}

}  // namespace

bool needs_mount(const Connection& connection, const ConnectedCamera& camera) {
  return connection.frames.mounts == ConnectedFrames::Mounts::kTransforms && !camera.topic.empty();
}

CameraLack lack_of(const Connection& connection, const VehicleDescription& vehicle, const RobotState& state,
                   std::size_t which) {
  const ConnectedCamera& camera = connection.cameras[which];
  const ArrivingImages& seen = state.cameras[which];
  if (seen.images.empty()) return CameraLack::kImages;
  if (seen.stream.periods_s.size() < kPeriodsNeeded) return CameraLack::kStamps;
  if (!seen.calibration && vehicle.camera(camera.name) == nullptr) return CameraLack::kCalibration;
  if (needs_mount(connection, camera) && !state.transforms.find(connection.frames.base, seen.stream.frame))
    return CameraLack::kMount;
  return CameraLack::kNothing;
}

Result<SeenCamera> seen_camera(const Connection& connection, const VehicleDescription& vehicle,
                               RobotIntake& intake, std::size_t which, Problems& notes) {
  const ConnectedCamera& connected = connection.cameras[which];
  const ArrivingImages& state = intake.state().cameras[which];
  const CameraDescription* const in_file = vehicle.camera(connected.name);
  const auto pixels = intake.pixels_of(state.images.back(), which);
  if (!pixels) return pixels.problems();
  SeenCamera seen;
  seen.images = intake.camera_name(which);
  seen.mount_from = kVehicleFile;
  CameraDescription& camera = seen.camera;
  if (in_file != nullptr) camera = *in_file;
  camera.name = connected.name;
  camera.width_px = (*pixels)->width_px;
  camera.height_px = (*pixels)->height_px;
  camera.period_s = median(state.stream.periods_s);
  seen.lens_from =
      take_lens(seen, in_file, state, connection.topic(connected.calibration_topic()), camera, notes);
  const auto refused = [&](std::string what) {
    Problems problems = notes;
    problems.push_back({{seen.images}, std::move(what)});
    return problems;
  };
  if (seen.lens_from.empty())
    return refused(
        fmt::format("nobody says the lens of these images of {} x {} pixels: 'aisle calibrate "
                    "camera' measures it, for the camera '{}' of the vehicle file",
                    camera.width_px, camera.height_px, camera.name));
  if (needs_mount(connection, connected)) {
    const auto mount =
        mount_by_transforms(connection, intake.state(), state.stream.frame, {seen.images}, notes);
    if (!mount) return refused("its mount is not known; 'frames: {mounts: file}' takes the vehicle file's");
    camera.mount = *mount;
    seen.mount_from = "/tf_static";
  } else if (in_file == nullptr) {
    return refused(
        fmt::format("the vehicle file has no camera '{}', so its mount cannot be 'file'", camera.name));
  }
  return seen;
}

}  // namespace aisle
