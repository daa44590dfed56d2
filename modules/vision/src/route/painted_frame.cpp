#include "aisle/vision/route/painted_frame.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr double kBin_m = 0.03;
constexpr int kSideBins = 12;
constexpr std::size_t kFramePointsMin = 48;  // about one in each of four sides' bins

/// The sides: ahead, back, left, right. Their outward normals in `frame`.
constexpr std::array<std::array<double, 2>, 4> kNormals = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

double half_m(const Vec2& size_m, std::size_t side) {
  return (side < 2 ? size_m.x() : size_m.y()) / 2;
}
double reach_m(const Vec2& size_m, std::size_t side) {
  return (side < 2 ? size_m.y() : size_m.x()) / 2;
}
double off_m(const Vec2& p_frame, const Vec2& size_m, std::size_t side) {
  return kNormals[side][0] * p_frame.x() + kNormals[side][1] * p_frame.y() - half_m(size_m, side);
}
double along_m(const Vec2& p_frame, std::size_t side) {
  return side < 2 ? p_frame.y() : p_frame.x();
}

/// The side that a point lies on, if it lies on one.
std::optional<std::size_t> side_of(const Vec2& p_frame, const Vec2& size_m, double near_m) {
  std::optional<std::size_t> nearest;
  for (std::size_t side = 0; side < 4; ++side) {
    const double gap_m = std::abs(off_m(p_frame, size_m, side));
    if (gap_m > near_m || std::abs(along_m(p_frame, side)) > reach_m(size_m, side) + near_m) continue;
    near_m = gap_m;
    nearest = side;
  }
  return nearest;
}

/// Gauss-Newton over the pose, and the size if it is free, of points near the sides.
void refine(std::span<const Vec2> p_vehicle, double near_m, bool size_is_free, FrameFit& fit) {
  using Vec5 = Eigen::Matrix<double, 5, 1>;
  using Mat5 = Eigen::Matrix<double, 5, 5>;
  Mat5 normal = Mat5::Identity() * 1e-9;
  Vec5 right = Vec5::Zero();
  if (!size_is_free) normal(3, 3) = normal(4, 4) = 1;
  const Pose2 T_frame_vehicle = fit.T_vehicle_frame.inverse();
  for (const Vec2& p : p_vehicle) {
    const Vec2 q = T_frame_vehicle * p;
    const auto side = side_of(q, fit.size_m, near_m);
    if (!side) continue;
    const Vec2 n(kNormals[*side][0], kNormals[*side][1]);
    // The frame moves by (x, y) in its own axes and turns by theta: points move the other way.
    Vec5 by;
    by << -n.x(), -n.y(), n.x() * q.y() - n.y() * q.x(), 0, 0;
    if (size_is_free) by(*side < 2 ? 3 : 4) = -0.5;
    const double off = off_m(q, fit.size_m, *side);
    normal += by * by.transpose();
    right -= by * off;
  }
  const Vec5 step = normal.ldlt().solve(right);
  fit.T_vehicle_frame = fit.T_vehicle_frame * Pose2{step(0), step(1), step(2)};
  if (size_is_free) fit.size_m += Vec2(step(3), step(4));
}

/// How many of a side's bins points lie on.
std::array<int, 4> covered_bins(std::span<const Vec2> p_vehicle, double near_m, FrameFit& fit) {
  std::array<std::array<bool, kSideBins>, 4> is_covered{};
  const Pose2 T_frame_vehicle = fit.T_vehicle_frame.inverse();
  double squares = 0;
  int count = 0;
  for (const Vec2& p : p_vehicle) {
    const Vec2 q = T_frame_vehicle * p;
    const auto side = side_of(q, fit.size_m, near_m);
    if (!side) continue;
    squares += square(off_m(q, fit.size_m, *side));
    ++count;
    const double share = 0.5 + along_m(q, *side) / (2 * reach_m(fit.size_m, *side));
    is_covered[*side]
              [static_cast<std::size_t>(std::clamp(static_cast<int>(share * kSideBins), 0, kSideBins - 1))] =
                  true;
  }
  fit.rms_m = count > 0 ? std::sqrt(squares / count) : 0;
  std::array<int, 4> bins{};
  for (std::size_t side = 0; side < 4; ++side)
    bins[side] = static_cast<int>(std::count(is_covered[side].begin(), is_covered[side].end(), true));
  return bins;
}

void count_sides(std::span<const Vec2> p_vehicle, const PaintedFrameParams& params, FrameFit& fit) {
  const auto bins = covered_bins(p_vehicle, params.near_line_m, fit);
  fit.sides = static_cast<int>(
      std::count_if(bins.begin(), bins.end(), [&](int n) { return n >= params.covered_share * kSideBins; }));
}

/// Where points lie along an axis: counts by bins, smoothed.
class AxisCounts {
 public:
  AxisCounts(std::span<const Vec2> points, double heading_rad, double range_m)
      : low_m_(-range_m), counts_(static_cast<std::size_t>(2 * range_m / kBin_m) + 3, 0.0) {
    const Vec2 axis = unit(heading_rad);
    for (const Vec2& p : points) {
      const auto bin = static_cast<std::ptrdiff_t>((p.dot(axis) - low_m_) / kBin_m);
      for (std::ptrdiff_t i = bin - 1; i <= bin + 1; ++i)
        if (i >= 0 && i < static_cast<std::ptrdiff_t>(counts_.size()))
          counts_[static_cast<std::size_t>(i)] += i == bin ? 2 : 1;
    }
  }

  /// The middle between the two lines at a given distance that have most points, and how many these are.
  std::pair<double, double> best_pair(double apart_m) const {
    const auto apart = static_cast<std::size_t>(std::lround(apart_m / kBin_m));
    double best = -1, at_m = 0;
    for (std::size_t i = 0; i + apart < counts_.size(); ++i) {
      const double both = std::min(counts_[i], 200.0) + std::min(counts_[i + apart], 200.0);
      if (both <= best) continue;
      best = both;
      at_m = low_m_ + (static_cast<double>(i) + 0.5 + static_cast<double>(apart) / 2) * kBin_m;
    }
    return {at_m, best};
  }

 private:
  double low_m_;
  std::vector<double> counts_;
};

FrameFit settled(std::span<const Vec2> p_vehicle, const Vec2& size_m, const Pose2& T_vehicle_frame,
                 const PaintedFrameParams& params, bool size_is_free) {
  FrameFit fit{.T_vehicle_frame = T_vehicle_frame, .size_m = size_m};
  for (const double wider : {3.0, 2.0, 1.5, 1.0, 1.0})
    refine(p_vehicle, wider * params.near_line_m, size_is_free, fit);
  count_sides(p_vehicle, params, fit);
  return fit;
}

/// The points' counts for every heading that the frame may have.
class HeadingVotes {
 public:
  HeadingVotes(std::span<const Vec2> p_vehicle, double expected_heading_rad,
               const PaintedFrameParams& params) {
    constexpr double kHeadingStep_rad = 1.5 * kDegree;
    const int steps = static_cast<int>(params.heading_reach_rad / kHeadingStep_rad);
    headings_.reserve(static_cast<std::size_t>(2 * steps) + 1);
    for (int i = -steps; i <= steps; ++i) {
      const double heading_rad = expected_heading_rad + i * kHeadingStep_rad;
      headings_.push_back({heading_rad, AxisCounts(p_vehicle, heading_rad, params.range_m),
                           AxisCounts(p_vehicle, heading_rad + kPi / 2, params.range_m)});
    }
  }

  /// The frame of this size whose two pairs of parallel lines have most points.
  Pose2 most_voted(const Vec2& size_m) const {
    Pose2 T_vehicle_frame;
    double most = -1;
    for (const Heading& heading : headings_) {
      const auto [x_m, x_votes] = heading.along.best_pair(size_m.x());
      const auto [y_m, y_votes] = heading.across.best_pair(size_m.y());
      if (x_votes + y_votes <= most) continue;
      most = x_votes + y_votes;
      const Vec2 p = rotate(heading.heading_rad, {x_m, y_m});
      T_vehicle_frame = {p.x(), p.y(), heading.heading_rad};
    }
    return T_vehicle_frame;
  }

 private:
  struct Heading {
    double heading_rad;
    AxisCounts along, across;
  };
  std::vector<Heading> headings_;
};

}  // namespace

void PaintedFrameParams::describe(FieldList& fields) {
  fields.real("contrast", contrast, {0.01, 2}, "by which share a painted line is brighter than the floor");
  fields.real("line_m", line_m, {0.01, 0.5}, "approximate width of a painted line");
  fields.real("range_m", range_m, {0.5, 50}, "farther lines are not used");
  fields.angle("heading_reach_deg", heading_reach_rad, {1, 90},
               "how far the frame may be turned from the expected heading");
  fields.real("near_line_m", near_line_m, {0.005, 0.5}, "points this near a side lie on it");
  fields.real("covered_share", covered_share, {0.1, 1}, "of a side has points on it, or it is not seen");
}

std::vector<Vec2> FrameFit::corners() const {
  const Vec2 h = size_m / 2;
  return {T_vehicle_frame * Vec2(h.x(), h.y()), T_vehicle_frame * Vec2(h.x(), -h.y()),
          T_vehicle_frame * Vec2(-h.x(), -h.y()), T_vehicle_frame * Vec2(-h.x(), h.y())};
}

std::optional<FrameFit> find_frame(std::span<const Vec2> p_vehicle, const Vec2& size_m,
                                   double expected_heading_rad, const PaintedFrameParams& params) {
  constexpr int kSidesMin = 3;
  if (p_vehicle.size() < kFramePointsMin) return std::nullopt;
  const HeadingVotes votes(p_vehicle, expected_heading_rad, params);
  const FrameFit fit = settled(p_vehicle, size_m, votes.most_voted(size_m), params, false);
  return fit.sides >= kSidesMin ? std::optional(fit) : std::nullopt;
}

std::optional<FrameFit> track_frame(std::span<const Vec2> p_vehicle, const Vec2& size_m,
                                    const Pose2& T_vehicle_expected, const PaintedFrameParams& params) {
  constexpr double kGate_m = 0.15, kGate_rad = 8 * kDegree;
  constexpr int kSeenBins = 3, kCornerBins = 5;
  FrameFit fit = settled(p_vehicle, size_m, T_vehicle_expected, params, false);
  const Pose2 off = between(T_vehicle_expected, fit.T_vehicle_frame);
  if (off.position().norm() > kGate_m || std::abs(off.theta) > kGate_rad) return std::nullopt;
  const auto bins = covered_bins(p_vehicle, params.near_line_m, fit);
  const int along = std::max(bins[0], bins[1]), across = std::max(bins[2], bins[3]);
  const bool shows_corner = along >= kCornerBins && across > 0;
  return (along >= kSeenBins && across >= kSeenBins) || shows_corner ? std::optional(fit) : std::nullopt;
}

std::optional<FrameFit> find_frame_and_size(std::span<const Vec2> p_vehicle, double expected_heading_rad,
                                            const PaintedFrameParams& params) {
  constexpr double kLeast_m = 0.8, kMost_m = 3, kStep_m = 0.2;
  if (p_vehicle.size() < kFramePointsMin) return std::nullopt;
  const HeadingVotes votes(p_vehicle, expected_heading_rad, params);
  std::optional<FrameFit> best;
  const int sizes = static_cast<int>(std::lround((kMost_m - kLeast_m) / kStep_m));
  for (int i = 0; i <= sizes; ++i) {
    for (int k = 0; k <= sizes; ++k) {
      const Vec2 size_m(kLeast_m + i * kStep_m, kLeast_m + k * kStep_m);
      const FrameFit fit = settled(p_vehicle, size_m, votes.most_voted(size_m), params, true);
      if (fit.sides == 4 && (!best || fit.rms_m < best->rms_m)) best = fit;
    }
  }
  return best;
}

}  // namespace aisle
