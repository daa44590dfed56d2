#pragma once

#include <memory>
#include <span>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/geometry/sensed_segment.hpp"

namespace aisle {

struct SegmentParams {
  double range_min_m = 0.08;
  double range_max_m = 25;
  double split_m = 0.05;
  double rms_max_m = 0.04;
  double length_min_m = 0.10;
  int points_min = 4;
  double range_sigma_m = 0.015;
  double offset_floor_m = 0.010;
  double heading_floor_rad = 0.5 * kDegree;
  double uneven_m = 0;

  void describe(FieldList& fields);
};

/// The beams of a scanner's polar scan, as far as segments need them.
struct ScanGeometry {
  double first_angle_rad = 0;
  double angle_step_rad = 0;
  double range_max_m = 0;  ///< readings of this or more are "nothing seen"
  /// Motion of the sensor from the first beam to the last, in its own frame; the points are given as from the
  /// middle of it. Identity: all beams were measured at once.
  Pose2 swept = {};

  friend bool operator==(const ScanGeometry& a, const ScanGeometry& b) {
    return a.first_angle_rad == b.first_angle_rad && a.angle_step_rad == b.angle_step_rad &&
           a.range_max_m == b.range_max_m && a.swept.x == b.swept.x && a.swept.y == b.swept.y &&
           a.swept.theta == b.swept.theta;
  }
};

/// Cuts range scans into straight segments: split and merge. The distances in the parameters apply to a
/// scanner with up to 1.5 cm of noise; the noise is measured from the scans, and the distances grow with it.
/// O(beams log beams) a scan, no allocation once warm.
class RangeSegmenter {
 public:
  RangeSegmenter(const ScanGeometry& geometry, const SegmentParams& params);
  ~RangeSegmenter();

  /// Replaces `segments` by those of one scan, in the order of the beams. Ranges that are not positive, not
  /// finite or beyond the scanner's reach are skipped.
  void extract(std::span<const float> ranges_m, std::vector<SensedSegment>& segments);
  /// The same for a scan with beams of its own.
  void extract(const ScanGeometry& geometry, std::span<const float> ranges_m,
               std::vector<SensedSegment>& segments);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace aisle
