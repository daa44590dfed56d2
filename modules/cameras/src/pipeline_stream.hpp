#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "aisle/core/clock.hpp"
#include "aisle/core/result.hpp"
#include "aisle/vehicle/camera_source.hpp"
#include "camera_pipeline.hpp"
#include "image_stream.hpp"

namespace aisle {

/// Images that GStreamer reads and decodes.
class PipelineStream final : public ImageStream {
 public:
  /// Reads from the source only when it is started.
  static Result<std::unique_ptr<ImageStream>> open(const CameraSource& source);

  ~PipelineStream() override;
  PipelineStream(const PipelineStream&) = delete;
  PipelineStream& operator=(const PipelineStream&) = delete;

  void start() override;
  StreamNews wait(double longest_s) override;

 private:
  PipelineStream(CameraPipeline parts, bool is_colour);
  void count_bytes();
  StreamNews image_of(GstSample* sample);
  double stamp_s(GstSample* sample) const;
  std::optional<std::string> trouble() const;

  CameraPipeline parts_;
  const bool is_colour_;
  SteadyClock clock_;
  std::atomic<std::size_t> bytes_since_image_ = 0;
};

}  // namespace aisle
