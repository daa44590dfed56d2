#pragma once

#include <deque>
#include <span>
#include <vector>

#include "aisle/learning/landmarks/landmark_learning.hpp"

namespace aisle {

/// A small map of what a vehicle has seen since a moment, around it: C98 Algorithm 2 begun again where the
/// vehicle stands. What several images show is surer than what one shows, and noise is in few of them.
class LandmarkSurroundings {
 public:
  LandmarkSurroundings(const LandmarkLearningParams& params, const VehicleDescription& vehicle);

  /// Nothing that was seen so far counts.
  void start();
  void predict(const OdometryReading& reading) { localiser_.predict(reading); }
  void add(std::span<const LandmarkSighting> image);

  /// Where the vehicle is, from where it began.
  const Pose2& T_begin_vehicle() const { return localiser_.pose(); }
  /// Images as they were taken in, of the last metres of path.
  struct Look {
    Pose2 T_begin_vehicle;
    std::vector<LandmarkSighting> image;
  };
  const std::deque<Look>& looks() const { return looks_; }
  /// All that was seen often enough, from where the vehicle is now. Valid until the next call.
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
