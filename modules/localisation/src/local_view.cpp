#include "aisle/localisation/local_view.hpp"

#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace aisle {
namespace {

std::int64_t piece_of(const Vec2& p, double piece_m) {
  const auto column = static_cast<std::int64_t>(std::floor(p.x() / piece_m));
  const auto row = static_cast<std::int64_t>(std::floor(p.y() / piece_m));
  return (column << 32) ^ (row & 0xffffffff);
}

}  // namespace

void LocalViewParams::describe(FieldList& fields) {
  fields.real("every_m", every_m, {0.05, 5}, "a scan is kept after this path");
  fields.angle("every_deg", every_rad, {1, 180}, "a scan is kept after this turn");
  fields.real("path_m", path_m, {1, 100}, "scans are forgotten after this path");
  fields.real("thin_m", thin_m, {0.02, 1}, "one beam counts for each piece of surface of this size");
}

bool LocalView::take(std::span<const Vec2> hits, const Vec2& p_laser, const Pose2& T_last_now) {
  T_view_vehicle_ = T_view_vehicle_ * T_last_now;
  path_m_ += T_last_now.position().norm();
  turned_rad_ += std::abs(T_last_now.theta);
  if (!kept_.empty()) {
    const Pose2 moved = between(kept_.back().T_view_vehicle, T_view_vehicle_);
    if (moved.position().norm() < params_.every_m && std::abs(moved.theta) < params_.every_rad) return false;
  }
  kept_.push_back({T_view_vehicle_, p_laser, {hits.begin(), hits.end()}, path_m_});
  while (kept_.front().path_m < path_m_ - params_.path_m) kept_.pop_front();
  return true;
}

std::vector<ViewBeam> LocalView::beams() const {
  std::unordered_map<std::int64_t, std::size_t> beam_of_piece;
  std::vector<ViewBeam> beams;
  for (const Kept& scan : kept_) {
    const Pose2 T_vehicle_then = between(T_view_vehicle_, scan.T_view_vehicle);
    for (const Vec2& hit : scan.hits) {
      const std::int64_t piece = piece_of(scan.T_view_vehicle * hit, params_.thin_m);
      const ViewBeam beam{T_vehicle_then * scan.p_laser, T_vehicle_then * hit};
      const auto [at, is_new] = beam_of_piece.try_emplace(piece, beams.size());
      if (is_new) {
        beams.push_back(beam);
        continue;
      }
      ViewBeam& known = beams[at->second];
      if ((beam.p_hit - beam.p_laser).squaredNorm() < (known.p_hit - known.p_laser).squaredNorm())
        known = beam;
    }
  }
  return beams;
}

void LocalView::clear() {
  kept_.clear();
  T_view_vehicle_ = {};
  path_m_ = turned_rad_ = 0;
}

}  // namespace aisle
