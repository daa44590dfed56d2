#include "aisle/control/path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

/// The first turn in from .. to (both >= 0) that is `turn_rad` or whole turns from it, else the nearer end.
double turn_within(double turn_rad, double from_rad, double to_rad) {
  const double turns = std::ceil((from_rad - turn_rad) / (2 * kPi));
  const double above_rad = turn_rad + 2 * kPi * turns;  // the first at or after from_rad
  if (above_rad <= to_rad) return above_rad;
  const double below_rad = above_rad - 2 * kPi;
  return from_rad - below_rad <= above_rad - to_rad ? from_rad : to_rad;
}

bool joins(const Pose2& end, const Pose2& start) {
  constexpr double kGap_m = 1e-4, kKink_rad = 1e-4;
  return (end.position() - start.position()).norm() < kGap_m &&
         std::abs(wrap_angle(end.theta - start.theta)) < kKink_rad;
}

bool is_one_leg(const PathPiece& a, const PathPiece& b) {
  return a.arc.length_m * b.arc.length_m > 0;
}

}  // namespace

Pose2 PathPiece::at(double from_start_m) const {
  if (is_on_the_spot()) return T_map_start;
  const double share = from_start_m / path_m();
  return T_map_start * end_pose({share * arc.length_m, share * arc.turn_rad});
}

double PathPiece::nearest(const Vec2& p_map, double from_m, double to_m) const {
  if (is_on_the_spot()) return 0;
  const Vec2 p = T_map_start.inverse() * p_map;
  if (arc.turn_rad == 0) return std::clamp(std::copysign(1, arc.length_m) * p.x(), from_m, to_m);
  const double radius_m = arc.length_m / arc.turn_rad;  // the centre is at (0, radius)
  const double turn_rad = std::copysign(1, arc.turn_rad) * std::atan2(p.x() / radius_m, 1 - p.y() / radius_m);
  const double m_per_rad = std::abs(radius_m);
  return std::clamp(m_per_rad * turn_within(turn_rad, from_m / m_per_rad, to_m / m_per_rad), from_m, to_m);
}

Path::Path(std::vector<PathPiece> pieces) : pieces_(std::move(pieces)) {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (i > 0 && !joins(pieces_[i - 1].end(), pieces_[i].T_map_start)) {
      throw std::invalid_argument("piece " + std::to_string(i) + " does not start where the one before ends");
    }
    starts_m_.push_back(length_m_);
    length_m_ += pieces_[i].path_m();
  }
}

PathPoint Path::point(std::size_t piece, double from_start_m) const {
  return {.piece = piece,
          .along_m = starts_m_[piece] + from_start_m,
          .T_map_path = pieces_[piece].at(from_start_m),
          .curvature_per_m = pieces_[piece].curvature_per_m()};
}

PathPoint Path::at(double along_m) const {
  const double within_m = std::clamp(along_m, 0.0, length_m_);
  const auto after = std::upper_bound(starts_m_.begin() + 1, starts_m_.end(), within_m);
  const std::size_t piece = static_cast<std::size_t>(after - starts_m_.begin()) - 1;
  return point(piece, std::min(within_m - starts_m_[piece], pieces_[piece].path_m()));
}

PathPoint Path::nearest(const Vec2& p_map, double from_m, double to_m, std::size_t first,
                        std::size_t end) const {
  const double last_m = std::clamp(to_m, 0.0, length_m_), first_m = std::clamp(from_m, 0.0, last_m);
  PathPoint best;
  double best_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = first; i < end; ++i) {
    const PathPiece& piece = pieces_[i];
    const double start_m = starts_m_[i], piece_m = piece.path_m();
    if (start_m + piece_m < first_m || start_m > last_m) continue;
    const PathPoint here = point(i, piece.nearest(p_map, std::clamp(first_m - start_m, 0.0, piece_m),
                                                  std::clamp(last_m - start_m, 0.0, piece_m)));
    const double off_m = (p_map - here.T_map_path.position()).norm();
    if (off_m >= best_m) continue;
    best = here;
    best_m = off_m;
  }
  best.lateral_m = (best.T_map_path.inverse() * p_map).y();
  return best;
}

std::size_t Path::leg_end(std::size_t piece) const {
  std::size_t end = piece + 1;
  while (end < pieces_.size() && is_one_leg(pieces_[end - 1], pieces_[end])) ++end;
  return end;
}

double Path::leg_end_m(std::size_t piece) const {
  const std::size_t last = leg_end(piece) - 1;
  return starts_m_[last] + pieces_[last].path_m();
}

Path Path::up_to(double along_m, std::size_t end) const {
  constexpr double kLeast_m = 1e-3;
  std::vector<PathPiece> pieces;
  while (pieces.size() < end) {
    PathPiece piece = pieces_[pieces.size()];
    const double left_m = along_m - starts_m_[pieces.size()];
    const bool is_beyond = piece.is_on_the_spot() ? left_m < 0 : left_m <= 0;
    if (is_beyond && !pieces.empty()) break;
    if (left_m < piece.path_m()) {
      const double share = std::max(left_m, kLeast_m) / piece.path_m();
      piece.arc = {piece.arc.length_m * share, piece.arc.turn_rad * share};
    }
    pieces.push_back(piece);
  }
  return Path(std::move(pieces));
}

Path Path::followed_by(const Path& next) const {
  std::vector<PathPiece> pieces = pieces_;
  pieces.insert(pieces.end(), next.pieces_.begin(), next.pieces_.end());
  return Path(std::move(pieces));
}

Path Path::reversed() const {
  const Pose2 about{0, 0, kPi};
  std::vector<PathPiece> back;
  for (auto piece = pieces_.rbegin(); piece != pieces_.rend(); ++piece) {
    back.push_back({piece->end() * about, {piece->arc.length_m, -piece->arc.turn_rad}});
  }
  return Path(std::move(back));
}

}  // namespace aisle
