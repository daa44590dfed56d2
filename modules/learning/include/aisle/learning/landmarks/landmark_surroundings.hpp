#pragma once

#include <deque>
#include <span>
#include <vector>

#include "aisle/learning/landmarks/landmark_learning.hpp"

namespace aisle {

/// A small local map of what a vehicle has seen since it started here: C98 Algorithm 2 begun again at the
/// current pose. What several images show is surer than what one shows, and few of them contain the same
/// noise.
class LandmarkSurroundings {
 public:
  LandmarkSurroundings(const LandmarkLearningParams& params, const VehicleDescription& vehicle);

  /// Forgets everything seen so far.
  void start();
  void predict(const OdometryReading& reading) { localiser_.predict(reading); }
  void add(std::span<const LandmarkSighting> image);

  /// The vehicle's pose relative to where it began.
  const Pose2& T_begin_vehicle() const { return localiser_.pose(); }
  /// The images of the last metres, with their poses.
  struct Look {
    Pose2 T_begin_vehicle;
    std::vector<LandmarkSighting> image;
  };
  const std::deque<Look>& looks() const { return looks_; }
  /// All that was seen often enough, relative to the current pose. Valid until the next call.
  const std::vector<LandmarkSighting>& seen();

 private:
  void keep_look(std::span<const LandmarkSighting> image);

  LandmarkLearningParams params_;
  LandmarkLearner learner_;
  LandmarkLocaliser localiser_;
  std::deque<Look> looks_;
  std::vector<LandmarkSighting> seen_;
};

}  // namespace aisle
