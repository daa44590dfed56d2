#pragma once
/// What the scans themselves show about the scanner: compared with the odometry, how its readings run, where
/// it sits and how far the clocks are apart.

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// The motion over a short piece of the run, by the scans and by the odometry.
struct MotionPair {
  double from_s = 0, to_s = 0;
  Pose2 laser;                      ///< from its pose at `from_s` to that at `to_s`
  Mat3 information = Mat3::Zero();  ///< of `laser`
  Pose2 vehicle;                    ///< the same by the odometry
};

/// The motion of the laser by the scans alone, over the first part of a run that moves and turns enough.
struct SampledMotion {
  std::vector<double> times_s;
  std::vector<Pose2> T_first_laser;
  std::vector<Mat3> information;  ///< of the step into each scan
  double median_share = 0;        ///< of the points of a scan that lie on what was seen before

  double turned_rad() const;
  double moved_m() const;
};

/// @param beams  of every scan, instead of its own; nullopt: its own
SampledMotion sample_motion(const LaserLog& log, std::optional<ScanBeams> beams);

/// How the turning by the scans follows the turning by the odometry.
struct TurnAgreement {
  double correlation = 0;  ///< -1: the readings run the other way round; near 0: they have nothing in common
  double slope = 0;        ///< turn by the scans per turn by the odometry
  double delay_s = 0;      ///< of the odometry's stamps behind the scans' at which they agree best
};

/// @param delay_max_s  delays up to this are tried to both sides
TurnAgreement compare_turns(const SampledMotion& scans, std::span<const OdometrySample> odometry,
                            double delay_max_s);

/// A mounting with how well it is known.
struct FoundMounting {
  Pose2 T_vehicle_laser;
  double sigma_m = 0;
  double sigma_rad = 0;
};

/// The mounting at which both motions are one rigid body's, T_vehicle_laser * laser = vehicle *
/// T_vehicle_laser, by linear least squares in (x, y, cos, sin). nullopt if the motions do not fix it:
/// without turns the position is free, without distance the heading.
std::optional<FoundMounting> find_mounting(std::span<const MotionPair> pairs);

/// Finds the mounting while a run is mapped.
class MountingEstimator {
 public:
  /// Takes where the laser was by the map and where the vehicle was by the odometry, at one moment.
  /// @return whether the estimate is new
  bool add(const Pose2& T_map_laser, const Pose2& T_odom_vehicle);

  /// The mounting as far as it is known to differ from `given`: position and heading each only if they are
  /// off by three standard deviations.
  Pose2 T_vehicle_laser(const Pose2& given) const;

 private:
  std::optional<std::pair<Pose2, Pose2>> from_;  ///< where the current piece began: laser, vehicle
  std::vector<MotionPair> pairs_;
  std::optional<FoundMounting> found_;
};

/// The parts of a found mounting that are known to differ from a given one by three standard deviations, at
/// least 2 cm or 1 degree; the rest as given.
Pose2 significant(const FoundMounting& found, const Pose2& given);

/// Pieces of about 0.3 m or 15 degrees.
std::vector<MotionPair> motion_pairs(const SampledMotion& scans, std::span<const OdometrySample> odometry,
                                     double delay_s);

}  // namespace aisle
