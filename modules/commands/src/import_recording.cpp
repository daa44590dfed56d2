#include "aisle/commands/import_recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "aisle/commands/shipped_files.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/bags/bag_reader.hpp"
#include "aisle/formats/image_sequences/image_sequence.hpp"
#include "aisle/formats/sessions/imported_session.hpp"
#include "aisle/formats/worlds/vehicle_yaml.hpp"

namespace aisle {
namespace {

constexpr double kSidewaysWarned_m = 0.05;

/// Somewhere low at the front: placeholders that a session marks as such, but for what the recording tells.
VehicleDescription unknown_vehicle(const ImageSequence& images, const std::string& camera) {
  VehicleDescription vehicle;
  vehicle.name = "unknown";
  CameraDescription& front = vehicle.cameras.emplace_back();
  const RecordedCamera recorded = images.camera();
  if (recorded.topic.empty() && !camera.empty()) front.name = camera;
  front.width_px = images.width_px();
  front.height_px = images.height_px();
  front.intrinsics = recorded.lens.value_or(CameraIntrinsics{.fx_px = static_cast<double>(front.width_px),
                                                             .fy_px = static_cast<double>(front.width_px),
                                                             .cx_px = (front.width_px - 1) / 2.0,
                                                             .cy_px = (front.height_px - 1) / 2.0});
  front.mount = recorded.mount.value_or(CameraMount{.p_vehicle_camera = {0, 0, 0.3}});
  return vehicle;
}

/// Whether a word between the slashes of a topic is the name.
bool is_word_of(const std::string& topic, const std::string& name) {
  return ("/" + topic + "/").find("/" + name + "/") != std::string::npos;
}

/// Leaves the vehicle the one camera that took the images: its only one, that of the given name, or that
/// whose name is a word of the bag's topic.
Problems keep_camera(VehicleDescription& vehicle, const ImageSequence& images, const ImportOptions& options) {
  const std::string topic = images.camera().topic;
  const std::string called = topic.empty() ? options.camera : topic;
  std::vector<std::string> names;
  for (const CameraDescription& camera : vehicle.cameras) names.push_back(camera.name);
  if (names.size() == 1 && (called.empty() || !topic.empty())) return {};
  std::erase_if(vehicle.cameras, [&](const auto& camera) { return !is_word_of(called, camera.name); });
  if (vehicle.cameras.size() == 1) return {};
  return {{{options.vehicle, 0, "cameras"},
           fmt::format("has the cameras [{}]: {}", fmt::join(names, ", "),
                       topic.empty()
                           ? "--camera names the one that took the images"
                           : fmt::format("which took the images of {} is not said by its name", topic))}};
}

Problems check_size(const ImageSequence& images, const CameraDescription& camera,
                    const ImportOptions& options) {
  if (images.width_px() == camera.width_px && images.height_px() == camera.height_px) return {};
  return {
      {{options.recording},
       fmt::format("has images of {} x {} pixels; the camera '{}' of --vehicle has {} x {}",
                   images.width_px(), images.height_px(), camera.name, camera.width_px, camera.height_px)}};
}

/// The images' own rate, within what a vehicle file may say.
void set_periods(VehicleDescription& vehicle, double period_s) {
  if (period_s == 0) return;
  vehicle.cycle_s = std::clamp(period_s, 0.01, 2.0);
  vehicle.cameras.front().period_s = std::clamp(period_s, 0.001, 10.0);
}

struct ImportedImages {
  std::size_t count = 0;
  double first_s = 0;
  double last_s = 0;
};

Result<ImportedImages> take_all(ImageSequence& images, ImportedSession& session, Progress& progress) {
  ImportedImages imported;
  while (true) {
    const auto image = images.next();
    if (!image) return image.problems();
    if (!image->has_value()) return imported;
    if (Problems problems = session.take(**image); !problems.empty()) return problems;
    if (imported.count == 0) imported.first_s = (*image)->stamp_s;
    imported.last_s = (*image)->stamp_s;
    ++imported.count;
    progress.report("importing images", imported.count + images.left_out(), images.size());
  }
}

/// What the session knows of its camera.
KnownSensors known_sensors(const ImageSequence& images, const ImportOptions& options) {
  if (!options.vehicle.empty()) return {.lens = true, .mount = true};
  const RecordedCamera recorded = images.camera();
  return {.lens = recorded.lens.has_value(), .mount = recorded.mount.has_value()};
}

void warn_of_camera(const ImageSequence& images, const VehicleDescription& vehicle,
                    const ImportOptions& options, Console& console) {
  const KnownSensors known = known_sensors(images, options);
  const auto recorded_lens = images.camera().lens;
  if (!known.lens || !known.mount) {
    const char* unknown = known.lens ? "mount" : known.mount ? "lens" : "lens and mount";
    console.warn(to_string(Problem{
        {options.recording},
        fmt::format("tells nothing of the camera's {}; --vehicle names a vehicle that does", unknown)}));
  } else if (recorded_lens && !(*recorded_lens == vehicle.cameras.front().intrinsics)) {
    console.warn(to_string(Problem{{options.recording, 0, images.camera().topic},
                                   "has another calibration than the camera of --vehicle, which is taken"}));
  }
}

void warn_of_import(const ImageSequence& images, const ImportedSession& session, const ImportOptions& options,
                    Console& console) {
  warn_of(images.warnings(), console);
  if (session.sideways_m() > kSidewaysWarned_m) {
    console.warn(
        to_string(Problem{{options.recording},
                          fmt::format("moves sideways, which wheels cannot: the session's odometry is "
                                      "up to {:.2f} m off the recorded poses",
                                      session.sideways_m())}));
  }
}

Outcome import_outcome(const ImportOptions& options, const ImageSequence& images, const std::string& camera,
                       const ImportedImages& imported) {
  const KnownSensors known = known_sensors(images, options);
  const double duration_s = imported.last_s - imported.first_s;
  const double rate_hz = images.period_s() > 0 ? 1 / images.period_s() : 0;
  Outcome outcome{.verb = "import"};
  outcome.figures = {{"images", imported.count},
                     {"duration_s", rounded(duration_s, 3)},
                     {"rate_hz", rounded(rate_hz, 3)},
                     {"left_out", images.left_out()},
                     {"camera", camera},
                     {"width_px", images.width_px()},
                     {"height_px", images.height_px()},
                     {"odometry", images.has_odometry()},
                     {"calibration", known.lens && known.mount}};
  outcome.files["session"] = options.out.string();
  outcome.text = fmt::format(
      "{} images of the camera {} in {:.1f} s, {:.1f} Hz, {} odometry; {} left out; session in {}\n",
      imported.count, camera, duration_s, rate_hz, images.has_odometry() ? "with" : "without",
      images.left_out(), options.out.string());
  return outcome;
}

}  // namespace

Result<Outcome> run_import(const ImportOptions& options, Console& console) {
  ImageSequenceOptions reading{.rate_hz = options.rate_hz, .front_steered = {}};
  reading.odometry = options.odometry;
  if (is_bag(options.recording)) reading.topic = options.camera;
  std::optional<VehicleDescription> vehicle;
  if (!options.vehicle.empty()) {
    auto named = read_shipped_or_own("vehicles", options.vehicle, read_vehicle);
    if (!named) return named.problems();
    vehicle = std::move(named->description);
    if (!vehicle->is_differential) reading.front_steered = vehicle->front_steered;
  }
  const auto opened = open_image_sequence(options.recording, reading);
  if (!opened) return opened.problems();
  ImageSequence& images = **opened;
  if (!vehicle) vehicle = unknown_vehicle(images, options.camera);
  if (Problems problems = keep_camera(*vehicle, images, options); !problems.empty()) return problems;
  const std::string camera = vehicle->cameras.front().name;
  if (Problems problems = check_size(images, vehicle->cameras.front(), options); !problems.empty())
    return problems;
  set_periods(*vehicle, images.period_s());

  auto session = ImportedSession::create(options.out, options.force, *vehicle, camera,
                                         known_sensors(images, options), images.has_odometry());
  if (!session) return session.problems();
  const auto imported = take_all(images, *session, console.progress);
  if (!imported) return imported.problems();
  if (Problems problems = session->finish(); !problems.empty()) return problems;
  warn_of_import(images, *session, options, console);
  warn_of_camera(images, *vehicle, options, console);
  return import_outcome(options, images, camera, *imported);
}

}  // namespace aisle
