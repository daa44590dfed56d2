#include "aisle/commands/import_recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "aisle/commands/packed_recording.hpp"
#include "aisle/commands/shipped_files.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/sessions/imported_session.hpp"
#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "imports/imported_recording.hpp"
#include "imports/imported_vehicle.hpp"

namespace aisle {
namespace {

constexpr double kSidewaysWarned_m = 0.05;

struct Imported {
  std::size_t images = 0, scans = 0;
  double first_s = 0, last_s = 0;

  void count(double stamp_s) {
    if (images + scans == 1) first_s = stamp_s;
    last_s = stamp_s;
  }
};

/// Images and scans in the order of their stamps.
class Merger {
 public:
  explicit Merger(ImportedRecording& recording) : recording_(recording) {}

  /// Takes the next of both. @return whether there was one
  Result<bool> take_next(ImportedSession& session, Imported& imported) {
    if (Problems problems = read_ahead(); !problems.empty()) return problems;
    const TimedScan* const scan =
        recording_.scans && at_ < recording_.scans->scans.size() ? &recording_.scans->scans[at_] : nullptr;
    if (!image_ && scan == nullptr) return false;
    const bool is_scan = scan != nullptr && (!image_ || scan->stamp_s < image_->stamp_s);
    if (Problems problems = is_scan ? session.take(*scan) : session.take(*image_); !problems.empty())
      return problems;
    ++(is_scan ? imported.scans : imported.images);
    imported.count(is_scan ? scan->stamp_s : image_->stamp_s);
    if (is_scan) {
      ++at_;
    } else {
      image_.reset();
    }
    return true;
  }

 private:
  Problems read_ahead() {
    if (image_ || !recording_.images) return {};
    auto image = recording_.images->next();
    if (!image) return image.problems();
    image_ = std::move(*image);
    return {};
  }

  ImportedRecording& recording_;
  std::optional<TimedImage> image_;
  std::size_t at_ = 0;  ///< the next scan
};

Result<Imported> take_all(ImportedRecording& recording, ImportedSession& session, Progress& progress) {
  Merger merger(recording);
  Imported imported;
  const std::size_t all = (recording.images ? recording.images->size() : 0) +
                          (recording.scans ? recording.scans->scans.size() : 0);
  while (true) {
    const auto more = merger.take_next(session, imported);
    if (!more) return more.problems();
    if (!*more) return imported;
    const std::size_t left_out = recording.images ? recording.images->left_out() : 0;
    progress.report("importing", imported.images + imported.scans + left_out, all);
  }
}

void warn_of_import(const ImportedRecording& recording, const ImportedVehicle& vehicle,
                    const ImportedSession& session, const ImportOptions& options, Console& console) {
  if (recording.images) warn_of(recording.images->warnings(), console);
  warn_of(recording.warnings, console);
  warn_of(vehicle_warnings(vehicle, recording, options), console);
  if (session.sideways_m() > kSidewaysWarned_m) {
    console.warn(
        to_string(Problem{{options.recording},
                          fmt::format("moves sideways, which wheels cannot: the session's odometry is "
                                      "up to {:.2f} m off the recorded poses",
                                      session.sideways_m())}));
  }
}

Outcome import_outcome(const ImportOptions& options, const ImportedRecording& recording,
                       const ImportedVehicle& vehicle, const Imported& imported) {
  const double duration_s = imported.last_s - imported.first_s;
  const double rate_hz = recording.period_s() > 0 ? 1 / recording.period_s() : 0;
  const std::size_t left_out = (recording.images ? recording.images->left_out() : 0) +
                               (recording.scans ? recording.scans->left_out : 0);
  Outcome outcome{.verb = "import"};
  outcome.figures = {{"images", imported.images},
                     {"scans", imported.scans},
                     {"duration_s", rounded(duration_s, 3)},
                     {"rate_hz", rounded(rate_hz, 3)},
                     {"left_out", left_out}};
  std::string what = imported.scans > 0 ? fmt::format("{} scans", imported.scans) : "";
  if (recording.images) {
    outcome.figures["camera"] = vehicle.camera;
    outcome.figures["width_px"] = recording.images->width_px();
    outcome.figures["height_px"] = recording.images->height_px();
    what = fmt::format("{} images of the camera {}{}{}", imported.images, vehicle.camera,
                       what.empty() ? "" : ", ", what);
  }
  outcome.figures["odometry"] = recording.has_odometry;
  outcome.figures["calibration"] = vehicle.known.is_calibrated(vehicle.description);
  outcome.files["session"] = options.out.string();
  outcome.text =
      fmt::format("{} in {:.1f} s, {:.1f} Hz, {} odometry; {} left out; session in {}\n", what, duration_s,
                  rate_hz, recording.has_odometry ? "with" : "without", left_out, options.out.string());
  return outcome;
}

Result<Outcome> import_unpacked(const ImportOptions& options, Console& console) {
  std::optional<VehicleDescription> named;
  std::optional<FrontSteered> front_steered;
  if (!options.vehicle.empty()) {
    auto model = read_shipped_or_own("vehicles", options.vehicle, read_vehicle);
    if (!model) return model.problems();
    named = std::move(model->description);
    if (!named->is_differential) front_steered = named->front_steered;
  }
  auto recording = open_recording(options, front_steered);
  if (!recording) return recording.problems();
  const auto vehicle = imported_vehicle(std::move(named), *recording, options);
  if (!vehicle) return vehicle.problems();
  auto session = ImportedSession::create(options.out, options.force, vehicle->description, vehicle->camera,
                                         vehicle->known, recording->has_odometry, options.storage);
  if (!session) return session.problems();
  const auto imported = take_all(*recording, *session, console.progress);
  if (!imported) return imported.problems();
  if (Problems problems = session->finish(); !problems.empty()) return problems;
  warn_of_import(*recording, *vehicle, *session, options, console);
  return import_outcome(options, *recording, *vehicle, *imported);
}

}  // namespace

Result<Outcome> run_import(const ImportOptions& options, Console& console) {
  return with_unpacked(options, &ImportOptions::recording, console, import_unpacked);
}

}  // namespace aisle
