#pragma once

#include <cstddef>
#include <memory>

#include "aisle/core/clock.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/image_sequences/image_sequence.hpp"
#include "aisle/vehicle/camera_source.hpp"
#include "image_stream.hpp"

namespace aisle {

/// Replays a recording at the source's rate; no image is left out for want of time.
class FolderStream final : public ImageStream {
 public:
  static Result<std::unique_ptr<ImageStream>> open(const CameraSource& source);

  void start() override;
  StreamNews wait(double longest_s) override;

 private:
  FolderStream(const CameraSource& source, std::unique_ptr<ImageSequence> sequence);
  StreamNews next_image();
  StreamNews begin_again();

  const CameraSource source_;
  std::unique_ptr<ImageSequence> sequence_;
  SteadyClock clock_;
  double due_s_ = 0;  ///< when the next image is shown
  std::size_t left_out_ = 0;
  std::size_t shown_ = 0;
};

}  // namespace aisle
