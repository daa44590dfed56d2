#pragma once

#include <span>

#include "aisle/maps/landmark_map.hpp"
#include "aisle/vision/lines/landmark_sightings.hpp"

namespace aisle {

/// Whether a landmark was only seen from the opposite side so far. A flat one looks the same from there; a
/// door frame or a corner shows another edge, which may be a landmark of its own.
bool is_known_from_behind(const Landmark& landmark, const Vec2& p_map_vehicle);

/// Whether a landmark was seen from about this side and distance before: from nearer, a line may lie above
/// the image, or be equally bright on both sides.
bool was_seen_from_about(const Landmark& landmark, const Vec2& p_map_vehicle);

/// The part of the surroundings that an image shows: if one landmark was seen, a nearer one between the
/// outermost ones could have been seen, too.
class LandmarkView {
 public:
  explicit LandmarkView(std::span<const LandmarkSighting> sightings);

  double far_m() const { return far_m_; }

  /// Whether a landmark should be seen: it is in the view and was seen from about here before.
  bool expects(const Landmark& landmark, const Pose2& T_map_vehicle) const;

 private:
  double far_m_ = 0;
  double left_rad_, right_rad_;
};

}  // namespace aisle
