#include "aisle/simulation/plans/plan_tracing.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "aisle/core/angle.hpp"
#include "aisle/geometry/dominant_direction.hpp"
#include "plans/cell_outlines.hpp"
#include "plans/side_moments.hpp"
#include "plans/straight_edges.hpp"
#include "plans/wall_polygon.hpp"

namespace aisle {
namespace {

constexpr double kCornerBlurMax = 1.5;  ///< cells at either end of a long segment that do not count
constexpr double kToleranceMin = 0.5;   ///< cells
constexpr double kSmallShape = 16;      ///< tolerances: a smaller one keeps its shape by a smaller tolerance
constexpr double kTinyShape = 4;        ///< cells: what is smaller keeps every corner
constexpr double kLongSegment = 8;      ///< cells
constexpr std::size_t kCornersMax = 1'000'000;  ///< five for each of the walls that a world may have
constexpr std::size_t kDirectionPieces = 1000;  ///< the longest, to find the dominant direction
constexpr double kSameDirection_rad = 4 * kDegree;
constexpr double kDominantShareMin = 0.3;
constexpr double kAlignedWithPlan_rad = 0.7 * kDegree;

Vec2 point_of(const LatticePoint& p) {
  return Vec2(p.x, p.y);
}

double larger_side(const Outline& outline) {
  Vec2 min = point_of(outline[0]), max = min;
  for (const LatticePoint& corner : outline) {
    min = min.cwiseMin(point_of(corner));
    max = max.cwiseMax(point_of(corner));
  }
  return (max - min).maxCoeff();
}

std::vector<OutlineSegment> every_run(const Outline& outline) {
  std::vector<OutlineSegment> runs;
  for (std::size_t corner = 0; corner < outline.size(); ++corner) runs.push_back({corner, corner + 1});
  return runs;
}

/// One outline with the segments that it was cut into.
class CutOutline {
 public:
  CutOutline(Outline outline, double tolerance)
      : outline_(std::move(outline)),
        tolerance_(std::clamp(larger_side(outline_) / kSmallShape, kToleranceMin, tolerance)),
        segments_(larger_side(outline_) < kTinyShape ? every_run(outline_)
                                                     : straight_edges(outline_, tolerance_)),
        moments_(outline_) {}

  std::span<const OutlineSegment> segments() const { return segments_; }

  Vec2 corner(std::size_t at) const { return point_of(outline_[at % outline_.size()]); }

  /// Joins neighbouring segments that one line fits as well.
  void join(std::span<const double> frames_rad) {
    if (larger_side(outline_) < kTinyShape) return;
    std::vector<OutlineSegment> joined;
    for (const OutlineSegment& segment : segments_) {
      if (!joined.empty() &&
          are_one({joined.back().first, segment.last}, joined.back(), segment, frames_rad)) {
        joined.back().last = segment.last;
      } else {
        joined.push_back(segment);
      }
    }
    segments_ = std::move(joined);
  }

  /// Where the segment goes, on the line that fits it best; towards its end.
  StraightPiece free_fit(const OutlineSegment& segment) const {
    const Moments moments = moments_.between(segment.first, segment.last);
    const Vec2 ahead = corner(segment.last) - corner(segment.first);
    const Vec2 direction = moments.direction();
    return piece(segment, moments.mean(), direction.dot(ahead) < 0 ? Vec2(-direction) : direction);
  }

  /// The same parallel to one of the axes of a frame; if none is within the tolerance, the best fit.
  StraightPiece fit(const OutlineSegment& segment, std::span<const double> frames_rad) const {
    if (larger_side(outline_) < kTinyShape) return exact_run(segment);
    StraightPiece best = free_fit(segment);
    for (const double frame_rad : frames_rad) {
      const double heading = std::atan2(best.along.y(), best.along.x());
      const double off = wrap_quarter_turn(heading - frame_rad);
      if (std::abs(off) > kPi / 8) continue;
      const Vec2 along = unit(std::round((heading - off) / kDegree * 1e9) * kDegree / 1e9);
      if (const auto offset = offset_within_tolerance(segment, along)) {
        return piece(segment, *offset * left_normal(along), along);
      }
    }
    return best;
  }

 private:
  bool are_one(const OutlineSegment& both, const OutlineSegment& a, const OutlineSegment& b,
               std::span<const double> frames_rad) const {
    if (fit(a, frames_rad).along.dot(fit(b, frames_rad).along) < std::cos(kSameDirection_rad)) return false;
    return offset_within_tolerance(both, fit(both, frames_rad).along).has_value();
  }

  StraightPiece exact_run(const OutlineSegment& run) const {
    return piece(run, corner(run.first), (corner(run.last) - corner(run.first)).normalized());
  }

  StraightPiece piece(const OutlineSegment& segment, const Vec2& on_line, const Vec2& along) const {
    return {on_line, along, corner(segment.first), corner(segment.last)};
  }

  /// Calls with the middle of every side of the segment that runs along the direction rather than across it;
  /// sides next to a corner belong to neither wall.
  template <class Use>
  void for_sides_along(const OutlineSegment& segment, const Vec2& along, Use use) const {
    const Vec2 first = corner(segment.first), last = corner(segment.last);
    const double blur = (last - first).norm() > kLongSegment ? kCornerBlurMax : 0;
    const double from = first.dot(along) + blur, to = last.dot(along) - blur;
    for (std::size_t run = segment.first; run < segment.last; ++run) {
      const Vec2 start = corner(run), end = corner(run + 1);
      const double length = (end - start).norm();
      const Vec2 step = (end - start) / length;
      if (std::abs(step.dot(along)) < 0.5) continue;
      for (int i = 0; i < static_cast<int>(length); ++i) {
        const Vec2 side = start + (i + 0.5) * step;
        if (side.dot(along) >= from && side.dot(along) <= to) use(side);
      }
    }
  }

  std::optional<double> offset_within_tolerance(const OutlineSegment& segment, const Vec2& along) const {
    std::vector<double> offsets;
    for_sides_along(segment, along,
                    [&](const Vec2& side) { offsets.push_back(side.dot(left_normal(along))); });
    if (offsets.empty()) return std::nullopt;
    const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
    std::nth_element(offsets.begin(), middle, offsets.end());
    const double median = *middle;
    const bool fits = std::all_of(offsets.begin(), offsets.end(), [&](double offset) {
      return std::abs(offset - median) <= tolerance_ + 1e-9;
    });
    return fits ? std::optional(median) : std::nullopt;
  }

  Outline outline_;
  double tolerance_;
  std::vector<OutlineSegment> segments_;
  SideMoments moments_;
};

/// Directions that walls are made parallel to: that of most walls, and the plan's own.
std::vector<double> frames_of(const std::vector<CutOutline>& outlines) {
  std::vector<SensedSegment> pieces;
  for (const CutOutline& outline : outlines) {
    for (const OutlineSegment& segment : outline.segments()) {
      const StraightPiece piece = outline.free_fit(segment);
      pieces.push_back({.heading_rad = std::atan2(piece.along.y(), piece.along.x()),
                        .length_m = (piece.last - piece.first).norm()});
    }
  }
  const std::size_t longest = std::min(pieces.size(), kDirectionPieces);
  std::partial_sort(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(longest), pieces.end(),
                    [](const auto& a, const auto& b) { return a.length_m > b.length_m; });
  pieces.resize(longest);
  const auto dominant = dominant_direction(pieces);
  if (dominant && dominant->share > kDominantShareMin &&
      std::abs(dominant->heading_rad) > kAlignedWithPlan_rad) {
    return {dominant->heading_rad, 0};
  }
  return {0};
}

/// Every corner of a border is where three of four cells agree, or where two touch at a corner: counted
/// before memory is taken for them.
std::size_t corners_of(const FloorPlan& plan) {
  std::size_t corners = 0;
  for (int y = 0; y <= plan.height; ++y) {
    for (int x = 0; x <= plan.width; ++x) {
      const bool a = plan.is_solid(x - 1, y - 1), b = plan.is_solid(x, y - 1), c = plan.is_solid(x - 1, y),
                 d = plan.is_solid(x, y);
      corners += (a != b) != (c != d) ? 1 : a == d && b == c && a != b ? 2 : 0;
    }
  }
  return corners;
}

}  // namespace

std::optional<std::vector<Segment2>> trace_plan(const FloorPlan& plan, const PlanTracingParams& params,
                                                Progress& progress) {
  if (corners_of(plan) > kCornersMax) return std::nullopt;
  std::vector<Outline> borders = cell_outlines(plan);
  std::vector<CutOutline> outlines;
  for (Outline& border : borders) {
    progress.report("tracing walls", outlines.size(), borders.size());
    outlines.emplace_back(std::move(border), params.tolerance_cells);
  }
  const std::vector<double> frames_rad = frames_of(outlines);
  std::vector<Segment2> walls;
  for (CutOutline& outline : outlines) {
    outline.join(frames_rad);
    std::vector<StraightPiece> pieces;
    for (const OutlineSegment& segment : outline.segments())
      pieces.push_back(outline.fit(segment, frames_rad));
    for (const Segment2& side : closed_polygon(std::move(pieces))) {
      walls.push_back({plan.T_world_plan * Vec2(plan.cell_m * side.start),
                       plan.T_world_plan * Vec2(plan.cell_m * side.end)});
    }
  }
  return walls;
}

}  // namespace aisle
