#include "imports/imported_vehicle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace aisle {
namespace {

/// Somewhere low at the front: a placeholder but for what the recording tells.
CameraDescription recorded_camera(const ImageSequence& images, const std::string& name) {
  const RecordedCamera recorded = images.camera();
  CameraDescription camera;
  if (recorded.topic.empty() && !name.empty()) camera.name = name;
  camera.width_px = images.width_px();
  camera.height_px = images.height_px();
  camera.intrinsics = recorded.lens.value_or(CameraIntrinsics{.fx_px = static_cast<double>(camera.width_px),
                                                              .fy_px = static_cast<double>(camera.width_px),
                                                              .cx_px = (camera.width_px - 1) / 2.0,
                                                              .cy_px = (camera.height_px - 1) / 2.0});
  camera.mount = recorded.mount.value_or(CameraMount{.p_vehicle_camera = {0, 0, 0.3}});
  return camera;
}

ImportedVehicle unknown_vehicle(const ImportedRecording& recording, const ImportOptions& options) {
  ImportedVehicle vehicle;
  vehicle.description.name = "unknown";
  if (recording.images)
    vehicle.description.cameras.push_back(recorded_camera(*recording.images, options.camera));
  if (recording.scans) vehicle.description.scanner = recording.scans->scanner;
  vehicle.known = {.lens = recording.camera().lens.has_value(),
                   .mount = recording.camera().mount.has_value(),
                   .scanner_mount = recording.has_scanner_mount};
  return vehicle;
}

/// Whether a word between the slashes of a topic is the name.
bool is_word_of(const std::string& topic, const std::string& name) {
  return ("/" + topic + "/").find("/" + name + "/") != std::string::npos;
}

/// Leaves the vehicle the one camera that took the images: its only one, that of the given name, or that
/// whose name is a word of the bag's topic.
Problems keep_camera(VehicleDescription& vehicle, const std::string& topic, const ImportOptions& options) {
  const std::string called = topic.empty() ? options.camera : topic;
  std::vector<std::string> names;
  for (const CameraDescription& camera : vehicle.cameras) names.push_back(camera.name);
  if (names.size() == 1 && (called.empty() || !topic.empty())) return {};
  std::erase_if(vehicle.cameras, [&](const auto& camera) { return !is_word_of(called, camera.name); });
  if (vehicle.cameras.size() == 1) return {};
  const std::string which = topic.empty()
                                ? "--camera names the one that took the images"
                                : fmt::format("which took the images of {} is not said by its name", topic);
  return {{{options.vehicle, 0, "cameras"},
           fmt::format("has the cameras [{}]: {}", fmt::join(names, ", "), which)}};
}

Problems check_size(const ImageSequence& images, const CameraDescription& camera,
                    const ImportOptions& options) {
  if (images.width_px() == camera.width_px && images.height_px() == camera.height_px) return {};
  return {
      {{options.recording},
       fmt::format("has images of {} x {} pixels; the camera '{}' of --vehicle has {} x {}",
                   images.width_px(), images.height_px(), camera.name, camera.width_px, camera.height_px)}};
}

/// The vehicle's own place of its scanner, the recording's beams.
Problems set_scanner(VehicleDescription& vehicle, const LaserScanner& recorded,
                     const ImportOptions& options) {
  if (!vehicle.scanner)
    return {{{options.vehicle, 0, "scanner"}, "is missing: the recording has scans, and the vehicle none"}};
  const Pose2 T_vehicle_laser = options.reading.T_vehicle_laser.value_or(vehicle.scanner->T_vehicle_laser);
  vehicle.scanner = recorded;
  vehicle.scanner->T_vehicle_laser = T_vehicle_laser;
  return {};
}

/// The recording's own rate, within what a vehicle file may say.
void set_periods(VehicleDescription& vehicle, double period_s) {
  if (period_s == 0) return;
  vehicle.cycle_s = std::clamp(period_s, 0.01, 2.0);
  for (CameraDescription& camera : vehicle.cameras) camera.period_s = std::clamp(period_s, 0.001, 10.0);
}

}  // namespace

Result<ImportedVehicle> imported_vehicle(std::optional<VehicleDescription> named,
                                         const ImportedRecording& recording, const ImportOptions& options) {
  ImportedVehicle vehicle;
  if (named) {
    vehicle = {std::move(*named), {.lens = true, .mount = true, .scanner_mount = true}, {}};
  } else {
    vehicle = unknown_vehicle(recording, options);
  }
  VehicleDescription& description = vehicle.description;
  if (named && recording.scans) {
    if (Problems problems = set_scanner(description, recording.scans->scanner, options); !problems.empty())
      return problems;
  }
  if (recording.images) {
    if (Problems problems = keep_camera(description, recording.camera().topic, options); !problems.empty())
      return problems;
    const CameraDescription& camera = description.cameras.front();
    if (Problems problems = check_size(*recording.images, camera, options); !problems.empty())
      return problems;
    vehicle.camera = camera.name;
  }
  set_periods(description, recording.period_s());
  return vehicle;
}

Problems vehicle_warnings(const ImportedVehicle& vehicle, const ImportedRecording& recording,
                          const ImportOptions& options) {
  Problems warnings;
  const KnownSensors& known = vehicle.known;
  const auto lens = recording.camera().lens;
  if (recording.images && !(known.lens && known.mount)) {
    const char* unknown = known.lens ? "mount" : known.mount ? "lens" : "lens and mount";
    warnings.push_back(
        {{options.recording},
         fmt::format("tells nothing of the camera's {}; --vehicle names a vehicle that does", unknown)});
  } else if (lens && !(*lens == vehicle.description.cameras.front().intrinsics)) {
    warnings.push_back({{options.recording, 0, recording.camera().topic},
                        "has another calibration than the camera of --vehicle, which is taken"});
  }
  if (recording.scans && !known.scanner_mount)
    warnings.push_back(
        {{options.recording}, "tells nothing of the scanner's place; --laser-offset or --vehicle do"});
  return warnings;
}

}  // namespace aisle
