#include "aisle/learning/walls/scan_tracker.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "aisle/core/square.hpp"
#include "aisle/geometry/dominant_direction.hpp"
#include "aisle/geometry/pose_change.hpp"
#include "aisle/learning/walls/wall_heading.hpp"
#include "walls/relocation.hpp"

namespace aisle {
namespace {

constexpr double kAxesShare = 0.5;    // least share of the first scan's walls on a frame that gives the axes
constexpr double kStartSigma = 1e-3;  // [m, rad]: the first pose defines the frame
constexpr int kAlignmentIterations = 6;
constexpr double kDoubtful = 0.7;     // if less of the seen length fits, the odometry may be wrong
constexpr double kDoubtful_m = 0.03;  // ... after a motion of at least this
constexpr double kClearlyBetter = 0.15;
constexpr double kRelocationSeen_m = 2;  // with less wall in sight, guessing is worse than doing nothing
constexpr double kGuessReach_m = 0.3;    // an earlier scan may be this far from its guess ...
constexpr double kGuessReach_rad = 3 * kDegree;
constexpr double kGuessSigma_m = 0.05;  // ... but usually is within this
constexpr double kGuessSigma_rad = 1 * kDegree;
constexpr double kLaidAgainShare = 0.5;  // least share of the seen length that must fit
constexpr int kAgreeingScans = 3;        // scans that must agree on the pose before it is believed ...
constexpr double kAgreeingPath_m = 0.3;  // ... over this path length: at one place they count as one ...
constexpr double kAgreeing_m = 0.15;     // ... within this of each other
constexpr double kAgreeing_rad = 5 * kDegree;
constexpr double kNoWall_per_m2 = 1;  // information in a direction that no wall constrains
constexpr double kAcross = 0.7;       // cosine between the motion and the normal of a wall across it
constexpr double kRelocatedPoseSigma_m = 0.05;
constexpr double kRelocatedPoseSigma_rad = 2 * kDegree;

}  // namespace

void TrackerParams::describe(FieldList& fields) {
  fields.group("motion", motion);
  fields.real("gate_m", gate_m, {0.02, 2}, "a segment farther from a wall is not matched with it");
  fields.real("same_wall_m", same_wall_m, {0.01, 1},
              "a segment farther away across the wall is another wall");
  fields.real("window_m", window_m, {2, 500}, "walls not seen for this long a path are left to loop closing");
  fields.real("unconfirmed_m", unconfirmed_m, {0, 500},
              "a wall seen only once is forgotten after this long a path");
  fields.real("keyframe_m", keyframe_m, {0.02, 5}, "a scan is learned after this long a path");
  fields.angle("keyframe_deg", keyframe_rad, {1, 90}, "or after this much turning");
  fields.real("lost_share", lost_share, {0, 1},
              "with less of the seen length fitting the walls, the pose is searched for");
  fields.real("relocation_reach_m", relocation_reach_m, {0.1, 10}, "search radius around the predicted pose");
}

Pose2 relative_pose(const Keyframe& from, const Keyframe& to, double odometry_factor) {
  const Pose2 tracked = between(from.T_track_sensor, to.T_track_sensor);
  const Vec2 off_m = to.path.off_m(odometry_factor) - from.path.off_m(odometry_factor);
  const Vec2 turned_m = rotate(-from.T_track_sensor.theta, off_m);
  return {tracked.x + turned_m.x(), tracked.y + turned_m.y(), tracked.theta};
}

ScanTracker::ScanTracker(const TrackerParams& params)
    : params_(params),
      update_{.gate_m = params.same_wall_m},
      aligner_(AlignmentParams{}),
      scale_(params.motion.distance_scale) {}

Pose2 ScanTracker::step(std::span<const SensedSegment> segments, const Pose2& T_last_now, bool orthogonal) {
  const Mat3 covariance = params_.motion.covariance(scale_.true_step(T_last_now));
  return step_by_motion(segments, {T_last_now, covariance}, orthogonal);
}

Pose2 ScanTracker::step_by_motion(std::span<const SensedSegment> segments, const UncertainPose2& T_last_now,
                                  bool orthogonal) {
  if (orthogonal_ && !orthogonal) trust_oblique_walls();
  Mat3 wall_information = Mat3::Zero();
  if (scan_ == 0) {
    const auto frame = dominant_direction(segments);
    T_track_sensor_ = {{0, 0, frame ? -frame->heading_rad : 0}, square(kStartSigma) * Mat3::Identity()};
    if (frame && frame->share > kAxesShare) ++headings_used_;
  } else {
    predict(T_last_now);
    if (orthogonal) correct_heading(segments);
    const Alignment alignment = lay_onto_walls(segments);
    wall_information = alignment.wall_information;
    const bool is_lost =
        alignment.seen_m > kRelocationSeen_m && alignment.fitting_share() < params_.lost_share;
    if (!is_lost) suspected_scans_ = 0;
    relocated_ |= is_lost && relocate(segments);
  }
  if (keyframe_is_due() && suspected_scans_ == 0) learn(segments, wall_information);
  ++scan_;
  return T_track_sensor_.mean;
}

/// Where the walls give little information, as along a corridor with only a door's leaf, the guess is kept.
std::optional<Pose2> ScanTracker::lay_again(std::span<const SensedSegment> segments,
                                            const Pose2& T_track_guess) {
  const auto information_about = [&](double sigma_m, double sigma_rad) {
    return about(T_track_guess, sigma_m, sigma_rad).covariance.inverse().eval();
  };
  const PosePrior prior{T_track_guess, information_about(kGuessReach_m, kGuessReach_rad)};
  const Alignment alignment =
      aligner_.align(segments, walls_, window_, prior, params_.gate_m, kAlignmentIterations);
  if (alignment.seen_m == 0 || alignment.fitting_share() < kLaidAgainShare) return std::nullopt;
  const Mat3 information = alignment.wall_information + information_about(kGuessSigma_m, kGuessSigma_rad);
  const Vec3 off = change_between(T_track_guess, alignment.T_map_sensor);
  return moved_by(T_track_guess, information.inverse() * alignment.wall_information * off);
}

/// Without axes, oblique walls are the best there is.
void ScanTracker::trust_oblique_walls() {
  orthogonal_ = false;
  update_.axis_tolerance_rad = -1;
  aligner_ = PoseAligner(AlignmentParams::without_axes());
}

void ScanTracker::predict(const UncertainPose2& T_last_now) {
  T_track_last_ = T_track_sensor_.mean;
  motion_ = scale_.true_step(T_last_now.mean);
  path_m_ += motion_.position().norm();
  T_track_sensor_ = T_track_sensor_ * UncertainPose2{motion_, T_last_now.covariance};
  scale_.predict(T_track_last_, motion_, T_track_sensor_.covariance);
}

void ScanTracker::correct_heading(std::span<const SensedSegment> segments) {
  Pose2& pose = T_track_sensor_.mean;
  Mat3& covariance = T_track_sensor_.covariance;
  const auto measured = heading_from_walls(segments, pose.theta, std::sqrt(covariance(2, 2)));
  if (!measured) return;
  const Vec3 gain = covariance.col(2) / (covariance(2, 2) + square(measured->sigma_rad));
  const Vec3 correction = gain * wrap_angle(measured->heading_rad - pose.theta);
  const Mat3 prior = covariance;
  pose = moved_by(pose, correction);
  covariance -= gain * covariance.row(2).eval();
  covariance = (0.5 * (covariance + covariance.transpose())).eval();
  scale_.correct(prior, correction, covariance);
  ++headings_used_;
}

Alignment ScanTracker::lay_onto_walls(std::span<const SensedSegment> segments) {
  const auto [alignment, path_to_walls, is_as_counted] = explain_motion(segments);
  if (is_as_counted && alignment.fitting_share() >= params_.lost_share) {
    correct_pose(alignment, path_to_walls);
  } else {
    const Mat3 information = T_track_sensor_.covariance.inverse() + alignment.wall_information;
    T_track_sensor_ = {alignment.T_map_sensor, information.inverse()};
    scale_.forget_pose();
  }
  return alignment;
}

/// Corrects pose and wheel scale: what the walls move the sensor beyond the expected error of their positions
/// is evidence of the scale.
void ScanTracker::correct_pose(const Alignment& alignment, const CountedPath& path_to_walls) {
  auto& [pose, covariance] = T_track_sensor_;
  const Mat3& information = alignment.wall_information;
  const Vec3 pull = (covariance.inverse() + information) * change_between(pose, alignment.T_map_sensor);
  Vec3 expected = Vec3::Zero();
  expected.head<2>() = scale_.refer_to(path_to_walls, covariance);
  const Mat3 prior = covariance;
  covariance = (prior.inverse() + information).inverse();
  const Vec3 correction = covariance * (pull - information * expected);
  scale_.correct(prior, correction, covariance);
  pose = moved_by(pose, expected + correction);
}

/// Counted path to what the latest alignment is fitted to: in each direction, to the walls that constrain it.
/// A wall that the vehicle drives along is excluded: its offset changes little, and mostly by heading errors.
CountedPath ScanTracker::path_to_walls() const {
  const CountedPath to_sensor = scale_.path();
  const Vec2 ahead = rotate(T_track_last_.theta, motion_.position()).stableNormalized();
  Mat2 information = kNoWall_per_m2 * Mat2::Identity();
  CountedPath pull{information * to_sensor.by_factor, information * to_sensor.counted_m};
  for (const WallConstraint& constraint : aligner_.constraints()) {
    const bool lies_across = std::abs(constraint.normal.dot(ahead)) > kAcross;
    const CountedPath& path = lies_across ? paths_[constraint.wall] : to_sensor;
    const Mat2 wall_information = constraint.weight * constraint.normal * constraint.normal.transpose();
    information += wall_information;
    pull.by_factor += wall_information * path.by_factor;
    pull.counted_m += wall_information * path.counted_m;
  }
  const Mat2 covariance = information.inverse();
  return {covariance * pull.by_factor, covariance * pull.counted_m};
}

/// Wheels may spin while the vehicle stands. Where the scan does not fit the odometry, that is tried as well.
ScanTracker::Explanation ScanTracker::explain_motion(std::span<const SensedSegment> segments) {
  const Vec2 counted_m = motion_.position();
  Explanation as_counted = lay_from(segments, counted_m);
  const double fitting_share = as_counted.alignment.fitting_share();
  if (counted_m.norm() < kDoubtful_m || fitting_share >= kDoubtful) return as_counted;
  const Explanation standing = lay_from(segments, Vec2::Zero());
  return standing.alignment.fitting_share() > fitting_share + kClearlyBetter ? standing : as_counted;
}

ScanTracker::Explanation ScanTracker::lay_from(std::span<const SensedSegment> segments,
                                               const Vec2& motion_m) {
  const Vec2 counted = T_track_last_ * motion_.position(), assumed = T_track_last_ * motion_m;
  const Pose2& predicted = T_track_sensor_.mean;
  const PosePrior prior{
      {predicted.x + assumed.x() - counted.x(), predicted.y + assumed.y() - counted.y(), predicted.theta},
      T_track_sensor_.covariance.inverse()};
  const Alignment alignment =
      aligner_.align(segments, walls_, window_, prior, params_.gate_m, kAlignmentIterations);
  return {alignment, path_to_walls(), motion_m == motion_.position()};
}

/// One scan may fit walls at a wrong place, such as one desk further in a row of desks. So several scans in a
/// row, taken along some distance, must agree; meanwhile nothing is learned.
bool ScanTracker::relocate(std::span<const SensedSegment> segments) {
  const auto found = find_pose_near(T_track_sensor_.mean, segments, walls_, window_, path_m_,
                                    params_.relocation_reach_m, aligner_);
  if (!found) suspected_scans_ = 0;
  if (!found || !confirm_suspicion(between(T_track_sensor_.mean, *found))) return false;
  const Vec3 sigma(kRelocatedPoseSigma_m, kRelocatedPoseSigma_m, kRelocatedPoseSigma_rad);
  T_track_sensor_ = {*found, sigma.cwiseAbs2().asDiagonal()};
  scale_.forget_pose();
  return true;
}

/// Counts one more scan that suggests this pose, relative to the believed one.
/// @return whether enough scans in a row agree
bool ScanTracker::confirm_suspicion(const Pose2& T_sensor_found) {
  const Pose2 apart = between(T_sensor_suspected_, T_sensor_found);
  const bool is_same = apart.position().norm() < kAgreeing_m && std::abs(apart.theta) < kAgreeing_rad;
  T_sensor_suspected_ = T_sensor_found;
  suspected_scans_ = is_same ? suspected_scans_ + 1 : 1;
  if (suspected_scans_ == 1) suspected_since_m_ = path_m_;
  if (suspected_scans_ < kAgreeingScans || path_m_ - suspected_since_m_ < kAgreeingPath_m) return false;
  suspected_scans_ = 0;
  return true;
}

bool ScanTracker::keyframe_is_due() const {
  if (keyframes_.empty()) return true;
  const Keyframe& last = keyframes_.back();
  return path_m_ - last.path_m > params_.keyframe_m ||
         std::abs(wrap_angle(T_track_sensor_.mean.theta - last.T_track_sensor.theta)) > params_.keyframe_rad;
}

void ScanTracker::learn(std::span<const SensedSegment> segments, const Mat3& wall_information) {
  keyframes_.push_back({scan_, T_track_sensor_.mean, path_m_, wall_information, relocated_, scale_.path()});
  relocated_ = false;
  for (const SensedSegment& s : segments) {
    absorb(PlacedSegment(s, T_track_sensor_.mean), path_m_, update_, walls_, window_);
  }
  paths_.resize(walls_.size(), scale_.path());
  std::erase_if(window_, [&](int index) {
    const WallEstimate& wall = walls_[static_cast<std::size_t>(index)];
    const double unseen_m = path_m_ - wall.last_seen_m;
    return unseen_m > params_.window_m || (wall.sightings == 1 && unseen_m > params_.unconfirmed_m);
  });
}

}  // namespace aisle
