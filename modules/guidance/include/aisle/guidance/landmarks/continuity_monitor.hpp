#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "aisle/guidance/landmarks/motion_since.hpp"
#include "aisle/vision/lines/landmark_sightings.hpp"

namespace aisle {

/// Detects kidnapping where one of the two places shows hardly any lines, so that no two scenes can be
/// compared: lines that two images in a row showed and that must stay in view are gone at once, and stay away
/// (near ones, or all of them); or there are lines that would have been in view before.
class ContinuityMonitor {
 public:
  /// @param nearest_m  nearest floor ahead that the camera sees: what comes nearer leaves the image below
  explicit ContinuityMonitor(double nearest_m) : nearest_m_(nearest_m) {}

  /// The vehicle has moved since the last call, by its odometry.
  void move(const Pose2& T_before_now);

  /// Takes in an image, even if it shows nothing.
  /// @param is_known_here  it shows what is known to be here
  /// @return whether it is the last of several in a row that do not continue what was seen before
  bool look(std::span<const LandmarkSighting> image, bool is_known_here = false);

 private:
  bool can_tell() const;
  bool is_clear_of_lower_edge(const Vec2& p_vehicle) const;
  bool lacks_what_must_stay(std::span<const LandmarkSighting> image);
  bool shows_what_was_not_there(std::span<const LandmarkSighting> image);
  void take(std::span<const LandmarkSighting> image);

  double nearest_m_;
  std::vector<LandmarkSighting> scene_;  ///< lines of the last continuous image, in the present vehicle frame
  std::ptrdiff_t steady_ = 0;  ///< number of its lines, sorted first, that the image before showed, too
  double span_rad_ = 0;        ///< greatest bearing in it, to either side, when it was taken
  MotionSince since_;          ///< since it was taken
  bool has_scene_ = false;
  std::vector<LandmarkSighting> latest_;    ///< the previous image
  std::vector<LandmarkSighting> compared_;  ///< lines of one scene that are compared; kept for its memory
  int breaks_ = 0;                          ///< images in a row that do not continue the scene
};

}  // namespace aisle
