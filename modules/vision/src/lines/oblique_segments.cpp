#include "lines/oblique_segments.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {

namespace {

constexpr int kBandRows = 2;
constexpr double kContrastMin = 4;  // grey levels
constexpr double kSlopeMax = 1.02;  // a little over 1: no direction falls between the two passes
constexpr double kSlopeMin = 0.09;  // 5 degrees
constexpr double kStray_px = 1.2;
constexpr double kStraight_px = 0.9;
constexpr double kGapMax_px = 8;
constexpr double kSegmentFillMin = 0.7;
constexpr double kLengthMin_px = 9;
constexpr int kHalvedFrom_px = 500;  // wide; smaller images are not halved
constexpr int kSmallestSearched_px = 16;

}  // namespace

void ObliqueSegmentFinder::find(const Image& grey, std::vector<EdgeSegment>& segments) {
  segments.clear();
  halve(grey);
  if (small_.width_px < kSmallestSearched_px || small_.height_px < kSmallestSearched_px) return;
  add_segments(small_, false, segments);
  add_segments(transposed_, true, segments);
}

void ObliqueSegmentFinder::halve(const Image& grey) {
  shrink_ = grey.width_px >= kHalvedFrom_px ? 2 : 1;
  const int width = grey.width_px / shrink_, height = grey.height_px / shrink_;
  if (small_.width_px != width || small_.height_px != height) {
    small_ = Image(width, height);
    transposed_ = Image(height, width);
  }
  for (int v = 0; v < height; ++v) {
    const std::uint8_t* upper = grey.row(v * shrink_);
    const std::uint8_t* lower = grey.row(v * shrink_ + shrink_ - 1);
    std::uint8_t* out = small_.row(v);
    for (int u = 0; u < width; ++u) {
      const int left = u * shrink_, right = left + shrink_ - 1;
      out[u] = static_cast<std::uint8_t>((upper[left] + upper[right] + lower[left] + lower[right] + 2) / 4);
    }
  }
  for (int u = 0; u < width; ++u) {
    std::uint8_t* out = transposed_.row(u);
    for (int v = 0; v < height; ++v) out[v] = small_.row(v)[u];
  }
}

void ObliqueSegmentFinder::add_segments(const Image& image, bool transposed,
                                        std::vector<EdgeSegment>& segments) {
  linker_.link(image, {kBandRows, kContrastMin, kStray_px, kSlopeMax, kSlopeMax});
  PieceParams piece;
  piece.band_rows = kBandRows;
  piece.straight_px = kStraight_px;
  piece.slope_max = kSlopeMax;
  piece.gap_max_px = kGapMax_px;
  piece.fade_share = 0;
  cutter_.cut(linker_, piece, lines_);
  for (const UprightLine& line : lines_) {
    if (std::abs(line.slope) < kSlopeMin || line.length_px() < kLengthMin_px || line.fill < kSegmentFillMin)
      continue;
    Vec2 top(line.u_at(line.v_top_px), line.v_top_px), bottom(line.u_at(line.v_bottom_px), line.v_bottom_px);
    double contrast = line.step == Step::kBrighter ? line.contrast : -line.contrast;
    if (transposed) {
      top = Vec2(top.y(), top.x());
      bottom = Vec2(bottom.y(), bottom.x());
    } else if (line.slope > 0) {
      contrast = -contrast;  // the right side of a line that leans to the right is above it
    }
    const auto enlarged = [this](const Vec2& p) {
      return Vec2(((p.array() + 0.5) * shrink_ - 0.5).matrix());
    };
    EdgeSegment segment{enlarged(top), enlarged(bottom), contrast};
    if (segment.left_px.x() > segment.right_px.x()) std::swap(segment.left_px, segment.right_px);
    segments.push_back(segment);
  }
}

}  // namespace aisle
