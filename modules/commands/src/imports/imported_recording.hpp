#pragma once

#include <memory>
#include <optional>

#include "aisle/commands/import_recording.hpp"
#include "aisle/formats/image_sequences/image_sequence.hpp"
#include "aisle/formats/sessions/timed_scans.hpp"

namespace aisle {

/// What is imported: images, scans, or both on one clock.
struct ImportedRecording {
  std::unique_ptr<ImageSequence> images;  ///< null: none
  std::optional<TimedScans> scans;
  bool has_scanner_mount = false;  ///< the recording or the user gives the scanner's place
  bool has_odometry = false;
  Problems warnings;  ///< of the scans; the images have their own

  RecordedCamera camera() const { return images ? images->camera() : RecordedCamera{}; }
  /// Median time from one image to the next, or of scans if there are no images; 0: there is only one.
  double period_s() const;
};

/// @param front_steered  of the vehicle, if it is known
Result<ImportedRecording> open_recording(const ImportOptions& options,
                                         const std::optional<FrontSteered>& front_steered);

}  // namespace aisle
