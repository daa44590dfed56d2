#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/learning/walls/scan_odometry.hpp"
#include "aisle/localisation/localiser.hpp"
#include "aisle/vehicle/odometry_track.hpp"
#include "settled_log.hpp"

namespace aisle {

/// From being found until being lost or the log's end.
struct FoundSpan {
  std::size_t first = 0;  ///< scan
  std::size_t last = 0;
  bool ended_lost = false;
  double path_m = 0;
};

/// What became of the vehicle of a log in a known building.
struct LogPoses {
  std::vector<std::optional<Pose2>> T_map_vehicle;  ///< one per scan; none where it was not found
  std::vector<FoundSpan> found;
  std::vector<double> path_m;   ///< driven before each scan
  std::vector<double> cycle_s;  ///< processor time of each tracked scan
  double search_s = 0;          ///< of the longest search
};

/// Takes the scans of a log one after the other, as they came in.
class LogLocalisation {
 public:
  /// @param log  with at least one scan; must outlive this
  LogLocalisation(const SettledLog& log, Localiser& localiser);

  LogPoses run(Progress& progress);

 private:
  UncertainPose2 motion_to(std::size_t scan);
  Pose2 odometry_at(double time_s, std::size_t known) const;
  Pose2 swept_by(const LaserScan& scan) const;
  void take(std::size_t scan, LogPoses& poses);

  const SettledLog& log_;
  Localiser& localiser_;
  OdometryTrack odometry_;
  double delay_s_;
  ScanOdometry scans_;
  Pose2 counted_since_;  ///< by the wheels, of the first scanner since its last scan
  double path_m_ = 0;
  std::vector<Vec2> points_;
};

}  // namespace aisle
