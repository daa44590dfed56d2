#include "aisle/cameras/live_camera.hpp"

#include <utility>

#include "camera_watch.hpp"
#include "open_stream.hpp"

namespace aisle {
namespace {

constexpr std::chrono::milliseconds kStopping(900);

}  // namespace

Result<std::unique_ptr<LiveCamera>> LiveCamera::open(const CameraSource& source) {
  if (Problems problems = source.problems(); !problems.empty()) return problems;
  auto stream = open_stream(source);
  if (!stream) return stream.problems();
  auto watch = std::make_shared<CameraWatch>(source);
  std::thread thread([watch, stream = std::move(*stream)]() mutable { watch->run(std::move(stream)); });
  return std::unique_ptr<LiveCamera>(new LiveCamera(std::move(watch), std::move(thread)));
}

LiveCamera::LiveCamera(std::shared_ptr<CameraWatch> watch, std::thread thread)
    : watch_(std::move(watch)), thread_(std::move(thread)) {}

LiveCamera::~LiveCamera() {
  watch_->stop();
  if (watch_->is_over_within(kStopping)) {
    thread_.join();
  } else {
    thread_.detach();  // a driver hangs; what it uses lives as long as the thread
  }
}

std::optional<LiveImage> LiveCamera::newest(std::chrono::milliseconds longest) {
  return watch_->newest(longest);
}

CameraState LiveCamera::state() const {
  return watch_->state();
}

std::string LiveCamera::problem() const {
  return watch_->problem();
}

CameraCounts LiveCamera::counts() const {
  return watch_->counts();
}

const std::string& LiveCamera::name() const {
  return watch_->name();
}

}  // namespace aisle
