#include <algorithm>
#include <cmath>
#include <vector>

#include "aisle/vision/check/image_evidence.hpp"
#include "aisle/vision/lines/line_follower.hpp"
#include "check/floor_against_edges.hpp"

namespace aisle {
namespace {

constexpr int kThumbWidth_px = 32, kThumbHeight_px = 24;
constexpr double kAlikeMin = 0.9;    // correlation of two images in a row
constexpr double kStayedMax = 0.05;  // how far an edge may go between them, of the width

/// Correlation of two images' grey levels, coarsely; 0 if one of them is of one tone.
double coarse_correlation(const Image& a, const Image& b) {
  const Image one = shrunk(a, kThumbWidth_px, kThumbHeight_px),
              other = shrunk(b, kThumbWidth_px, kThumbHeight_px);
  const auto n = static_cast<double>(one.bytes.size());
  double sum_a = 0, sum_b = 0;
  for (std::size_t i = 0; i < one.bytes.size(); ++i) {
    sum_a += one.bytes[i];
    sum_b += other.bytes[i];
  }
  double aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < one.bytes.size(); ++i) {
    const double x = one.bytes[i] - sum_a / n, y = other.bytes[i] - sum_b / n;
    aa += x * x;
    bb += y * y;
    ab += x * y;
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

bool stayed(const std::optional<BaseLine>& before, const std::optional<BaseLine>& now, int width_px) {
  return before && now && apart_px(*before, *now) < kStayedMax * width_px;
}

}  // namespace

std::optional<PairEvidence> PairExaminer::take(const Image& image, const FoundLines& lines,
                                               const Image& floor) {
  Seen now{to_grey(image), lines, floor};
  std::optional<PairEvidence> pair;
  if (before_ && before_->grey.width_px == image.width_px && before_->grey.height_px == image.height_px) {
    pair.emplace();
    pair->is_alike = coarse_correlation(before_->grey, now.grey) >= kAlikeMin;
    const BaseLines &old_edges = before_->lines.base_lines, &edges = lines.base_lines;
    pair->left_came = old_edges.left || edges.left;
    pair->right_came = old_edges.right || edges.right;
    pair->left_stayed = stayed(old_edges.left, edges.left, image.width_px);
    pair->right_stayed = stayed(old_edges.right, edges.right, image.width_px);
    LineFollower follower;
    const std::vector<int> before = follower.follow(before_->grey, before_->lines.verticals);
    const std::vector<int> numbers = follower.follow(now.grey, lines.verticals);
    pair->verticals = static_cast<int>(numbers.size());
    for (const int number : numbers)
      pair->followed += static_cast<int>(std::find(before.begin(), before.end(), number) != before.end());
    pair->floor_overlap = overlap_of(before_->floor, floor);
  }
  before_ = std::move(now);
  return pair;
}

}  // namespace aisle
