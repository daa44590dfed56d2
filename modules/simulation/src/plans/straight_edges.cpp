#include "plans/straight_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "aisle/core/angle.hpp"
#include "aisle/geometry/pose2.hpp"
#include "plans/side_moments.hpp"

namespace aisle {
namespace {

constexpr std::size_t kRunsMax = 400;  ///< of one segment; longer ones are joined again when lines are fitted
constexpr double kBluntCorner = 1.5;   ///< cells
constexpr double kTurningBackMax = 1.5;  ///< cells; a border that comes back farther is that of another side

/// The directions in which a line from a fixed point passes every point seen so far within the tolerance.
class Wedge {
 public:
  explicit Wedge(double tolerance) : tolerance_(tolerance) {}

  /// @param reach  from the fixed point to the next point
  void narrow(const Vec2& reach) {
    const double distance = reach.norm();
    if (distance <= tolerance_) return;
    const double half_rad = std::asin(tolerance_ / distance);
    const double heading = heading_of(reach);
    if (!has_middle_) {
      middle_ = heading;
      has_middle_ = true;
    }
    const double turn = std::remainder(heading - middle_, 2 * kPi);
    min_ = std::max(min_, turn - half_rad);
    max_ = std::min(max_, turn + half_rad);
  }

  bool is_empty() const { return min_ > max_; }

  bool contains(const Vec2& reach) const {
    if (!has_middle_) return true;
    const double turn = std::remainder(heading_of(reach) - middle_, 2 * kPi);
    return turn >= min_ - 1e-9 && turn <= max_ + 1e-9;
  }

 private:
  double tolerance_;
  double middle_ = 0;  ///< the angles count from here
  bool has_middle_ = false;
  double min_ = -kPi / 2;
  double max_ = kPi / 2;
};

class Cutter {
 public:
  Cutter(const Outline& outline, double tolerance)
      : outline_(outline),
        tolerance_(tolerance),
        blunt_corner_(std::clamp(kBluntCorner - 2 * (1 - tolerance), 0.5, kBluntCorner)),
        sums_(outline) {}

  /// The best cuts if the outline is cut at the corner `start`.
  std::vector<OutlineSegment> cut(std::size_t start) {
    const std::size_t runs = outline_.size();
    best_.assign(runs + 1, {});
    best_[0] = {0, 0, 0};
    for (std::size_t from = 0; from < runs; ++from) extend(start, from);
    std::vector<OutlineSegment> segments;
    for (std::size_t at = runs; at > 0; at = best_[at].from) {
      segments.push_back({start + best_[at].from, start + at});
    }
    std::reverse(segments.begin(), segments.end());
    return segments;
  }

 private:
  struct Cuts {
    std::size_t segments = std::numeric_limits<std::size_t>::max();
    double squares = 0;
    std::size_t from = 0;
  };

  /// The point of a run at a distance from its start.
  Vec2 point(std::size_t run, double along) const {
    const LatticePoint a = outline_[run % outline_.size()], b = outline_[(run + 1) % outline_.size()];
    return Vec2(a.x, a.y) + along / length(run) * Vec2(b.x - a.x, b.y - a.y);
  }

  double length(std::size_t run) const {
    const LatticePoint a = outline_[run % outline_.size()], b = outline_[(run + 1) % outline_.size()];
    return std::abs(b.x - a.x) + std::abs(b.y - a.y);
  }

  /// Tries every straight segment that begins at this corner. Up to a cell at either end of a segment may
  /// belong to its neighbour: corners of turned rooms are blunt.
  void extend(std::size_t start, std::size_t from) {
    const auto blunt = [&](std::size_t run) { return std::min(blunt_corner_, length(run) / 2); };
    const Vec2 origin = point(start + from, blunt(start + from));
    Wedge wedge(tolerance_);
    double farthest = 0;
    const std::size_t limit = std::min(outline_.size(), from + kRunsMax);
    for (std::size_t to = from + 1; to <= limit; ++to) {
      const std::size_t run = start + to - 1;
      const Vec2 run_start = point(run, 0.5) - origin, run_end = point(run, length(run) - 0.5) - origin;
      if (to > from + 1) wedge.narrow(run_start);
      farthest = std::max(farthest, run_start.norm());
      if (wedge.is_empty() || run_end.norm() < farthest - kTurningBackMax) return;
      if (to == from + 1 || wedge.contains(point(run, length(run) - blunt(run)) - origin))
        offer(start, from, to);
      wedge.narrow(run_end);
      farthest = std::max(farthest, run_end.norm());
      if (wedge.is_empty()) return;
    }
  }

  void offer(std::size_t start, std::size_t from, std::size_t to) {
    const std::size_t segments = best_[from].segments + 1;
    if (segments > best_[to].segments) return;
    const double squares = best_[from].squares + sums_.between(start + from, start + to).squares_off_line();
    if (segments < best_[to].segments || squares < best_[to].squares) {
      best_[to] = {segments, squares, from};
    }
  }

  const Outline& outline_;
  double tolerance_;
  double blunt_corner_;
  SideMoments sums_;
  std::vector<Cuts> best_;  ///< to each corner, counted from the start
};

}  // namespace

std::vector<OutlineSegment> straight_edges(const Outline& outline, double tolerance) {
  Cutter cutter(outline, tolerance);
  const std::vector<OutlineSegment> somehow = cutter.cut(0);
  // The first start was arbitrary; a corner halfway around is a cut of a good solution.
  return cutter.cut(somehow[somehow.size() / 2].first);
}

}  // namespace aisle
