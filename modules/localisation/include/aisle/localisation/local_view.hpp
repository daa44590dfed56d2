#pragma once

#include <deque>
#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A beam and what it hit, in one frame. It stands for one piece of surface.
struct ViewBeam {
  Vec2 p_laser = Vec2::Zero();
  Vec2 p_hit = Vec2::Zero();
};

struct LocalViewParams {
  double every_m = 0.25;  ///< a scan is kept after this path, or ...
  double every_rad = 10 * kDegree;
  double path_m = 12;  ///< scans older than this are forgotten: odometry no longer says where they were
  double thin_m = 0.15;

  void describe(FieldList& fields);
};

/// What was seen along the last metres of path, laid together by odometry.
class LocalView {
 public:
  explicit LocalView(const LocalViewParams& params) : params_(params) {}

  /// Takes a scan, and keeps it if it shows something from a new place.
  /// @param hits        in the vehicle's frame
  /// @param p_laser     the scanner, in the vehicle's frame
  /// @param T_last_now  the vehicle's motion since the last scan, by odometry
  /// @return whether it was kept
  bool take(std::span<const Vec2> hits, const Vec2& p_laser, const Pose2& T_last_now);

  /// One beam for each piece of surface of `thin_m`, in the frame of the vehicle as it stands now; where
  /// several hit the same piece, the shortest.
  std::vector<ViewBeam> beams() const;

  double path_m() const { return path_m_; }          ///< driven since the first scan
  double turned_rad() const { return turned_rad_; }  ///< turned since the first scan, left and right together
  void clear();

 private:
  struct Kept {
    Pose2 T_view_vehicle;
    Vec2 p_laser = Vec2::Zero();
    std::vector<Vec2> hits;  ///< in the vehicle's frame
    double path_m = 0;
  };

  LocalViewParams params_;
  std::deque<Kept> kept_;
  Pose2 T_view_vehicle_;
  double path_m_ = 0;
  double turned_rad_ = 0;
};

}  // namespace aisle
