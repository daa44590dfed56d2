#include "camera_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "camera_url.hpp"
#include "open_stream.hpp"

namespace aisle {
namespace {

constexpr double kPoll_s = 0.1;  // how long stopping may take
// RTSP tries UDP for 5 s, and videos have a whole image every few seconds only.
constexpr double kFirstImage_s = 10;

std::string shown_name(const CameraSource& source) {
  if (!source.device.empty()) return source.device;
  if (!source.url.empty()) return without_secrets(source.url);
  if (!source.folder.empty()) return source.folder;
  return "the pipeline";
}

/// The moment that was at `stamp_s` by a steady clock at which it is `now_s`.
std::int64_t realtime_ns(double stamp_s, double now_s) {
  const auto age = std::chrono::duration<double, std::nano>((now_s - stamp_s) * 1e9);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now - age).count();
}

}  // namespace

CameraWatch::CameraWatch(const CameraSource& source)
    : source_(source),
      name_(shown_name(source)),
      width_px_(source.width_px),
      height_px_(source.height_px),
      heard_s_(clock_.now_s()) {}

void CameraWatch::run(std::unique_ptr<ImageStream> stream) {
  double opened_s = clock_.now_s();
  follow(*stream);
  stream.reset();
  while (waits_to_reopen(opened_s)) {
    opened_s = clock_.now_s();
    if (const auto again = open_stream(source_)) {
      follow(**again);
    } else {
      give_up(again.problems().front().what);
    }
  }
  const std::lock_guard lock(mutex_);
  is_over_ = true;
  changed_.notify_all();
}

void CameraWatch::follow(ImageStream& stream) {
  stream.start();
  double heard_s = clock_.now_s();
  double patience_s = std::max(kFirstImage_s, gap_max_s());
  while (!is_stopped()) {
    StreamNews news = stream.wait(kPoll_s);
    if (const auto* end = std::get_if<StreamEnd>(&news))
      return give_up(end->why, end->is_final ? CameraState::kEnded : CameraState::kReopening);
    if (auto* image = std::get_if<StreamedImage>(&news)) take(std::move(*image));
    if (const auto* refused = std::get_if<RefusedImage>(&news)) refuse(refused->why);
    if (!std::holds_alternative<NothingYet>(news)) {
      heard_s = clock_.now_s();
      patience_s = gap_max_s();
    } else if (clock_.now_s() - heard_s > patience_s) {
      return give_up("");
    }
  }
}

bool CameraWatch::waits_to_reopen(double opened_s) {
  std::unique_lock lock(mutex_);
  const std::chrono::duration<double> rest(opened_s + source_.silent_max_s - clock_.now_s());
  if (state_ == CameraState::kEnded || changed_.wait_for(lock, rest, [this] { return is_stopped_; }))
    return false;
  ++counts_.reopened;
  return true;
}

void CameraWatch::take(StreamedImage streamed) {
  const Image& pixels = streamed.pixels;
  if (width_px_ == 0) {
    width_px_ = pixels.width_px;
    height_px_ = pixels.height_px;
  }
  if (pixels.width_px != width_px_ || pixels.height_px != height_px_) {
    return refuse(fmt::format("has {} x {} pixels instead of {} x {}", pixels.width_px, pixels.height_px,
                              width_px_, height_px_));
  }
  const double now_s = clock_.now_s();
  const double stamp_s = streamed.stamp_s + source_.exposure_offset_s;
  put({.pixels = std::make_shared<const Image>(std::move(streamed.pixels)),
       .stamp_s = stamp_s,
       .realtime_ns = realtime_ns(stamp_s, now_s)},
      now_s);
}

void CameraWatch::put(LiveImage image, double now_s) {
  const std::lock_guard lock(mutex_);
  state_ = CameraState::kLive;
  trouble_.clear();
  heard_s_ = now_s;
  image.number = ++counts_.arrived;
  if (untaken_) ++counts_.dropped;
  untaken_ = std::move(image);
  changed_.notify_all();
}

void CameraWatch::refuse(const std::string& why) {
  const std::lock_guard lock(mutex_);
  ++counts_.refused;
  trouble_ = "an image is refused: " + why;
}

void CameraWatch::give_up(std::string why, CameraState state) {
  const std::lock_guard lock(mutex_);
  state_ = state;
  trouble_ = std::move(why);
  changed_.notify_all();
}

double CameraWatch::gap_max_s() const {
  return source_.silent_max_s + (source_.folder.empty() ? 0 : 1 / source_.rate_hz);
}

void CameraWatch::stop() {
  const std::lock_guard lock(mutex_);
  is_stopped_ = true;
  changed_.notify_all();
}

bool CameraWatch::is_stopped() const {
  const std::lock_guard lock(mutex_);
  return is_stopped_;
}

bool CameraWatch::is_over_within(std::chrono::milliseconds longest) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, longest, [this] { return is_over_; });
}

std::optional<LiveImage> CameraWatch::newest(std::chrono::milliseconds longest) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, longest, [this] { return untaken_ || state_ == CameraState::kEnded; });
  return std::exchange(untaken_, std::nullopt);
}

CameraState CameraWatch::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

std::string CameraWatch::problem() const {
  const std::lock_guard lock(mutex_);
  const std::string_view remedy = state_ == CameraState::kReopening ? ": reopening" : "";
  if (!trouble_.empty()) return fmt::format("{}: {}{}", name_, trouble_, remedy);
  const double silence_s = clock_.now_s() - heard_s_;
  if (state_ == CameraState::kEnded || silence_s < gap_max_s()) return "";
  return fmt::format("no image for {:.1f} s from {}{}", silence_s, name_, remedy);
}

CameraCounts CameraWatch::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

}  // namespace aisle
