#include "aisle/learning/walls/odometry_delay.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr int kEarliest = -10;  // tenths of a scan period
constexpr int kLatest = 30;
constexpr std::size_t kComparisonsMin = 20;
constexpr double kTurnMin_rad = 0.5 * kDegree;  // scans with less turn say nothing
constexpr double kOutlier_rad = 3 * kDegree;
constexpr double kWorthIt = 0.9;  // a delay must reduce the disagreement to less than this share

}  // namespace

OdometryDelayEstimator::OdometryDelayEstimator(const OdometryTrack& odometry, double scan_period_s,
                                               double guess_s)
    : odometry_(odometry), scan_period_s_(scan_period_s), guess_s_(guess_s) {
  for (int tenth = kEarliest; tenth <= kLatest; ++tenth)
    candidates_.push_back({tenth * 0.1 * scan_period_s, 0});
}

void OdometryDelayEstimator::add(double time_s, std::size_t odometry_known,
                                 std::optional<double> frame_heading_rad) {
  recent_.push_back({time_s, frame_heading_rad});
  if (recent_.size() < 3) return;
  // One scan late, so that odometry recorded too early can still be looked up without extrapolation.
  compare(recent_[0], recent_[1], odometry_known);
  recent_.erase(recent_.begin());
}

void OdometryDelayEstimator::compare(const Seen& a, const Seen& b, std::size_t odometry_known) {
  if (!a.frame_heading_rad || !b.frame_heading_rad) return;
  if (b.time_s - a.time_s > 3 * scan_period_s_) return;
  const double seen_turn = -(*b.frame_heading_rad - *a.frame_heading_rad);
  if (std::abs(wrap_quarter_turn(seen_turn)) < kTurnMin_rad) return;
  for (Candidate& candidate : candidates_) {
    const double odometry_turn = odometry_.at(b.time_s - candidate.delay_s, odometry_known).theta -
                                 odometry_.at(a.time_s - candidate.delay_s, odometry_known).theta;
    const double disagreement = std::abs(wrap_quarter_turn(seen_turn - odometry_turn));
    candidate.disagreement_rad += std::min(disagreement, kOutlier_rad);
  }
  ++comparisons_;
}

double OdometryDelayEstimator::delay_s() const {
  if (comparisons_ < kComparisonsMin) return guess_s_;
  const auto best = std::min_element(
      candidates_.begin(), candidates_.end(),
      [](const Candidate& a, const Candidate& b) { return a.disagreement_rad < b.disagreement_rad; });
  const Candidate& none = candidates_[-kEarliest];
  return best->disagreement_rad < kWorthIt * none.disagreement_rad ? best->delay_s : 0;
}

}  // namespace aisle
