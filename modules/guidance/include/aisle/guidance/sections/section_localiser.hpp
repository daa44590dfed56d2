#pragma once
/// Localisation for driving a list of sections: L03 section 4.1, as corrections of a pose.

#include <span>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/guidance/sections/guided_path.hpp"
#include "aisle/learning/pose_filter.hpp"
#include "aisle/learning/sections/walls_beside.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct SectionLocaliserParams {
  double start_sigma_m = 0.05;
  double start_sigma_rad = 3 * kDegree;
  double wall_sigma_m = 0.03;
  double wall_gate_m = 0.5;
  double length_gate_m = 0.5;
  double length_reach_m = 2.5;
  double repeat_inflation = 3;
  bool heading_by_walls = true;
  bool left_base_line = true;
  bool length_by_wall_ahead = true;
  bool length_by_line_end = false;

  void describe(FieldList& fields);
};

/// Odometry, corrected by the floor's edges. The base lines beside a section correct the lateral position;
/// the wall across its end (and, if wanted, the end of the base line inside of the next turn) the
/// longitudinal one; walls at right angles, everywhere, the heading.
class SectionLocaliser {
 public:
  /// @param guided  its path is not empty; must outlive this
  SectionLocaliser(const SectionLocaliserParams& params, const VehicleDescription& vehicle,
                   const GuidedPath& guided);

  void predict(const OdometryReading& reading) { filter_.predict(reading); }

  /// As those of PoseFilter: around `correct`, for an image that was taken some predictions ago.
  bool go_back(int predictions) { return filter_.go_back(predictions); }
  void catch_up() { filter_.catch_up(); }

  /// Takes in what one image shows.
  /// @param edges  in base_link
  /// @param piece  index of the path's piece on which the vehicle is
  void correct(std::span<const SensedSegment> edges, std::size_t piece);

  /// Whether the last image corrected the pose by a base line beside the path.
  bool is_guided() const { return is_guided_; }
  const Pose2& pose() const { return filter_.pose(); }
  /// The vehicle's start pose, by all that was seen since.
  const Pose2& start_pose() const { return filter_.first_pose(); }
  /// Standard deviation of the cross-track error on a path with this heading.
  double lateral_sigma_m(double heading_rad) const;

 private:
  /// The path's piece that the vehicle is on.
  struct Here {
    const PathPiece& piece;
    const SectionGuide& guide;
    Pose2 T_piece_vehicle;
  };

  Here here(std::size_t piece) const;
  void correct_heading(std::span<const SensedSegment> edges);
  void correct_distance(const Here& here);
  void correct_by_wall_ahead(const Here& here, std::span<const SensedSegment> edges);
  void correct_by_line_end(const Here& here);
  const WallBeside* wall_at(double lateral_m) const;
  /// Standard deviation of a quantity with this derivative by the pose.
  double sigma_of(const Vec3& by_pose) const;
  double distrust(double off_m, const Vec3& by_pose) const;
  double inflated(double sigma_m) const;
  double heading_variance() const { return filter_.covariance()(2, 2); }

  SectionLocaliserParams params_;
  const GuidedPath* guided_;
  PoseFilter filter_;
  std::vector<WallBeside> beside_;
  std::vector<WallAcross> across_;
  bool is_guided_ = false;
};

}  // namespace aisle
