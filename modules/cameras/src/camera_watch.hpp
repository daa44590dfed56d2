#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "aisle/cameras/live_camera.hpp"
#include "aisle/core/clock.hpp"
#include "image_stream.hpp"

namespace aisle {

/// Keeps a camera open, and its newest image until somebody takes it.
class CameraWatch {
 public:
  explicit CameraWatch(const CameraSource& source);

  /// What the camera's own thread does: until it is stopped, or everything was shown.
  void run(std::unique_ptr<ImageStream> stream);
  void stop();
  /// Whether run() has returned, or does within this time.
  bool is_over_within(std::chrono::milliseconds longest);

  std::optional<LiveImage> newest(std::chrono::milliseconds longest);
  CameraState state() const;
  std::string problem() const;
  CameraCounts counts() const;
  const std::string& name() const { return name_; }

 private:
  /// Until the stream ends or is silent for too long.
  void follow(ImageStream& stream);
  /// Waits until the next attempt is due. @return whether there is one
  bool waits_to_reopen(double opened_s);

  void take(StreamedImage streamed);
  void put(LiveImage image, double now_s);
  void refuse(const std::string& why);
  void give_up(std::string why, CameraState state = CameraState::kReopening);

  /// The longest time from one image to the next that is no silence.
  double gap_max_s() const;
  bool is_stopped() const;

  const CameraSource source_;
  const std::string name_;
  const SteadyClock clock_;
  int width_px_;  ///< of every image; 0: none came yet. Only the camera's thread uses both
  int height_px_;

  mutable std::mutex mutex_;  ///< of all that follows
  std::condition_variable changed_;
  bool is_stopped_ = false;
  bool is_over_ = false;
  CameraState state_ = CameraState::kOpening;
  std::string trouble_;  ///< why there are no images; empty: only the time since the last one tells
  double heard_s_;       ///< when the last image came, or the watch began
  std::optional<LiveImage> untaken_;
  CameraCounts counts_;
};

}  // namespace aisle
