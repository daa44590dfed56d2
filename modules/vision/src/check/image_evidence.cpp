#include "aisle/vision/check/image_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "aisle/core/median.hpp"
#include "check/floor_against_edges.hpp"

namespace aisle {
namespace {

// The second look: a feature that is there is found in four fifths of the pixels and of the light, too.
constexpr double kSecondLook = 0.8;
constexpr double kBesideEdge =
    0.025;  // how far beneath and above an edge the floor is asked for, of the width
constexpr double kSamePlace = 0.012;  // two findings of one edge, or of one vertical line, of the width
constexpr int kSmallestSecondLook_px = 32;

Image smaller_and_darker(const Image& image) {
  Image second = shrunk(image, static_cast<int>(std::lround(kSecondLook * image.width_px)),
                        static_cast<int>(std::lround(kSecondLook * image.height_px)));
  for (std::uint8_t& byte : second.bytes) byte = static_cast<std::uint8_t>(std::lround(kSecondLook * byte));
  return second;
}

/// Of the same camera's images in another size.
std::optional<CameraModel> model_of(std::optional<CameraIntrinsics> camera, double scale) {
  if (!camera) return std::nullopt;
  camera->fx_px *= scale;
  camera->fy_px *= scale;
  camera->cx_px = scale * (camera->cx_px + 0.5) - 0.5;
  camera->cy_px = scale * (camera->cy_px + 0.5) - 0.5;
  return CameraModel(*camera);
}

/// A pixel of the smaller image in the image as given; the origin is a pixel's centre.
Vec2 unshrunk_px(const Vec2& second_px, const Vec2& scale) {
  return (second_px + Vec2(0.5, 0.5)).cwiseQuotient(scale) - Vec2(0.5, 0.5);
}

double middle_column(const VerticalLine& line) {
  return (line.top_px.x() + line.bottom_px.x()) / 2;
}

/// Whether one of `others`, whose image is `scale` as large, is in a line's place.
bool has_the_same(const VerticalLine& line, const std::vector<VerticalLine>& others, const Vec2& scale,
                  double near_px) {
  const double row = (line.top_px.y() + line.bottom_px.y()) / 2;
  const double column = middle_column(line);
  return std::any_of(others.begin(), others.end(), [&](const VerticalLine& other) {
    const Vec2 top = unshrunk_px(other.top_px, scale), bottom = unshrunk_px(other.bottom_px, scale);
    if (row < top.y() || row > bottom.y()) return false;
    const double share = (row - top.y()) / (bottom.y() - top.y());
    return std::abs(top.x() + share * (bottom.x() - top.x()) - column) < near_px;
  });
}

BaseLine enlarged(BaseLine edge, const Vec2& scale) {
  for (Vec2& point : edge) point = unshrunk_px(point, scale);
  return edge;
}

EdgeEvidence edge_evidence(const std::optional<BaseLine>& edge, bool is_right, const Image& floor) {
  if (!edge) return {};
  const double beside_px = kBesideEdge * floor.width_px;
  EdgeEvidence evidence;
  evidence.is_found = true;
  evidence.floor_beneath = set_share_beside(floor, *edge, is_right, beside_px);
  evidence.wall_above = 1 - set_share_beside(floor, *edge, is_right, -beside_px);
  return evidence;
}

void note_verticals(const std::vector<VerticalLine>& lines, ImageEvidence& evidence) {
  std::vector<double> leans_rad;
  for (const VerticalLine& line : lines) {
    const double column = middle_column(line) / evidence.width_px;
    evidence.verticals_left += static_cast<int>(column < 0.5);
    evidence.standing += static_cast<int>(line.has_floor_point);
    const Vec2 up_px = line.top_px - line.bottom_px;
    if (std::abs(column - 0.5) < 1.0 / 6) leans_rad.push_back(std::atan2(up_px.x(), -up_px.y()));
  }
  evidence.verticals = static_cast<int>(lines.size());
  if (!leans_rad.empty()) evidence.lean_rad = median(std::move(leans_rad));
}

bool is_beyond(const BaseLines& edges, const Vec2& point_px) {
  return (edges.left && floor_side_px(*edges.left, false, point_px) < 0) ||
         (edges.right && floor_side_px(*edges.right, true, point_px) < 0);
}

void note_floor(const Image& floor, const BaseLines& edges, ImageEvidence& evidence) {
  std::size_t set = 0, left = 0, above = 0, beyond = 0;
  const double end_row = edges.vanishing_point_px ? edges.vanishing_point_px->y() : 0;
  int top = floor.height_px;
  for (int v = 0; v < floor.height_px; ++v) {
    for (int u = 0; u < floor.width_px; ++u) {
      if (floor.row(v)[u] == 0) continue;
      top = std::min(top, v);
      ++set;
      above += static_cast<std::size_t>(v < end_row);
      left += static_cast<std::size_t>(2 * u < floor.width_px);
      beyond += static_cast<std::size_t>(is_beyond(edges, {u, v}));
    }
  }
  evidence.floor_top = static_cast<double>(top) / floor.height_px;
  if (set == 0) return;
  const auto share = [](std::size_t part, std::size_t of) {
    return static_cast<double>(part) / static_cast<double>(of);
  };
  evidence.floor_share = share(set, floor.bytes.size());
  evidence.floor_left_share = share(left, set);
  evidence.floor_above_end = share(above, set);
  evidence.floor_beyond_edges = share(beyond, set);
}

bool is_near(const std::optional<BaseLine>& a, const std::optional<BaseLine>& b, double near_px) {
  return a && b && apart_px(*a, *b) < near_px;
}

}  // namespace

ImageExaminer::ImageExaminer(const std::optional<CameraIntrinsics>& camera)
    : finder_({}, model_of(camera, 1)), second_finder_({}, model_of(camera, kSecondLook)) {}

ImageEvidence ImageExaminer::examine(const Image& image) {
  Image converted;
  const Image& grey = as_grey(image, converted);
  ImageEvidence evidence;
  evidence.width_px = image.width_px;
  evidence.height_px = image.height_px;
  evidence.quality = image_quality(grey);
  lines_ = finder_.find(grey);
  floor_finder_.find(image, floor_);
  const BaseLines& edges = lines_.base_lines;
  evidence.left = edge_evidence(edges.left, false, floor_);
  evidence.right = edge_evidence(edges.right, true, floor_);
  if (edges.vanishing_point_px)
    evidence.vanishing_point = edges.vanishing_point_px->cwiseQuotient(Vec2(image.width_px, image.height_px));
  note_verticals(lines_.verticals, evidence);
  note_floor(floor_, edges, evidence);
  compare_with_smaller_and_darker(image, evidence);
  return evidence;
}

void ImageExaminer::compare_with_smaller_and_darker(const Image& image, ImageEvidence& evidence) {
  if (std::min(image.width_px, image.height_px) * kSecondLook < kSmallestSecondLook_px) return;
  const Image second = smaller_and_darker(image);
  const Vec2 scale(static_cast<double>(second.width_px) / image.width_px,
                   static_cast<double>(second.height_px) / image.height_px);
  const double near_px = kSamePlace * image.width_px;
  FoundLines found = second_finder_.find(second);
  for (auto* edge : {&found.base_lines.left, &found.base_lines.right})
    if (*edge) *edge = enlarged(std::move(**edge), scale);
  evidence.left.is_found_again = is_near(lines_.base_lines.left, found.base_lines.left, near_px);
  evidence.right.is_found_again = is_near(lines_.base_lines.right, found.base_lines.right, near_px);
  for (const VerticalLine& line : lines_.verticals)
    evidence.found_again += static_cast<int>(has_the_same(line, found.verticals, scale, near_px));
  Image floor;
  floor_finder_.find(second, floor);
  evidence.floor_overlap = overlap_of(shrunk(floor_, second.width_px, second.height_px), floor);
}

}  // namespace aisle
