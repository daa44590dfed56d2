#include "exploration/signature_example.hpp"

#include "aisle/learning/walls/scan_geometry.hpp"

namespace aisle {
namespace {

constexpr double kOff_m = 0.25;         // as far as the odometry may be off between two views
constexpr double kWindow_m = 8;         // distance of walls that a view is matched with
constexpr double kEndWeight = 0.3;      // c of Algorithm 2
constexpr std::size_t kEveryView = 10;  // only every tenth view is tried as the example

void add(const Segment2& wall, SignedPattern& pattern) {
  pattern.walls.push_back(wall);
  const MarkedSegment marked{wall, wall.length(), kEndWeight, kEndWeight};
  mark(marked, Vec2::UnitX(), SymbolKinds::kOne, pattern.x);
  mark(marked, Vec2::UnitY(), SymbolKinds::kOne, pattern.y);
}

std::vector<Segment2> placed(const std::vector<SensedSegment>& segments, const Pose2& T_map_sensor) {
  std::vector<Segment2> walls;
  walls.reserve(segments.size());
  for (const SensedSegment& segment : segments) walls.push_back(T_map_sensor * segment.segment);
  return walls;
}

/// Length of wall seen along the axis that shows less.
double least_seen_m(const std::vector<Segment2>& walls) {
  Vec2 along = Vec2::Zero();
  for (const Segment2& wall : walls) along += (wall.end - wall.start).cwiseAbs();
  return along.minCoeff();
}

double displacement_m(const Signature& sensed, Signature learned) {
  SignatureCorrelator correlator({});
  sort_symbols(learned);
  correlator.correlate(sensed, learned);
  return correlator.peak_m().value_or(0);
}

}  // namespace

SignatureExample signature_example(const LaserLog& log, const std::vector<Pose2>& T_map_vehicle,
                                   const WallMap& walls, const SegmentParams& segments) {
  RangeSegmenter segmenter(scan_geometry(log.laser()), segments);
  std::vector<Segment2> view;
  Vec2 p_map_seen_from = Vec2::Zero();
  std::vector<SensedSegment> seen;
  for (std::size_t scan = 0; scan < log.scans.size(); scan += kEveryView) {
    segmenter.extract(log.scans[scan].ranges_m, seen);
    std::vector<Segment2> candidate = placed(seen, T_map_vehicle[scan] * log.laser().T_vehicle_laser);
    if (!view.empty() && least_seen_m(candidate) <= least_seen_m(view)) continue;
    view = std::move(candidate);
    p_map_seen_from = T_map_vehicle[scan].position();
  }

  SignatureExample example{.displaced_m = {kOff_m, -0.6 * kOff_m}};
  for (const Wall& wall : walls.walls)
    if (wall.segment.distance(p_map_seen_from) < kWindow_m) add(wall.segment, example.learned);
  for (const Segment2& wall : view)
    add({wall.start + example.displaced_m, wall.end + example.displaced_m}, example.sensed);
  example.found_m = {displacement_m(example.sensed.x, example.learned.x),
                     displacement_m(example.sensed.y, example.learned.y)};
  return example;
}

}  // namespace aisle
