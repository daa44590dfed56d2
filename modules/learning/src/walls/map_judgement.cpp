#include "aisle/learning/walls/map_judgement.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "aisle/maps/cell_index.hpp"

namespace aisle {
namespace {

constexpr std::size_t kJudgedScans = 300;
constexpr std::size_t kJudgedBeams = 60;  // of each scan
constexpr double kJudgedReach_m = 15;     // farther readings move too much with the heading
constexpr double kOnWall_m = 0.10;
constexpr double kThroughWall_m = 0.30;
constexpr std::size_t kReadingsToJudge = 1000;
// Between the shares of maps that are right and of torn ones: benchmarks/reports/2026-11-28-recordings.
constexpr double kPassDoubtful = 0.04;
constexpr double kPassPoor = 0.08;
constexpr double kFitDoubtful = 0.5;
constexpr double kFitPoor = 0.3;

class Judge {
 public:
  explicit Judge(const WallMap& walls) : walls_(walls), index_(1) {
    for (std::size_t w = 0; w < walls.walls.size(); ++w)
      index_.add(walls.walls[w].segment, static_cast<int>(w));
  }

  void take(const Vec2& from, const Vec2& end) {
    ++readings_;
    fitting_ += is_on_wall(end);
    passing_ += passes_wall(from, end);
  }

  MapJudgement judgement() const {
    const double count = std::max(1.0, static_cast<double>(readings_));
    return {static_cast<double>(fitting_) / count, static_cast<double>(passing_) / count, readings_};
  }

 private:
  bool is_on_wall(const Vec2& end) {
    index_.query(end, end, kOnWall_m, near_);
    return std::any_of(near_.begin(), near_.end(), [&](int w) {
      return walls_.walls[static_cast<std::size_t>(w)].segment.distance(end) < kOnWall_m;
    });
  }

  /// The box of a long oblique beam touches many cells, so it is walked in pieces.
  bool passes_wall(const Vec2& from, const Vec2& end) {
    const double length_m = (end - from).norm() - kThroughWall_m;
    if (length_m <= 0) return false;
    const Vec2 along = (end - from).normalized();
    const Vec2 until = from + length_m * along;
    const int pieces = static_cast<int>(std::ceil(length_m));
    const Vec2 step = (until - from) / pieces;
    for (int i = 0; i < pieces; ++i) {
      const Segment2 piece{from + i * step, from + (i + 1) * step};
      index_.query(piece.start, piece.end, 0, near_);
      for (const int w : near_) {
        if (cross(piece, walls_.walls[static_cast<std::size_t>(w)].segment)) return true;
      }
    }
    return false;
  }

  const WallMap& walls_;
  CellIndex index_;
  std::vector<int> near_;
  std::size_t readings_ = 0, fitting_ = 0, passing_ = 0;
};

}  // namespace

Trust trust_in(const MapJudgement& judgement) {
  if (judgement.readings < kReadingsToJudge) return Trust::kUnknown;
  if (judgement.pass_share > kPassPoor || judgement.fit_share < kFitPoor) return Trust::kPoor;
  return judgement.pass_share > kPassDoubtful || judgement.fit_share < kFitDoubtful ? Trust::kDoubtful
                                                                                    : Trust::kGood;
}

MapJudgement judge_map(const WallMap& walls, const LaserLog& log, std::span<const Pose2> T_map_vehicle) {
  Judge judge(walls);
  const std::size_t scan_step = std::max<std::size_t>(1, log.scans.size() / kJudgedScans);
  for (std::size_t i = 0; i < log.scans.size(); i += scan_step) {
    const LaserScan& scan = log.scans[i];
    const LaserScanner laser = log.laser_of(scan);
    const Pose2 T_map_laser = T_map_vehicle[i] * laser.T_vehicle_laser;
    const double limit_m = std::min(kJudgedReach_m, laser.range_max_m);
    const std::size_t beam_step = std::max<std::size_t>(1, scan.ranges_m.size() / kJudgedBeams);
    for (std::size_t beam = 0; beam < scan.ranges_m.size(); beam += beam_step) {
      const double range_m = scan.ranges_m[beam];
      if (range_m > 0.05 && range_m < limit_m)
        judge.take(T_map_laser.position(), T_map_laser * Vec2(range_m * unit(laser.beam_angle(beam))));
    }
  }
  return judge.judgement();
}

}  // namespace aisle
