#pragma once

#include <filesystem>
#include <memory>

#include "aisle/formats/image_sequences/image_sequence.hpp"

namespace aisle {

/// The images of one camera in a bag, each with the pose that the bag's odometry has at its time. Topics,
/// frames and clocks are chosen as docs/formats/bags.md says.
Result<std::unique_ptr<ImageSequence>> open_bag_images(const std::filesystem::path& bag,
                                                       const ImageSequenceOptions& options);

}  // namespace aisle
