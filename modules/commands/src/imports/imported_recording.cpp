#include "imports/imported_recording.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "aisle/core/median.hpp"
#include "aisle/formats/bags/bag_overview.hpp"
#include "aisle/formats/logs/read_laser_recording.hpp"

namespace aisle {
namespace {

/// Whether a bag is to be read for its images: it has some, or the user names their topic.
Result<bool> is_bag_of_images(const ImportOptions& options) {
  if (!options.camera.empty()) return true;
  const auto bag = BagReader::open(options.recording);
  if (!bag) return bag.problems();
  bool has_scans = false;
  for (const BagTopic& topic : bag->topics()) {
    if (topic.messages > 0 && served_by(topic) == "camera") return true;
    has_scans |= topic.messages > 0 && served_by(topic) == "scan";
  }
  return !has_scans;
}

Problems take_scans(LaserRecording recording, const ImportOptions& options, ImportedRecording& imported) {
  imported.has_odometry = !recording.log.odometry.empty();
  imported.has_scanner_mount = recording.has_mounting;
  imported.warnings = std::move(recording.warnings);
  imported.scans = timed_scans(std::move(recording.log), options.recording, imported.warnings);
  if (!imported.scans->scans.empty()) return {};
  return {{{options.recording}, "has no scan that a session can store"}};
}

Result<ImportedRecording> open_images(const ImportOptions& options, const ImageSequenceOptions& reading) {
  auto images = open_image_sequence(options.recording, reading);
  if (!images) return images.problems();
  ImportedRecording imported;
  if (auto scans = (*images)->take_scans()) {
    if (Problems problems = take_scans(std::move(*scans), options, imported); !problems.empty())
      return problems;
  }
  imported.images = std::move(*images);
  imported.has_odometry = imported.images->has_odometry();
  return imported;
}

Result<ImportedRecording> open_scans(const ImportOptions& options) {
  if (options.rate_hz)
    return Problem{{options.recording}, "has stamps: --image-rate is for images that have none"};
  auto recording = read_laser_recording(options.recording, options.reading);
  if (!recording) return recording.problems();
  ImportedRecording imported;
  if (Problems problems = take_scans(std::move(*recording), options, imported); !problems.empty())
    return problems;
  return imported;
}

}  // namespace

double ImportedRecording::period_s() const {
  if (images) return images->period_s();
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < scans->scans.size(); ++i)
    steps_s.push_back(scans->scans[i].stamp_s - scans->scans[i - 1].stamp_s);
  return steps_s.empty() ? 0 : median(std::move(steps_s));
}

Result<ImportedRecording> open_recording(const ImportOptions& options,
                                         const std::optional<FrontSteered>& front_steered) {
  ImageSequenceOptions reading{.rate_hz = options.rate_hz, .front_steered = front_steered};
  if (is_bag(options.recording)) {
    const auto of_images = is_bag_of_images(options);
    if (!of_images) return of_images.problems();
    if (!*of_images) return open_scans(options);
    reading.topic = options.camera;
    reading.reading = options.reading;
  } else if (is_laser_recording(options.recording)) {
    return open_scans(options);
  }
  return open_images(options, reading);
}

}  // namespace aisle
