#pragma once
/// Learns landmarks on a run: C98 Algorithm 2 (the first run) and Algorithm 4 (every later one).

#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/learning/landmarks/landmark_localiser.hpp"

namespace aisle {

struct LandmarkLearningParams {
  LandmarkLocaliserParams localiser;
  double merge_m = 0.12;
  double weight_min = 0.15;
  int sightings_min = 3;
  bool adjust = true;
  bool forget = true;

  void describe(FieldList& fields);
};

/// One cycle of a run, as learning needs it.
struct LandmarkCycle {
  double stamp_s = 0;
  OdometryReading odometry;                 ///< since the cycle before
  std::vector<LandmarkSighting> sightings;  ///< of its image, if it has one
  std::vector<SensedSegment> floor_edges;   ///< of the same image, in base_link
};

/// Two landmarks merged at their weighted centroid (C98 eq. (17)), with the covariance of the surer one.
Landmark united(const Landmark& a, const Landmark& b);

/// A map being learned. Each sighting at a known pose becomes a landmark or moves those that it coincides
/// with to their weighted centroid (C98 eq. (16), (17)).
class LandmarkLearner {
 public:
  explicit LandmarkLearner(const LandmarkLearningParams& params, LandmarkMap map = {})
      : params_(params), map_(std::move(map)) {}

  /// Merges the sightings of one image from a pose.
  /// @return for each sighting the index of the landmark that it was merged into
  std::vector<std::size_t> merge(std::span<const LandmarkSighting> sightings, const Pose2& T_map_vehicle);

  /// Excludes a landmark from matching and merging from now on.
  void drop(std::size_t index) { map_.remove(index); }

  const LandmarkMap& map() const { return map_; }

 private:
  LandmarkLearningParams params_;
  LandmarkMap map_;
};

/// Algorithm 4, steps 2 to 4: scales the masses to weights with mean 1, removes landmarks below `weight_min`,
/// and gives the landmark nearest to the start (the primary one) the greatest weight.
void settle_weights(std::vector<Landmark>& landmarks, const Vec2& p_map_start, double weight_min);

/// The result of learning one run.
struct LearnedRun {
  LandmarkMap map;
  std::vector<WallDirection> wall_directions;  ///< in the order in which the run passed them
  std::vector<Pose2> T_map_vehicle;  ///< at the end of every cycle; the first pose is the map's origin
};

/// Algorithm 2: the map of a building from one run. With `adjust`, all poses and landmarks are then adjusted
/// together until sightings and odometry agree best; where the run came back to a place, its landmarks are
/// merged with the earlier ones.
LearnedRun learn_landmarks(std::span<const LandmarkCycle> cycles, const VehicleDescription& vehicle,
                           const LandmarkLearningParams& params);

/// A map after another run through its building.
struct RefinedLandmarks {
  LandmarkMap map;
  std::vector<Pose2> T_map_vehicle;  ///< at the end of every cycle
  double matched_share = 0;          ///< share of the images with sightings that were matched, 0 .. 1
};

/// Algorithm 4. Landmarks that should have been seen on the run and were not lose most of their mass, and are
/// removed in time.
RefinedLandmarks refine_landmarks(const LandmarkMap& map, std::span<const LandmarkCycle> cycles,
                                  const VehicleDescription& vehicle, const UncertainPose2& T_map_start,
                                  const LandmarkLearningParams& params);

}  // namespace aisle
