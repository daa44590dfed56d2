#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "aisle/core/image.hpp"
#include "aisle/core/result.hpp"
#include "aisle/vehicle/camera_source.hpp"

namespace aisle {

/// An image and its moment: the middle of the exposure as far as it is known. That is when the driver says
/// that a device's image began, or when a network camera's image arrived, plus the source's exposure offset.
struct LiveImage {
  /// Never null. Grey as the camera sends it, which in raw video may be 16 to 235; or red, green, blue.
  std::shared_ptr<const Image> pixels;
  double stamp_s = 0;            ///< by SteadyClock
  std::int64_t realtime_ns = 0;  ///< the same moment since 1970, by the machine's clock
  std::uint64_t number = 0;      ///< counts what arrived, from 1: a gap are dropped images
};

/// What has happened since the camera was opened.
struct CameraCounts {
  std::size_t arrived = 0;   ///< without the refused ones
  std::size_t dropped = 0;   ///< of these, replaced by a newer one before anybody took them
  std::size_t refused = 0;   ///< of another size, or damaged
  std::size_t reopened = 0;  ///< attempts after the first
};

enum class CameraState {
  kOpening,    ///< no image yet
  kLive,       ///< images come
  kReopening,  ///< they did not come, or no longer; the camera is opened again and again
  kEnded       ///< a folder was shown to its end
};

class CameraWatch;

/// Images of a camera as they come, of which only the newest counts. A thread of its own keeps the camera
/// open: one that falls silent, or goes and comes back, is opened again. All calls are thread-safe.
class LiveCamera {
 public:
  /// Waits for no image.
  /// @return problems that no waiting mends: of the source, of the pipeline's text, GStreamer elements that
  /// are
  ///         not installed (with their Debian package), a device or folder that is not there
  static Result<std::unique_ptr<LiveCamera>> open(const CameraSource& source);

  /// Returns within a second, even if the camera's driver hangs.
  ~LiveCamera();
  LiveCamera(const LiveCamera&) = delete;
  LiveCamera& operator=(const LiveCamera&) = delete;

  /// The newest image that was not yet returned; waits for one if need be. All have the size of the first.
  /// @return nullopt if none came in time, or the images have ended
  std::optional<LiveImage> newest(std::chrono::milliseconds longest);

  CameraState state() const;

  /// What is wrong at present, in one line: "no image for 2 s from rtsp://camera/live: reopening". Empty:
  /// nothing.
  std::string problem() const;

  CameraCounts counts() const;

  /// The source as messages name it: without a URL's user, password and query.
  const std::string& name() const;

 private:
  LiveCamera(std::shared_ptr<CameraWatch> watch, std::thread thread);

  std::shared_ptr<CameraWatch>
      watch_;  ///< shared with the thread, which may outlive this object when a driver hangs
  std::thread thread_;
};

}  // namespace aisle
