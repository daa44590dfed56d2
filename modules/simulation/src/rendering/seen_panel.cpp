#include "rendering/seen_panel.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "rendering/kernel.hpp"

namespace aisle {
namespace {

constexpr double kNearestSeen_m = 1e-4;  ///< what is nearer to the lens is not seen

/// Nearness times this counts as equal: panels in one plane differ by rounding.
constexpr float kSamePlace = 1 - 1e-5f;

/// Bounds of a panel's part ahead of the camera.
class PanelOutline {
 public:
  explicit PanelOutline(const Corners& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3 &from = corners[i], &to = corners[(i + 1) % corners.size()];
      if (from.z() >= kNearestSeen_m) add(from);
      if ((from.z() >= kNearestSeen_m) != (to.z() >= kNearestSeen_m)) {
        add(from + (kNearestSeen_m - from.z()) / (to.z() - from.z()) * (to - from));
      }
    }
  }

  bool is_ahead() const { return nearest_ > 0; }
  double nearest() const { return nearest_; }

  SlopeBox bounds() const {
    constexpr double kRounding = 1e-6;
    const Vec2 middle = (min_ + max_) / 2, half = (1 + kRounding) * (max_ - min_) / 2;
    return {static_cast<float>(middle.x()), static_cast<float>(middle.y()),
            static_cast<float>(half.x() + kRounding), static_cast<float>(half.y() + kRounding)};
  }

 private:
  void add(const Vec3& p_camera) {
    const double nearness = 1 / p_camera.z();
    const Vec2 slopes = p_camera.head<2>() * nearness;
    min_ = min_.cwiseMin(slopes);
    max_ = max_.cwiseMax(slopes);
    nearest_ = std::max(nearest_, nearness);
  }

  Vec2 min_ = Vec2::Constant(std::numeric_limits<double>::max()), max_ = -min_;
  double nearest_ = 0;
};

/// Values of a x + b y + c over a box: in its middle, and how much they rise from there at most.
struct ValueRange {
  float middle, rise;
};

inline ValueRange over(const SlopeBox& box, float a, float b, float c) {
  return {a * box.x + b * box.y + c, std::abs(a) * box.half_x + std::abs(b) * box.half_y};
}

inline bool overlap(const SlopeBox& one, const SlopeBox& other) {
  return std::abs(one.x - other.x) <= one.half_x + other.half_x &&
         std::abs(one.y - other.y) <= one.half_y + other.half_y;
}

}  // namespace

std::optional<SeenPanel> seen_panel(const Corners& corners, const Viewpoint& view, std::uint32_t number) {
  Corners p_camera;
  const Mat3 R_camera_scene = view.R_scene_camera.cast<double>().transpose();
  const Vec3 p_scene_camera = view.p_scene_camera.cast<double>();
  for (std::size_t i = 0; i < 4; ++i) p_camera[i] = R_camera_scene * (corners[i] - p_scene_camera);
  const PanelOutline outline(p_camera);
  if (!outline.is_ahead()) return std::nullopt;

  const Vec3 normal = (p_camera[2] - p_camera[0]).cross(p_camera[3] - p_camera[1]);
  const double distance = normal.dot(p_camera[0]);
  constexpr double kEdgeOn = 1e-9;
  if (std::abs(distance) < kEdgeOn) return std::nullopt;

  SeenPanel panel;
  const double side = distance > 0 ? 1 : -1;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 edge = side * p_camera[i].cross(p_camera[(i + 1) % 4]);
    panel.edge_a[i] = static_cast<float>(edge.x());
    panel.edge_b[i] = static_cast<float>(edge.y());
    panel.edge_c[i] = static_cast<float>(edge.z());
  }
  const Vec3 nearness = normal / distance;
  panel.near_a = static_cast<float>(nearness.x());
  panel.near_b = static_cast<float>(nearness.y());
  panel.near_c = static_cast<float>(nearness.z());
  panel.nearest = static_cast<float>(outline.nearest());
  panel.bounds = outline.bounds();
  panel.number = number;
  return panel;
}

void narrow(std::vector<Candidate>& candidates, std::size_t begin, std::size_t end, const SlopeBox& beam) {
  float covered = 0;  // up to this nearness, by a panel that all rays meet
  for (std::size_t i = begin; i < end; ++i) {
    const SeenPanel& panel = *candidates[i].panel;
    if (!overlap(panel.bounds, beam)) continue;
    bool is_outside = false, covers = true;
    for (std::size_t edge = 0; edge < 4; ++edge) {
      const ValueRange inside = over(beam, panel.edge_a[edge], panel.edge_b[edge], panel.edge_c[edge]);
      is_outside |= inside.middle + inside.rise < 0;
      covers &= inside.middle - inside.rise >= 0;
    }
    if (is_outside) continue;
    const ValueRange nearness = over(beam, panel.near_a, panel.near_b, panel.near_c);
    const float nearest = std::min(nearness.middle + nearness.rise, panel.nearest);
    if (nearest < covered) continue;
    if (covers) covered = std::max(covered, kSamePlace * (nearness.middle - nearness.rise));
    candidates.push_back({&panel, nearest, covers});
  }
  const auto added = candidates.begin() + static_cast<std::ptrdiff_t>(end);
  candidates.erase(std::remove_if(added, candidates.end(),
                                  [&](const Candidate& candidate) { return candidate.nearest < covered; }),
                   candidates.end());
}

AISLE_KERNEL
void find_seen(std::span<const Candidate> candidates, const Floats& x, const Floats& y, Hits& seen) {
  Floats nearest{};
  for (std::uint32_t& hit : seen.at) hit = kNoSurface;
  for (std::uint32_t i = 0; i < candidates.size(); ++i) {
    const SeenPanel panel = *candidates[i].panel;
    for (int k = 0; k < kLanes; ++k) {
      const auto inside = [&](std::size_t edge) {
        return panel.edge_a[edge] * x.at[k] + panel.edge_b[edge] * y.at[k] + panel.edge_c[edge] >= 0;
      };
      const float nearness = panel.near_a * x.at[k] + panel.near_b * y.at[k] + panel.near_c;
      const bool is_seen =
          inside(0) & inside(1) & inside(2) & inside(3) & (nearness > kSamePlace * nearest.at[k]);
      nearest.at[k] = is_seen ? nearness : nearest.at[k];
      seen.at[k] = is_seen ? i : seen.at[k];
    }
  }
}

AISLE_KERNEL
bool find_coverage(std::uint32_t candidate, std::span<const Hits> seen, std::span<const PixelOffset> samples,
                   Coverage& coverage) {
  Floats count{}, sum_u{}, sum_v{};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Hits& hits = seen[i];
    const PixelOffset offset = samples[i];
    for (int k = 0; k < kLanes; ++k) {
      const float hit = hits.at[k] == candidate ? 1.0f : 0.0f;
      count.at[k] += hit;
      sum_u.at[k] += hit * offset.u;
      sum_v.at[k] += hit * offset.v;
    }
  }
  std::int32_t any = 0;
  for (int k = 0; k < kLanes; ++k) {
    const float per_count = 1 / (count.at[k] > 0 ? count.at[k] : 1);
    coverage.any.at[k] = count.at[k] > 0 ? -1 : 0;
    coverage.share.at[k] = count.at[k] / static_cast<float>(samples.size());
    coverage.u.at[k] = sum_u.at[k] * per_count;
    coverage.v.at[k] = sum_v.at[k] * per_count;
    any |= coverage.any.at[k];
  }
  return any != 0;
}

}  // namespace aisle
