#include <algorithm>

#include "aisle/learning/landmarks/landmark_learning.hpp"
#include "landmarks/landmark_adjustment.hpp"
#include "landmarks/landmark_view.hpp"

namespace aisle {
namespace {

constexpr int kExpectedMin = 15;        // images needed to decide whether a landmark is still there
constexpr double kSeenShareMin = 0.05;  // seen in a smaller share of them, it is gone
constexpr double kGoneShare = 0.3;      // share of a vanished landmark's mass that remains after a run
constexpr int kAdjustments = 2;         // of a later run

/// How often a landmark should have been seen on a run, and how often it was.
struct Visibility {
  int expected = 0;
  int seen = 0;

  bool is_gone() const { return expected >= kExpectedMin && seen < kSeenShareMin * expected; }
};

void count_visibility(const LandmarkMap& map, std::span<const LandmarkSighting> sightings,
                      const LandmarkLocaliser& localiser, std::vector<Visibility>& visibility) {
  const LandmarkView view(sightings);
  std::vector<int> near;
  map.within(localiser.pose().position(), view.far_m(), near);
  for (const int i : near) {
    const auto index = static_cast<std::size_t>(i);
    if (view.expects(map[index], localiser.pose())) ++visibility[index].expected;
  }
  for (const LandmarkPair& pair : localiser.pairs()) ++visibility[pair.landmark].seen;
}

/// The landmarks before and after a run.
struct KnownLandmarks {
  std::vector<Landmark> before;  ///< as in the map, without those that vanished on the run
  std::vector<Landmark> after;   ///< the same, in the same order, then the new ones
};

/// Processes a run through a known building image by image: match, correct, merge into the map.
class LaterRun {
 public:
  LaterRun(const LandmarkMap& map, const VehicleDescription& vehicle, const UncertainPose2& T_map_start,
           const LandmarkLearningParams& params)
      : params_(params),
        vehicle_(vehicle),
        known_(map),
        learner_(params, map),
        localiser_(params.localiser, vehicle, T_map_start),
        visibility_(map.size()) {}

  void add(const LandmarkCycle& cycle) {
    if (!T_map_vehicle_.empty()) localiser_.predict(cycle.odometry);
    const LandmarkMatch match = localiser_.correct(known_, cycle.sightings, cycle.floor_edges);
    T_map_vehicle_.push_back(localiser_.pose());
    if (match != LandmarkMatch::kNothing) ++seen_images_;
    if (match != LandmarkMatch::kMatched) return;
    ++matched_images_;
    count_visibility(known_, cycle.sightings, localiser_, visibility_);
    learner_.merge(cycle.sightings, localiser_.pose());
  }

  KnownLandmarks landmarks() const {
    KnownLandmarks landmarks;
    for (std::size_t i = 0; i < learner_.map().size(); ++i) {
      Landmark landmark = learner_.map()[i];
      if (landmark.weight == 0) continue;
      if (i < known_.size()) {
        if (params_.forget && visibility_[i].is_gone()) landmark.mass *= kGoneShare;
        if (visibility_[i].seen > 0) ++landmark.passes;
        landmarks.before.push_back(known_[i]);
      }
      landmarks.after.push_back(landmark);
    }
    return landmarks;
  }

  /// Adjusts poses and landmarks together; known ones hold the map in place.
  /// @return as adjust_landmarks()
  std::vector<Mat2> adjust(std::span<const LandmarkCycle> cycles, KnownLandmarks& landmarks) {
    std::vector<RunLandmark> all_the_time;
    for (const Landmark& landmark : landmarks.after) all_the_time.push_back({landmark, 0, cycles.size()});
    const auto observations =
        observe_landmarks(cycles, vehicle_, params_.localiser, T_map_vehicle_, all_the_time);
    return adjust_landmarks({cycles, observations, {}, {}, landmarks.before}, vehicle_, T_map_vehicle_,
                            landmarks.after);
  }

  const std::vector<Pose2>& T_map_vehicle() const { return T_map_vehicle_; }

  /// Share of the images with sightings.
  double matched_share() const {
    return static_cast<double>(matched_images_) / static_cast<double>(std::max(seen_images_, 1));
  }

 private:
  LandmarkLearningParams params_;
  const VehicleDescription& vehicle_;
  const LandmarkMap& known_;
  LandmarkLearner learner_;
  LandmarkLocaliser localiser_;
  std::vector<Visibility> visibility_;  ///< of the known landmarks
  std::vector<Pose2> T_map_vehicle_;
  int seen_images_ = 0, matched_images_ = 0;
};

}  // namespace

RefinedLandmarks refine_landmarks(const LandmarkMap& map, std::span<const LandmarkCycle> cycles,
                                  const VehicleDescription& vehicle, const UncertainPose2& T_map_start,
                                  const LandmarkLearningParams& params) {
  LaterRun run(map, vehicle, T_map_start, params);
  for (const LandmarkCycle& cycle : cycles) run.add(cycle);
  KnownLandmarks landmarks = run.landmarks();
  std::vector<Mat2> spread(landmarks.after.size(), Mat2::Zero());
  for (int round = 0; params.adjust && round < kAdjustments; ++round) spread = run.adjust(cycles, landmarks);
  for (std::size_t i = 0; i < spread.size(); ++i) landmarks.after[i].covariance += spread[i];
  settle_weights(landmarks.after, T_map_start.mean.position(), params.weight_min);
  RefinedLandmarks refined{
      .map = {}, .T_map_vehicle = run.T_map_vehicle(), .matched_share = run.matched_share()};
  refined.map.assign(std::move(landmarks.after));
  return refined;
}

}  // namespace aisle
