#pragma once
/// C98's local features: where the vertical lines of a picture stand on the floor, as the vehicle sees it.

#include <optional>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/back_projection.hpp"
#include "aisle/vision/base_lines.hpp"
#include "aisle/vision/vertical_lines.hpp"

namespace aisle {

struct LandmarkSightingParams {
  VerticalLineParams verticals;
  BaseLineParams base_lines;
  BackProjectionNoise noise;
  double distance_max_m = 7;
  bool hanging = true;  ///< lines that end above the floor count too, see LandmarkDetector

  void describe(FieldList& fields);
};

/// A vertical line that stands on the floor.
struct LandmarkSighting {
  Vec2 p_vehicle = Vec2::Zero();   ///< its foot, in base_link
  Mat2 covariance = Mat2::Zero();  ///< of the foot; long along the line of sight
  Vec2 by_tilt = Vec2::Zero();     ///< the part of that which all sightings of one picture share: how far the foot
                                   ///< goes when the tilt is off by a standard deviation [m]
  Vec2 foot_px = Vec2::Zero();     ///< in the picture
  bool brighter_right = false;     ///< the right side of the line is the brighter one
};

/// Picture -> vertical lines -> base lines -> feet -> floor. A line that stands on a base line has its foot
/// there. One that ends above it (a poster's edge) hangs on the wall of that base line: its foot is where its
/// azimuth meets the wall. No allocation once warm but for the base lines.
class LandmarkDetector {
 public:
  LandmarkDetector(const LandmarkSightingParams& params, const CameraIntrinsics& intrinsics,
                   const CameraMount& mount);

  /// From left to right; valid until the next call.
  /// @throws std::invalid_argument unless the picture has one channel
  const std::vector<LandmarkSighting>& detect(const Image& grey);

  /// What the last picture showed, for drawings.
  const std::vector<VerticalLine>& lines() const { return lines_; }
  const BaseLines& base_lines() const { return base_lines_; }

 private:
  void back_project(const std::optional<BaseLine>& base_line, std::vector<Vec2>& wall_vehicle) const;
  std::optional<Vec2> foot_px(const VerticalLine& line) const;
  std::optional<Vec2> hanging_foot(const VerticalLine& line, const std::vector<Vec2>& wall_vehicle) const;

  LandmarkSightingParams params_;
  CameraModel camera_;
  CameraMount mount_;
  BackProjection floor_;
  BackProjection floor_tilted_;  ///< the same with the tilt off by a standard deviation
  VerticalLineDetector verticals_;
  BaseLineDetector base_line_detector_;
  std::vector<VerticalLine> lines_;
  BaseLines base_lines_;
  std::vector<Vec2> left_wall_vehicle_, right_wall_vehicle_;  ///< where the base lines are on the floor
  std::vector<LandmarkSighting> sightings_;
};

}  // namespace aisle
