#include "landmarks/landmark_loops.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "aisle/core/square.hpp"
#include "landmarks/point_fit.hpp"

namespace aisle {
namespace {

constexpr double kStep_m = 1;         // of path, from one tried segment to the next
constexpr double kPathSegment_m = 3;  // of path before and after the middle of a segment
constexpr double kOwnPass_m = 12;  // landmarks seen within this path length belong to the segment's own pass
constexpr double kReachMin_m = 0.3;    // search radius ...
constexpr double kReachPer_m = 0.015;  // ... and its growth with each metre of path in between
constexpr double kReachMax_m = 1.5;
constexpr double kLoopTurnMin_rad = 2 * kDegree;
constexpr double kLoopTurnPer_m = 0.08 * kDegree;
constexpr double kLoopTurnMax_rad = 10 * kDegree;
constexpr double kPair_m = 0.15;  // landmarks within this are paired
constexpr std::size_t kPairsMin = 6;
constexpr double kPairedShareMin = 0.5;  // of the segment's landmarks with earlier ones nearby
constexpr double kRivalShareMax = 0.75;
constexpr double kLoopAgreed_m = 0.15;  // two segments in a row must agree this well on the same loop
constexpr double kLoopAgreed_rad = 1.5 * kDegree;

/// Indices of some of a run's landmarks.
using Selection = std::vector<std::size_t>;

struct Fit {
  Pose2 displacement;  ///< moves the segment's landmarks onto the earlier ones, in `map`
  std::vector<PointPair> pairs;
  double paired_share = 0;
};

class LoopFinder {
 public:
  LoopFinder(std::span<const RunLandmark> landmarks, std::span<const Pose2> T_map_vehicle,
             const LandmarkLocaliserParams& params)
      : landmarks_(landmarks), T_map_vehicle_(T_map_vehicle), mwght_(params.mwght) {
    for (std::size_t i = 0; i < T_map_vehicle.size(); ++i) {
      const double step_m =
          i == 0 ? 0 : (T_map_vehicle[i].position() - T_map_vehicle[i - 1].position()).norm();
      travelled_m_.push_back(i == 0 ? 0 : travelled_m_.back() + step_m);
    }
  }

  std::vector<LandmarkLoop> find() {
    std::vector<LandmarkLoop> loops;
    std::vector<LandmarkLoop> before, now;
    double next_m = 0;
    for (std::size_t cycle = 0; cycle < travelled_m_.size(); ++cycle) {
      if (travelled_m_[cycle] < next_m) continue;
      next_m = travelled_m_[cycle] + kStep_m;
      now.clear();
      try_path_segment(cycle, now);
      for (const LandmarkLoop& loop : now) {
        if (std::any_of(before.begin(), before.end(),
                        [&](const LandmarkLoop& other) { return agree(loop, other); }))
          loops.push_back(loop);
      }
      std::swap(before, now);
    }
    return loops;
  }

 private:
  void try_path_segment(std::size_t cycle, std::vector<LandmarkLoop>& loops) {
    const Selection fresh = path_segment(cycle);
    if (fresh.size() < kPairsMin) return;
    for (const Selection& pass : earlier_passes(cycle, fresh)) {
      if (pass.size() < kPairsMin) continue;
      if (const auto fit = fit_onto(cycle, fresh, pass)) loops.push_back(loop_of(cycle, pass, *fit));
    }
  }

  Selection path_segment(std::size_t cycle) const {
    Selection chosen;
    for (std::size_t i = 0; i < landmarks_.size(); ++i) {
      if (travelled_m_[landmarks_[i].last_cycle] > travelled_m_[cycle] - kPathSegment_m &&
          travelled_m_[landmarks_[i].first_cycle] < travelled_m_[cycle] + kPathSegment_m)
        chosen.push_back(i);
    }
    return chosen;
  }

  double reach_m(double between_m) const {
    return std::min(kReachMin_m + kReachPer_m * between_m, kReachMax_m);
  }

  /// Landmarks near the segment's that were seen well before it, grouped by pass.
  std::vector<Selection> earlier_passes(std::size_t cycle, const Selection& fresh) const {
    Vec2 low = landmarks_[fresh.front()].landmark.p_map, high = low;
    for (const std::size_t i : fresh) {
      low = low.cwiseMin(landmarks_[i].landmark.p_map);
      high = high.cwiseMax(landmarks_[i].landmark.p_map);
    }
    Selection old;
    for (std::size_t i = 0; i < landmarks_.size(); ++i) {
      const double between_m = travelled_m_[cycle] - travelled_m_[landmarks_[i].last_cycle];
      const Vec2 margin = Vec2::Constant(reach_m(between_m)), p = landmarks_[i].landmark.p_map;
      if (between_m >= kOwnPass_m && (p - low + margin).minCoeff() >= 0 &&
          (high + margin - p).minCoeff() >= 0)
        old.push_back(i);
    }
    std::sort(old.begin(), old.end(), [&](std::size_t a, std::size_t b) { return seen_m(a) < seen_m(b); });
    std::vector<Selection> passes;
    for (const std::size_t i : old) {
      if (passes.empty() || seen_m(i) - seen_m(passes.back().back()) > kPathSegment_m) passes.emplace_back();
      passes.back().push_back(i);
    }
    return passes;
  }

  /// The path length at the middle of a landmark's sightings.
  double seen_m(std::size_t landmark) const {
    return (travelled_m_[landmarks_[landmark].first_cycle] + travelled_m_[landmarks_[landmark].last_cycle]) /
           2;
  }

  std::optional<Fit> fit_onto(std::size_t cycle, const Selection& fresh, const Selection& pass) {
    const Pose2& T_map_here = T_map_vehicle_[cycle];
    const auto seen_from_here = [&](const Selection& chosen) {
      std::vector<WeightedPoint> points;
      for (const std::size_t i : chosen)
        points.push_back({T_map_here.inverse() * landmarks_[i].landmark.p_map, 1});
      return points;
    };
    const double between_m = travelled_m_[cycle] - seen_m(pass.back());
    const double half_m = reach_m(between_m);
    const auto match = mwght_.match(
        seen_from_here(pass), seen_from_here(fresh),
        {.x_half_m = half_m,
         .y_half_m = half_m,
         .turn_half_rad = std::min(kLoopTurnMin_rad + kLoopTurnPer_m * between_m, kLoopTurnMax_rad)});
    if (!match) return std::nullopt;
    const auto in_map = [&](const Pose2& displacement) {
      return T_map_here * displacement * T_map_here.inverse();
    };
    const Fit best = judged(in_map(match->best.displacement), fresh, pass);
    if (best.pairs.size() < kPairsMin || best.paired_share < kPairedShareMin) return std::nullopt;
    if (match->runner_up) {
      const Fit rival = judged(in_map(match->runner_up->displacement), fresh, pass);
      const bool is_elsewhere = !agree(best.displacement, rival.displacement, T_map_here.position());
      if (is_elsewhere && count(rival) > kRivalShareMax * count(best)) return std::nullopt;
    }
    return best;
  }

  /// Pairs at a displacement, and the displacement that fits them best.
  Fit judged(const Pose2& displacement, const Selection& fresh, const Selection& pass) const {
    Fit fit{.displacement = displacement};
    for (int round = 0; round < 2; ++round) {
      pair_up(fresh, pass, fit);
      if (fit.pairs.size() < 2) break;
      fit.displacement = fit_points(fit.pairs);
    }
    return fit;
  }

  void pair_up(const Selection& fresh, const Selection& pass, Fit& fit) const {
    fit.pairs.clear();
    std::size_t comparable = 0;
    for (const std::size_t i : fresh) {
      const Vec2 p = fit.displacement * landmarks_[i].landmark.p_map;
      double nearest_m = kPair_m, any_m = 1.0;
      std::optional<std::size_t> nearest;
      for (const std::size_t k : pass) {
        const double off_m = (landmarks_[k].landmark.p_map - p).norm();
        any_m = std::min(any_m, off_m);
        if (landmarks_[k].landmark.brighter_right != landmarks_[i].landmark.brighter_right ||
            off_m >= nearest_m)
          continue;
        nearest_m = off_m;
        nearest = k;
      }
      if (any_m < 1.0) ++comparable;
      if (nearest) fit.pairs.push_back({landmarks_[i].landmark.p_map, landmarks_[*nearest].landmark.p_map});
    }
    fit.paired_share =
        comparable == 0 ? 0 : static_cast<double>(fit.pairs.size()) / static_cast<double>(comparable);
  }

  LandmarkLoop loop_of(std::size_t cycle, const Selection& pass, const Fit& fit) const {
    const RunLandmark& middle = landmarks_[pass[pass.size() / 2]];
    const std::size_t earlier = (middle.first_cycle + middle.last_cycle) / 2;
    return {earlier, cycle, between(T_map_vehicle_[earlier], fit.displacement * T_map_vehicle_[cycle])};
  }

  /// Whether two loops correct the run in the same way.
  bool agree(const LandmarkLoop& a, const LandmarkLoop& b) const {
    const auto correction = [&](const LandmarkLoop& loop) {
      return T_map_vehicle_[loop.earlier_cycle] * loop.T_earlier_later *
             T_map_vehicle_[loop.later_cycle].inverse();
    };
    return agree(correction(a), correction(b), T_map_vehicle_[a.later_cycle].position());
  }

  static bool agree(const Pose2& a, const Pose2& b, const Vec2& p_map) {
    return (a * p_map - b * p_map).norm() < kLoopAgreed_m &&
           std::abs(wrap_angle(a.theta - b.theta)) < kLoopAgreed_rad;
  }

  static double count(const Fit& fit) { return static_cast<double>(fit.pairs.size()); }

  std::span<const RunLandmark> landmarks_;
  std::span<const Pose2> T_map_vehicle_;
  Mwght mwght_;
  std::vector<double> travelled_m_;  ///< to each cycle
};

}  // namespace

std::vector<LandmarkLoop> find_landmark_loops(std::span<const RunLandmark> landmarks,
                                              std::span<const Pose2> T_map_vehicle,
                                              const LandmarkLocaliserParams& params) {
  return LoopFinder(landmarks, T_map_vehicle, params).find();
}

}  // namespace aisle
