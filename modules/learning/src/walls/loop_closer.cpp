#include "walls/loop_closer.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr std::size_t kTriesMax = 8;
constexpr std::size_t kNeighbours = 3;  // neighbouring submaps show much the same
constexpr double kSeenAround_m = 4;     // walls within this of a keyframe are well known
constexpr double kNeighbourhood_m = 4;  // two submaps overlap if their anchors are within this
constexpr double kOwnPath_m = 8;        // walls seen within this path length are not old
constexpr double kObservable_m = 1;     // matched wall length needed to fix an axis ...
constexpr double kSmallReach_m = 0.8;   // ... unless the search radius was this small
constexpr double kLoopEdge_m = 0.5;     // length of a loop edge in the graph's distances
constexpr double kWallShare = 0.1;      // share of the walls' information that counts against odometry
constexpr double kRelocatedSubmapSigma_m = 0.2;
constexpr double kStepFloor_m2 = 1e-5;
constexpr double kOrthogonalSigma_rad = 0.5 * kDegree;
constexpr double kFreeHeadingSigma_rad = 1 * kDegree;
constexpr double kFitShare = 0.3;  // wall residuals at one place are not independent
constexpr double kFitFloor_m = 0.02;
constexpr double kFitFloor_rad = 0.3 * kDegree;

Mat3 rotation3(double angle_rad) {
  Mat3 turned = Mat3::Identity();
  turned.topLeftCorner<2, 2>() = rotation(angle_rad);
  return turned;
}

/// Information of a fit in the frame of the older submap, limited to the floor.
Mat3 constraint_information(const Mat3& fit_information, double older_heading_rad) {
  const Mat3 rotation = rotation3(older_heading_rad);
  Mat3 covariance =
      (kFitShare * rotation.transpose() * fit_information * rotation + 0.01 * Mat3::Identity()).inverse();
  covariance.diagonal() += Vec3(square(kFitFloor_m), square(kFitFloor_m), square(kFitFloor_rad));
  return covariance.inverse();
}

}  // namespace

void LoopParams::describe(FieldList& fields) {
  fields.real("submap_m", submap_m, {1, 50}, "path length of one submap");
  fields.real("path_apart_m", path_apart_m, {1, 1000}, "two submaps nearer along the path are no loop");
  fields.real("reach_floor_m", reach_floor_m, {0.05, 10}, "least search radius around the expected place");
  fields.real("reach_per_m", reach_per_m, {0, 1}, "added search radius per metre of path between the two");
  fields.real("reach_max_m", reach_max_m, {0.1, 50}, "greatest search radius");
  fields.real("score_min", score_min, {0, 1}, "share of the wall length that must lie on old walls");
  fields.real("rival_share_max", rival_share_max, {0, 1},
              "a different place that fits better than this share makes it ambiguous");
  fields.real("sure_reach_m", sure_reach_m, {0, 50}, "a larger search needs a second submap that agrees");
  fields.real("agree_m", agree_m, {0.01, 5}, "how closely the two must agree");
  fields.real("cauchy_sigmas", cauchy_sigmas, {0.5, 100}, "a loop closure farther off counts less and less");
}

bool LoopCloser::add(Submap submap, std::span<const Keyframe> keyframes, bool orthogonal) {
  submaps_.push_back(std::move(submap));
  loops_of_submap_.emplace_back();
  const std::size_t newest = submaps_.size() - 1;
  graph_.add_node(newest == 0 ? submaps_.front().T_track_anchor
                              : graph_.pose(newest - 1) * relative_pose_to(newest, keyframes));
  if (orthogonal) {
    graph_.add_heading_prior(newest, submaps_.back().T_track_anchor.theta, kOrthogonalSigma_rad);
  }
  if (submaps_.size() < 2) return false;
  connect_to_previous(keyframes, orthogonal);

  if (!close_loops(newest, keyframes)) return false;
  graph_.optimise();
  return true;
}

void LoopCloser::finish(std::span<const Keyframe> keyframes) {
  for (std::size_t i = 0; i < submaps_.size(); ++i) close_loops(i, keyframes);
  if (submaps_.size() > 1) graph_.optimise(30);
}

/// Compares a submap with older ones nearby. Returns true if any shows the same place.
bool LoopCloser::close_loops(std::size_t submap, std::span<const Keyframe> keyframes) {
  bool any = false;
  std::size_t tries = 0;
  for (const Candidate& candidate : candidates(submap)) {
    if (is_closed(submap, candidate.submap)) continue;
    if (++tries > kTriesMax) break;
    any |= try_to_close(submap, candidate, keyframes);
  }
  return any;
}

/// Whether a loop between the two, or between the first and a neighbour of the second, is already closed.
bool LoopCloser::is_closed(std::size_t submap, std::size_t other) const {
  const std::vector<std::size_t>& loops = loops_of_submap_[submap];
  return std::any_of(loops.begin(), loops.end(), [&](std::size_t closed) {
    return std::max(closed, other) - std::min(closed, other) < kNeighbours;
  });
}

void LoopCloser::restate_odometry(double odometry_factor, std::span<const Keyframe> keyframes) {
  if (odometry_factor == odometry_factor_) return;
  odometry_factor_ = odometry_factor;
  for (std::size_t i = 1; i < submaps_.size(); ++i)
    graph_.set_odometry(i - 1, relative_pose_to(i, keyframes));
  if (submaps_.size() > 1) graph_.optimise();
}

/// The relative pose from the previous submap.
Pose2 LoopCloser::relative_pose_to(std::size_t submap, std::span<const Keyframe> keyframes) const {
  return relative_pose(keyframes[submaps_[submap - 1].anchor_keyframe],
                       keyframes[submaps_[submap].anchor_keyframe], odometry_factor_);
}

/// Adds the constraint between two successive anchors: each step is measured by odometry and, perpendicular
/// to walls, by these.
void LoopCloser::connect_to_previous(std::span<const Keyframe> keyframes, bool orthogonal) {
  const std::size_t newer = submaps_.size() - 1;
  const Submap& from = submaps_[newer - 1];
  const Submap& to = submaps_[newer];
  Mat2 covariance = Mat2::Zero();
  for (std::size_t k = from.anchor_keyframe + 1; k <= to.anchor_keyframe; ++k) {
    const Keyframe& a = keyframes[k - 1];
    const Keyframe& b = keyframes[k];
    const Mat3 rotation = rotation3(a.T_track_sensor.theta);
    const Mat3 step =
        rotation * motion_.covariance(between(a.T_track_sensor, b.T_track_sensor)) * rotation.transpose();
    const Mat2 known =
        step.topLeftCorner<2, 2>().inverse() + kWallShare * b.wall_information.topLeftCorner<2, 2>();
    covariance += known.inverse();
    if (b.relocated) covariance += square(kRelocatedSubmapSigma_m) * Mat2::Identity();
  }
  const Mat3 rotation = rotation3(-from.T_track_anchor.theta);
  const Mat2 local =
      rotation.topLeftCorner<2, 2>() * covariance * rotation.topLeftCorner<2, 2>().transpose() +
      kStepFloor_m2 * Mat2::Identity();
  PoseConstraint constraint{newer - 1, newer, relative_pose_to(newer, keyframes), Mat3::Zero()};
  constraint.information.topLeftCorner<2, 2>() = local.inverse();
  constraint.information(2, 2) = 1 / square(orthogonal ? kOrthogonalSigma_rad : kFreeHeadingSigma_rad);
  graph_.add_odometry(constraint);
}

/// Lengths of the shortest paths through the graph from a submap: Dijkstra over steps and closed loops.
std::vector<double> LoopCloser::distances_from(std::size_t submap) const {
  std::vector<double> distance(submaps_.size(), 1e18);
  using Reached = std::pair<double, std::size_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  const auto reach = [&](std::size_t reached, double metres) {
    if (metres >= distance[reached]) return;
    distance[reached] = metres;
    queue.push({metres, reached});
  };
  reach(submap, 0);
  while (!queue.empty()) {
    const auto [metres, at] = queue.top();
    queue.pop();
    if (metres > distance[at]) continue;
    if (at > 0) reach(at - 1, metres + submaps_[at].path_m - submaps_[at - 1].path_m);
    if (at + 1 < submaps_.size()) reach(at + 1, metres + submaps_[at + 1].path_m - submaps_[at].path_m);
    for (const std::size_t other : loops_of_submap_[at]) reach(other, metres + kLoopEdge_m);
  }
  return distance;
}

std::vector<LoopCloser::Candidate> LoopCloser::candidates(std::size_t submap) const {
  const std::vector<double> distances = distances_from(submap);
  std::vector<std::pair<double, Candidate>> found;
  for (std::size_t i = 0; i < submap; ++i) {
    if (submaps_[submap].path_m - submaps_[i].path_m < params_.path_apart_m) continue;
    const double reach_m =
        std::min(params_.reach_max_m, params_.reach_floor_m + params_.reach_per_m * distances[i]);
    const double apart_m = (graph_.pose(i).position() - graph_.pose(submap).position()).norm();
    if (apart_m < kNeighbourhood_m + reach_m) found.push_back({apart_m, {i, reach_m}});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Candidate> candidates;
  candidates.reserve(found.size());
  for (const auto& [apart_m, candidate] : found) candidates.push_back(candidate);
  return candidates;
}

bool LoopCloser::try_to_close(std::size_t submap, const Candidate& candidate,
                              std::span<const Keyframe> keyframes) {
  const std::size_t first = candidate.submap > 0 ? candidate.submap - 1 : 0;
  std::vector<WallEstimate> old_walls;
  KnownArea known;
  for (std::size_t i = first; i <= candidate.submap + 1 && i + 2 <= submap; ++i) {
    const Submap& old = submaps_[i];
    if (submaps_[submap].path_m - old.path_m < kOwnPath_m) continue;
    const Pose2 T_map_track = graph_.pose(i) * old.T_track_anchor.inverse();
    place_walls(old, graph_.pose(i), old_walls);
    for (std::size_t k = old.first_keyframe; k <= old.last_keyframe; ++k) {
      known.include(T_map_track * keyframes[k].T_track_sensor.position(), kSeenAround_m);
    }
  }
  if (old_walls.empty()) return false;
  const WallPattern old(std::move(old_walls));

  const Pose2 expected = graph_.pose(submap);
  std::vector<WallEstimate> fresh;
  place_walls(submaps_[submap], expected, fresh);
  SubmapFit fit;
  double turn = 0;
  for (const double tried_turn : likely_turns(fresh, old.walls())) {
    fresh.clear();
    place_walls(submaps_[submap], {expected.x, expected.y, wrap_angle(expected.theta + tried_turn)}, fresh);
    const SubmapFit tried = fit_submap(fresh, old, known, candidate.reach_m);
    if (tried.score <= fit.score) continue;
    fit = tried;
    turn = tried_turn;
  }
  if (fit.score < params_.score_min || fit.rival_score > params_.rival_share_max * fit.score) return false;
  const bool fixes_both_axes = fit.matched_m[0] > kObservable_m && fit.matched_m[1] > kObservable_m;
  if (!fixes_both_axes && candidate.reach_m > kSmallReach_m) return false;

  const Pose2 displaced{expected.x + fit.displacement_m.x(), expected.y + fit.displacement_m.y(),
                        wrap_angle(expected.theta + turn)};
  const RefinedFit refined = refine_fit(submaps_[submap], displaced, old, known);
  const Pose2 T_map_older = graph_.pose(candidate.submap);
  const Pending found{{candidate.submap, submap, between(T_map_older, refined.T_map_anchor),
                       constraint_information(refined.information, T_map_older.theta)},
                      refined.T_map_anchor.position() - expected.position()};
  if (candidate.reach_m >= params_.sure_reach_m && !confirm(found)) return false;
  take(found.constraint);
  return true;
}

/// Looks among the last three submaps for a fit with the same correction. If there is one, both are closed;
/// otherwise this one is remembered.
bool LoopCloser::confirm(const Pending& found) {
  bool confirmed = false;
  for (Pending& other : pending_) {
    const bool recent =
        other.constraint.to < found.constraint.to && other.constraint.to + 3 >= found.constraint.to;
    if (!recent || (other.correction_m - found.correction_m).norm() >= params_.agree_m) continue;
    confirmed = true;
    if (!other.taken && !is_closed(other.constraint.to, other.constraint.from)) take(other.constraint);
    other.taken = true;
  }
  pending_.push_back(found);
  pending_.back().taken = confirmed;
  return confirmed;
}

void LoopCloser::take(const PoseConstraint& constraint) {
  graph_.add_loop_closure(constraint, params_.cauchy_sigmas);
  loops_of_submap_[constraint.from].push_back(constraint.to);
  loops_of_submap_[constraint.to].push_back(constraint.from);
  closures_.push_back({constraint.from, constraint.to});
}

}  // namespace aisle
