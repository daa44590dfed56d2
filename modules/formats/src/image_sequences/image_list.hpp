#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "aisle/formats/image_sequences/image_sequence.hpp"
#include "image_sequences/left_out.hpp"

namespace aisle {

/// An image that a recording names.
struct ListedImage {
  double stamp_s = 0;
  std::filesystem::path file;
  std::optional<Pose2> T_odom_vehicle = {};
  std::optional<RecordedControls> controls = {};
};

/// All images that a recording names, in their order, and what its texts lacked.
struct ImageList {
  std::filesystem::path recording;  ///< the file or folder that names them
  std::vector<ListedImage> images;
  bool has_odometry = false;
  LeftOut unreadable;  ///< records that could not be read
  Problems warnings;
};

/// Reads the files of a list one after the other. Files that are missing, damaged or of another size than the
/// first are left out and counted.
Result<std::unique_ptr<ImageSequence>> sequence_of(ImageList list);

}  // namespace aisle
