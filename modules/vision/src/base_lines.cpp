#include "aisle/vision/base_lines.hpp"

#include <algorithm>
#include <cmath>

#include "oblique_segments.hpp"
#include "side_view.hpp"
#include "vanishing_point.hpp"
#include "wall_foot_search.hpp"
#include "working_picture.hpp"

namespace aisle {

void BaseLineParams::describe(FieldList& fields) {
  fields.count("width_max_px", width_max_px, {64, 4096}, "wider pictures are shrunk to this");
  fields.real("score_min", score_min, {0, 10}, "a line less supported is none");
  fields.real("foot_share", foot_share, {0, 0.5},
              "a foot is no farther than this from its base line, as a share of the height");
  fields.real("standing_share_min", standing_share_min, {0, 1},
              "shortest vertical line that remains without its reflection, as a share of the height");
}

namespace {

constexpr int kSmallest_px = 32;  // pictures smaller than this show no corridor

}  // namespace

class BaseLineDetector::Work {
 public:
  Work(const BaseLineParams& params, const std::optional<CameraModel>& camera)
      : params_(params), picture_(params.width_max_px, camera) {}

  BaseLines detect(const Image& grey, std::span<const VerticalLine> verticals) {
    picture_.look_at(grey);
    BaseLines lines;
    if (picture_.width_px() < kSmallest_px || picture_.height_px() < kSmallest_px) return lines;
    segment_finder_.find(picture_.grey(), segments_);
    const auto point_px = point_finder_.find(segments_, picture_.width_px(), picture_.height_px());
    if (!point_px) return lines;
    lines.vanishing_point_px = picture_.given(*point_px);
    lines.left = base_line({picture_.grey(), true}, *point_px, verticals);
    lines.right = base_line({picture_.grey(), false}, *point_px, verticals);
    return lines;
  }

 private:
  std::optional<BaseLine> base_line(const SideView& view, const Vec2& point_px,
                                    std::span<const VerticalLine> verticals) {
    turn_segments(view);
    turn_verticals(view, verticals);
    const auto foot = search_.find(view, view.turned(point_px), side_segments_, side_verticals_);
    if (!foot || foot->score() < params_.score_min) return std::nullopt;
    return as_seen(*foot, view);
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
      const auto top_px = picture_.working(line.top_px), bottom_px = picture_.working(line.bottom_px);
      if (!top_px || !bottom_px) continue;
      const double length = (bottom_px->y() - top_px->y()) / (0.3 * view.height_px());
      const double weight = std::min(1.0, length) * std::min(1.0, std::abs(line.contrast) / 25);
      side_verticals_.push_back({view.turned(*top_px), view.turned(*bottom_px), weight});
    }
  }

  BaseLine as_seen(const WallFoot& foot, const SideView& view) const {
    const double border_px = std::min((view.width_px() - 1 - foot.point_px.x()) / foot.direction.x(),
                                      (view.height_px() - 1 - foot.point_px.y()) / foot.direction.y());
    BaseLine line;
    const int pieces = picture_.bends_lines() ? 8 : 1;
    for (int i = 0; i <= pieces; ++i) {
      const double along = foot.from_px + (border_px - foot.from_px) * i / pieces;
      const auto point_px = picture_.given(view.turned(foot.point_px + along * foot.direction));
      if (point_px) line.push_back(*point_px);
    }
    return line;
  }

  BaseLineParams params_;
  WorkingPicture picture_;
  ObliqueSegmentFinder segment_finder_;
  VanishingPointFinder point_finder_;
  WallFootSearch search_;
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
