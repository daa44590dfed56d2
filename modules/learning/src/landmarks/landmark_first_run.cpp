#include <algorithm>
#include <cmath>

#include "aisle/learning/landmarks/landmark_learning.hpp"
#include "aisle/learning/walls/wall_compass.hpp"
#include "landmarks/landmark_adjustment.hpp"
#include "landmarks/landmark_loops.hpp"
#include "landmarks/run_landmarks.hpp"

namespace aisle {

namespace {

constexpr double kOriginSigma = 1e-4;  // the first pose is the map's origin: exact [m, rad]
constexpr double kRemembered_m =
    10;  // of path: landmarks last seen before count as another pass if seen again

constexpr int kFinalAdjustments = 2;

/// Processes the run image by image: match, correct, merge. After a long loop the pose has drifted against
/// the landmarks of the beginning, so only landmarks seen on the last metres are matched and merged.
class FirstRun {
 public:
  FirstRun(const VehicleDescription& vehicle, const LandmarkLearningParams& params)
      : params_(params),
        learner_(params),
        localiser_(params.localiser, vehicle, about({}, kOriginSigma, kOriginSigma)) {}

  void add(const LandmarkCycle& cycle) {
    if (!T_map_vehicle_.empty()) {
      const Pose2 before = localiser_.pose();
      localiser_.predict(cycle.odometry);
      const Pose2 moved = between(before, localiser_.pose());
      travelled_m_ += moved.position().norm();
      compass_.move(moved.position().norm(), moved.theta);
    }
    drop_old_ones();
    if (params_.localiser.heading_by_walls) use_walls(cycle.floor_edges);
    if (localiser_.correct(learner_.map(), cycle.sightings) != LandmarkMatch::kAmbiguous) {
      for (const std::size_t index : learner_.merge(cycle.sightings, localiser_.pose())) note_seen(index);
    }
    T_map_vehicle_.push_back(localiser_.pose());
  }

  const std::vector<Pose2>& T_map_vehicle() const { return T_map_vehicle_; }
  const std::vector<WallObservation>& walls() const { return walls_; }

  std::vector<RunLandmark> landmarks(int sightings_min) {
    std::vector<RunLandmark> often;
    for (const Glimpse& glimpse : recent_) keep(glimpse);
    recent_.clear();
    std::copy_if(kept_.begin(), kept_.end(), std::back_inserter(often),
                 [&](const RunLandmark& kept) { return kept.landmark.sightings >= sightings_min; });
    return often;
  }

 private:
  /// A landmark seen on the last metres.
  struct Glimpse {
    std::size_t index = 0;  ///< in the learner's map
    std::size_t first_cycle = 0, last_cycle = 0;
    double last_m = 0;
  };

  /// The surer of heading and wall direction corrects the other.
  void use_walls(std::span<const SensedSegment> floor_edges) {
    const double heading_sigma_rad = std::sqrt(localiser_.covariance()(2, 2));
    compass_.look(floor_edges, localiser_.pose().theta, heading_sigma_rad);
    if (const auto heading = compass_.heading()) {
      localiser_.correct_heading(*heading);
    } else {
      compass_.learn(localiser_.pose().theta, heading_sigma_rad);
    }
    if (compass_.against_walls())
      walls_.push_back({T_map_vehicle_.size(), compass_.starts() - 1, *compass_.against_walls()});
  }

  void note_seen(std::size_t index) {
    const std::size_t cycle = T_map_vehicle_.size();
    const auto known = std::find_if(recent_.begin(), recent_.end(),
                                    [&](const Glimpse& glimpse) { return glimpse.index == index; });
    if (known == recent_.end()) {
      recent_.push_back({index, cycle, cycle, travelled_m_});
    } else {
      known->last_cycle = cycle;
      known->last_m = travelled_m_;
    }
  }

  void drop_old_ones() {
    std::erase_if(recent_, [&](const Glimpse& glimpse) {
      const bool is_old = travelled_m_ - glimpse.last_m > kRemembered_m;
      if (is_old) {
        keep(glimpse);
        learner_.drop(glimpse.index);
      }
      return is_old;
    });
  }

  /// Keeps a landmark unless it was merged into another.
  void keep(const Glimpse& glimpse) {
    const Landmark& landmark = learner_.map()[glimpse.index];
    if (landmark.weight > 0) kept_.push_back({landmark, glimpse.first_cycle, glimpse.last_cycle});
  }

  LandmarkLearningParams params_;
  LandmarkLearner learner_;
  LandmarkLocaliser localiser_;
  WallCompass compass_;
  std::vector<Pose2> T_map_vehicle_;
  std::vector<WallObservation> walls_;
  std::vector<Glimpse> recent_;
  std::vector<RunLandmark> kept_;
  double travelled_m_ = 0;
};

/// Merges coinciding landmarks; the result covers all their cycles.
std::vector<RunLandmark> without_duplicates(std::span<const RunLandmark> landmarks, double merge_m) {
  std::vector<RunLandmark> single;
  LandmarkMap map;
  std::vector<int> near;
  for (const RunLandmark& next : landmarks) {
    map.within(next.landmark.p_map, merge_m, near);
    const auto same = std::find_if(near.begin(), near.end(), [&](int i) {
      return map[static_cast<std::size_t>(i)].brighter_right == next.landmark.brighter_right;
    });
    if (same == near.end()) {
      map.add(next.landmark);
      single.push_back(next);
      continue;
    }
    const auto index = static_cast<std::size_t>(*same);
    RunLandmark& one = single[index];
    one = {united(one.landmark, next.landmark), std::min(one.first_cycle, next.first_cycle),
           std::max(one.last_cycle, next.last_cycle)};
    map.replace(index, one.landmark);
  }
  return single;
}

/// Adjusts a run and its landmarks, closes its loops, and adjusts them again.
class RunAdjuster {
 public:
  RunAdjuster(std::span<const LandmarkCycle> cycles, std::span<const WallObservation> walls,
              const VehicleDescription& vehicle, const LandmarkLearningParams& params)
      : cycles_(cycles), walls_(walls), vehicle_(vehicle), params_(params) {}

  void run(std::vector<Pose2>& T_map_vehicle, std::vector<RunLandmark>& landmarks) const {
    adjust(T_map_vehicle, landmarks, {});
    const auto loops = find_landmark_loops(landmarks, T_map_vehicle, params_.localiser);
    if (!loops.empty()) adjust(T_map_vehicle, landmarks, loops);
    landmarks = without_duplicates(landmarks, params_.merge_m);
    std::vector<Mat2> spread;
    for (int round = 0; round < kFinalAdjustments; ++round) spread = adjust(T_map_vehicle, landmarks, {});
    for (std::size_t i = 0; i < landmarks.size(); ++i) landmarks[i].landmark.covariance += spread[i];
  }

 private:
  std::vector<Mat2> adjust(std::vector<Pose2>& T_map_vehicle, std::vector<RunLandmark>& landmarks,
                           std::span<const LandmarkLoop> loops) const {
    std::vector<Landmark> moved;
    moved.reserve(landmarks.size());
    for (const RunLandmark& landmark : landmarks) moved.push_back(landmark.landmark);
    const auto observations =
        observe_landmarks(cycles_, vehicle_, params_.localiser, T_map_vehicle, landmarks);
    std::vector<Mat2> spread =
        adjust_landmarks({cycles_, observations, loops, walls_}, vehicle_, T_map_vehicle, moved);
    for (std::size_t i = 0; i < moved.size(); ++i) landmarks[i].landmark = moved[i];
    return spread;
  }

  std::span<const LandmarkCycle> cycles_;
  std::span<const WallObservation> walls_;
  const VehicleDescription& vehicle_;
  const LandmarkLearningParams& params_;
};

}  // namespace

LearnedRun learn_landmarks(std::span<const LandmarkCycle> cycles, const VehicleDescription& vehicle,
                           const LandmarkLearningParams& params) {
  if (cycles.empty()) return {};
  FirstRun first(vehicle, params);
  for (const LandmarkCycle& cycle : cycles) first.add(cycle);
  LearnedRun learned_run{.map = {}, .wall_directions = {}, .T_map_vehicle = first.T_map_vehicle()};
  std::vector<RunLandmark> found = first.landmarks(params.sightings_min);
  if (params.adjust)
    RunAdjuster(cycles, first.walls(), vehicle, params).run(learned_run.T_map_vehicle, found);
  std::vector<Landmark> landmarks;
  landmarks.reserve(found.size());
  for (const RunLandmark& landmark : found) landmarks.push_back(landmark.landmark);
  settle_weights(landmarks, learned_run.T_map_vehicle.front().position(), params.weight_min);
  learned_run.map.assign(std::move(landmarks));
  learned_run.wall_directions = wall_directions(first.walls(), learned_run.T_map_vehicle);
  return learned_run;
}

}  // namespace aisle
