#include "aisle/vision/floor/base_lines.hpp"

#include <algorithm>
#include <cmath>

#include "floor/floor_cells.hpp"
#include "floor/side_view.hpp"
#include "floor/wall_floor_edge_refinement.hpp"
#include "floor/wall_floor_edge_search.hpp"
#include "lines/oblique_segments.hpp"
#include "lines/vanishing_point.hpp"
#include "working_image.hpp"

namespace aisle {

void BaseLineParams::describe(FieldList& fields) {
  fields.count("width_max_px", width_max_px, {64, 4096}, "wider images are shrunk to this");
  fields.real("score_min", score_min, {0, 10}, "a line with a lower score is not used");
  fields.real("floor_point_share", floor_point_share, {0, 0.5},
              "a floor point is no farther than this from its base line, as a share of the height");
  fields.real("standing_share_min", standing_share_min, {0, 1},
              "shortest vertical line that remains without its reflection, as a share of the height");
}

namespace {

constexpr double kFarEnd = 0.06;      // a line is drawn to this share of the width before the vanishing point
constexpr int kSmallestView_px = 32;  // images smaller than this show no corridor

}  // namespace

class BaseLineDetector::Work {
 public:
  Work(const BaseLineParams& params, const std::optional<CameraModel>& camera)
      : params_(params), image_(params.width_max_px, camera) {}

  BaseLines detect(const Image& grey, std::span<const VerticalLine> verticals) {
    image_.look_at(grey);
    BaseLines lines;
    if (image_.width_px() < kSmallestView_px || image_.height_px() < kSmallestView_px) return lines;
    segment_finder_.find(image_.grey(), segments_);
    const auto point_px = point_finder_.find(segments_, image_.width_px(), image_.height_px());
    if (!point_px) return lines;
    lines.vanishing_point_px = image_.given(*point_px);
    floor_.find(image_.grey());
    lines.left = base_line({image_.grey(), true}, *point_px, verticals);
    lines.right = base_line({image_.grey(), false}, *point_px, verticals);
    return lines;
  }

 private:
  std::optional<BaseLine> base_line(const SideView& view, const Vec2& point_px,
                                    std::span<const VerticalLine> verticals) {
    turn_segments(view);
    turn_verticals(view, verticals);
    const Vec2 side_point_px = view.turned(point_px);
    const SideScene scene{view, side_point_px, side_verticals_, floor_};
    auto edge = search_.find(scene, side_segments_, params_.score_min);
    if (!edge) return std::nullopt;
    refinement_.refine(view, far_px(*edge, side_point_px), border_px(*edge), *edge);
    return as_seen(*edge, view, side_point_px);
  }

  /// Distance along the edge, from its point, at which it begins ...
  double far_px(const WallFloorEdge& edge, const Vec2& point_px) const {
    return std::min(edge.from_px, edge.direction.dot(point_px - edge.point_px) + kFarEnd * image_.width_px());
  }
  /// ... and where it leaves the image.
  double border_px(const WallFloorEdge& edge) const {
    return std::min((image_.width_px() - 1 - edge.point_px.x()) / edge.direction.x(),
                    (image_.height_px() - 1 - edge.point_px.y()) / edge.direction.y());
  }

  void turn_segments(const SideView& view) {
    side_segments_ = segments_;
    if (!view.mirrored()) return;
    for (EdgeSegment& segment : side_segments_) {
      const Vec2 left_px = view.turned(segment.right_px);
      segment.right_px = view.turned(segment.left_px);
      segment.left_px = left_px;
    }
  }

  void turn_verticals(const SideView& view, std::span<const VerticalLine> verticals) {
    side_verticals_.clear();
    for (const VerticalLine& line : verticals) {
      const auto top_px = image_.working(line.top_px), bottom_px = image_.working(line.bottom_px);
      if (!top_px || !bottom_px) continue;
      const double length = (bottom_px->y() - top_px->y()) / (0.3 * view.height_px());
      const double weight = std::min(1.0, length) * std::min(1.0, std::abs(line.contrast) / 25);
      side_verticals_.push_back({view.turned(*top_px), view.turned(*bottom_px), weight});
    }
    std::sort(
        side_verticals_.begin(), side_verticals_.end(), [](const SideVertical& a, const SideVertical& b) {
          return std::pair(a.bottom_px.x(), a.bottom_px.y()) < std::pair(b.bottom_px.x(), b.bottom_px.y());
        });
  }

  BaseLine as_seen(const WallFloorEdge& edge, const SideView& view, const Vec2& point_px) const {
    const double from_px = far_px(edge, point_px), to_px = border_px(edge);
    const int pieces = image_.bends_lines() ? 8 : 1;
    BaseLine line;
    for (int i = 0; i <= pieces; ++i) {
      const double along_px = from_px + (to_px - from_px) * i / pieces;
      const auto seen_px = image_.given(view.turned(edge.point_px + along_px * edge.direction));
      if (seen_px) line.push_back(*seen_px);
    }
    return line;
  }

  BaseLineParams params_;
  WorkingImage image_;
  ObliqueSegmentFinder segment_finder_;
  VanishingPointFinder point_finder_;
  FloorCells floor_;
  WallFloorEdgeSearch search_;
  WallFloorEdgeRefinement refinement_;
  std::vector<EdgeSegment> segments_;
  std::vector<EdgeSegment> side_segments_;
  std::vector<SideVertical> side_verticals_;
};

BaseLineDetector::BaseLineDetector(const BaseLineParams& params, const std::optional<CameraModel>& camera)
    : work_(std::make_unique<Work>(params, camera)) {}
BaseLineDetector::BaseLineDetector(BaseLineDetector&&) noexcept = default;
BaseLineDetector::~BaseLineDetector() = default;

BaseLines BaseLineDetector::detect(const Image& grey, std::span<const VerticalLine> verticals) {
  return work_->detect(grey, verticals);
}

}  // namespace aisle
