#pragma once

#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/learning/walls/motion_noise.hpp"
#include "aisle/maps/cell_index.hpp"
#include "aisle/maps/wall_map.hpp"
#include "aisle/matching/pose_alignment.hpp"
#include "aisle/vehicle/laser_log.hpp"
#include "aisle/vision/range_segments.hpp"

namespace aisle {

struct WallLocaliserParams {
  SegmentParams segments;
  MotionNoise motion;
  double gate_m = 0.3;  ///< a segment farther from a wall is not matched with it
  double reach_m = 15;  ///< walls farther away are ignored
  double lost_share = 0.35;

  void describe(FieldList& fields);
};

/// Localises the vehicle in a building with known walls: odometry predicts, each scan is fitted to the walls.
/// What is not on the map is not matched and moves nothing. A step costs O(segments * walls within reach).
class WallLocaliser {
 public:
  WallLocaliser(const WallLocaliserParams& params, const LaserScanner& laser, const WallMap& walls,
                const UncertainPose2& T_map_vehicle);

  /// The vehicle is known to be here.
  void begin_at(const UncertainPose2& T_map_vehicle) { T_map_vehicle_ = T_map_vehicle; }

  /// Takes the next scan.
  /// @param ranges_m  one per beam of the scanner
  /// @param T_last_now  the vehicle's motion since the previous scan, by odometry
  void take_scan(std::span<const float> ranges_m, const Pose2& T_last_now);

  const UncertainPose2& T_map_vehicle() const { return T_map_vehicle_; }
  /// Less of the latest scan fits the walls than a well-localised vehicle would see.
  bool is_doubtful() const { return is_doubtful_; }
  double seen_m() const { return seen_m_; }        ///< length of the latest scan's segments
  double fitting_m() const { return fitting_m_; }  ///< the part of that which fits known walls

 private:
  WallLocaliserParams params_;
  Pose2 T_vehicle_laser_;
  RangeSegmenter segmenter_;
  PoseAligner aligner_;
  std::vector<WallEstimate> walls_;
  CellIndex index_;
  UncertainPose2 T_map_vehicle_;
  std::vector<SensedSegment> seen_;
  std::vector<int> near_;
  bool is_doubtful_ = false;
  double seen_m_ = 0;
  double fitting_m_ = 0;
};

}  // namespace aisle
