#pragma once
/// Learning landmarks on a run: C98 Algorithm 2 (the first run) and Algorithm 4 (every later one).

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

/// One cycle of a run, as far as learning looks at it.
struct LandmarkCycle {
  double stamp_s = 0;
  OdometryReading odometry;                 ///< since the cycle before
  std::vector<LandmarkSighting> sightings;  ///< of its image, if it has one
  std::vector<SensedSegment> floor_edges;   ///< the same, in base_link
};

/// Two landmarks as one at their weighted centroid (C98 eq. (17)), with the covariance of the surer one.
Landmark united(const Landmark& a, const Landmark& b);

/// A map being learned. Each sighting whose place is known becomes a landmark, or moves the ones that it lies
/// on to their weighted centroid (C98 eq. (16), (17)).
class LandmarkLearner {
 public:
  explicit LandmarkLearner(const LandmarkLearningParams& params, LandmarkMap map = {})
      : params_(params), map_(std::move(map)) {}

  /// Merges what one image shows from a pose. @return for each sighting the landmark that it went into
  std::vector<std::size_t> merge(std::span<const LandmarkSighting> sightings, const Pose2& T_map_vehicle);

  /// Takes a landmark out of what is matched and merged with from now on.
  void drop(std::size_t index) { map_.remove(index); }

  const LandmarkMap& map() const { return map_; }

 private:
  LandmarkLearningParams params_;
  LandmarkMap map_;
};

/// Algorithm 4, steps 2 to 4: weights with mean 1 by the masses, those below the least weight go, the
/// landmark nearest to the start (the primary one) gets the greatest weight.
void settle_weights(std::vector<Landmark>& landmarks, const Vec2& p_map_start, double weight_min);

/// A run as it was learned.
struct LearnedRun {
  LandmarkMap map;
  std::vector<WallDirection> wall_directions;  ///< in the order in which they were come by
  std::vector<Pose2> T_map_vehicle;            ///< at the end of every cycle; the first is the map's origin
};

/// Algorithm 2: the map of a building from one run. With `adjust`, all poses and landmarks are then moved
/// together until sightings and odometry agree best, and where the run came by a place again its landmarks
/// are laid upon the earlier ones.
LearnedRun learn_landmarks(std::span<const LandmarkCycle> cycles, const VehicleDescription& vehicle,
                           const LandmarkLearningParams& params);

/// A map after another run through its building.
struct RefinedLandmarks {
  LandmarkMap map;
  std::vector<Pose2> T_map_vehicle;  ///< at the end of every cycle
  double matched_share = 0;          ///< of the images with sightings
};

/// Algorithm 4. Landmarks that should have been seen on the run and were not lose most of their mass, and go
/// in time.
RefinedLandmarks refine_landmarks(const LandmarkMap& map, std::span<const LandmarkCycle> cycles,
                                  const VehicleDescription& vehicle, const UncertainPose2& T_map_start,
                                  const LandmarkLearningParams& params);

}  // namespace aisle
