#include "aisle/guidance/landmarks/continuity_monitor.hpp"

#include <algorithm>
#include <cmath>

#include "landmarks/same_lines.hpp"

namespace aisle {
namespace {

constexpr std::size_t kLinesMin = 5;  // fewer may come and go by themselves
constexpr double kShownShareMax = 0.2;
constexpr double kSteadyShareMin = 0.5;  // of new lines that the next image shows, too
constexpr int kBreaks = 5;               // images in a row
constexpr double kStays_m = 5;           // lines nearer than this do not come and go by their distance alone
constexpr double kInsideShare = 0.9;     // of the view: lines outside of this share may leave it

double bearing_off_axis_rad(const LandmarkSighting& sighting) {
  return std::abs(std::atan2(sighting.p_vehicle.y(), sighting.p_vehicle.x()));
}

bool stands_near(const LandmarkSighting& sighting) {
  return sighting.p_vehicle.norm() < kStays_m;
}

}  // namespace

void ContinuityMonitor::move(const Pose2& T_before_now) {
  const Pose2 T_now_before = T_before_now.inverse();
  carry_sightings(scene_, T_now_before);
  carry_sightings(latest_, T_now_before);
  since_.move(T_before_now);
}

bool ContinuityMonitor::look(std::span<const LandmarkSighting> image, bool is_known_here) {
  const bool goes_on =
      is_known_here || !can_tell() || (!lacks_what_must_stay(image) && !shows_what_was_not_there(image));
  breaks_ = goes_on ? 0 : breaks_ + 1;
  const bool is_broken = breaks_ >= kBreaks;
  if (goes_on || is_broken) take(image);
  latest_.assign(image.begin(), image.end());
  return is_broken;
}

bool ContinuityMonitor::can_tell() const {
  return has_scene_ && since_.is_comparable();
}

bool ContinuityMonitor::is_clear_of_lower_edge(const Vec2& p_vehicle) const {
  return kInsideShare * p_vehicle.x() > nearest_m_;
}

/// Distant lines come and go one by one, but not all at once.
bool ContinuityMonitor::lacks_what_must_stay(std::span<const LandmarkSighting> image) {
  compared_.clear();
  std::copy_if(scene_.begin(), scene_.begin() + steady_, std::back_inserter(compared_),
               [&](const LandmarkSighting& line) {
                 return (image.empty() || stands_near(line)) &&
                        bearing_off_axis_rad(line) < kInsideShare * span_rad_ &&
                        is_clear_of_lower_edge(line.p_vehicle);
               });
  return compared_.size() >= kLinesMin && shown_share(compared_, image) <= kShownShareMax;
}

bool ContinuityMonitor::shows_what_was_not_there(std::span<const LandmarkSighting> image) {
  compared_.clear();
  std::copy_if(image.begin(), image.end(), std::back_inserter(compared_), [&](const LandmarkSighting& line) {
    return stands_near(line) && is_clear_of_lower_edge(since_.T_then_now() * line.p_vehicle);
  });
  if (compared_.size() < kLinesMin || shown_share(compared_, scene_) > kShownShareMax) return false;
  return breaks_ == 0 || shown_share(compared_, latest_) >= kSteadyShareMin;
}

void ContinuityMonitor::take(std::span<const LandmarkSighting> image) {
  scene_.assign(image.begin(), image.end());
  const auto others = std::partition(scene_.begin(), scene_.end(),
                                     [&](const LandmarkSighting& line) { return shows(latest_, line); });
  steady_ = others - scene_.begin();
  span_rad_ = 0;
  for (const LandmarkSighting& line : image) span_rad_ = std::max(span_rad_, bearing_off_axis_rad(line));
  since_.start();
  has_scene_ = true;
  breaks_ = 0;
}

}  // namespace aisle
