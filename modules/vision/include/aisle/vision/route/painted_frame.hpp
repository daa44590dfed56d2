#pragma once
/// A rectangle painted on the floor to park in: L96 section 3.4.

#include <optional>
#include <span>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/back_projection.hpp"

namespace aisle {

struct PaintedFrameParams {
  double contrast = 0.08;
  double line_m = 0.06;
  double range_m = 5;
  double heading_reach_rad = 35 * kDegree;
  double near_line_m = 0.04;
  double covered_share = 0.6;

  void describe(FieldList& fields);
};

/// Middles of bright lines on the floor, found along the rows and columns of an image, in base_link [m].
std::vector<Vec2> painted_line_points(const Image& grey, const CameraModel& camera, const CameraMount& mount,
                                      const PaintedFrameParams& params);

/// A rectangle that was found.
struct FrameFit {
  Pose2 T_vehicle_frame;       ///< its middle; x points the way in
  Vec2 size_m = Vec2::Zero();  ///< between its lines' middles, in the direction of the way in and across
  double rms_m = 0;            ///< of the points on its lines
  int sides = 0;               ///< how many of the four are covered with points
  /// Corners in base_link: far left, far right, near right, near left.
  std::vector<Vec2> corners() const;
};

/// The rectangle of a known size that most points lie on, with a heading near an expected one.
/// @return nullopt unless at least three of its sides are covered
std::optional<FrameFit> find_frame(std::span<const Vec2> p_vehicle, const Vec2& size_m,
                                   double expected_heading_rad, const PaintedFrameParams& params);

/// The same where the rectangle's pose is roughly known: two sides that are not parallel suffice.
std::optional<FrameFit> track_frame(std::span<const Vec2> p_vehicle, const Vec2& size_m,
                                    const Pose2& T_vehicle_expected, const PaintedFrameParams& params);

/// A rectangle of unknown size; all four of its sides must be covered.
std::optional<FrameFit> find_frame_and_size(std::span<const Vec2> p_vehicle, double expected_heading_rad,
                                            const PaintedFrameParams& params);

}  // namespace aisle
