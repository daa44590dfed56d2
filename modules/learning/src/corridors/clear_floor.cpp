#include "corridors/clear_floor.hpp"

#include <algorithm>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace aisle {
namespace {

constexpr double kNearStart_m = 1;

}  // namespace

ClearFloor::ClearFloor(const FloorGrid& floor)
    : box_(floor.known().widened(1)),
      columns_(box_.end.x - box_.low.x),
      rows_(box_.end.y - box_.low.y),
      cell_m_(floor.cell_m()) {
  cv::Mat is_free(rows_, columns_, CV_8U);
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const FloorCell cell{box_.low.x + column, box_.low.y + row};
      is_free.at<std::uint8_t>(row, column) = floor.at(cell) == Floor::kFree;
    }
  }
  cv::Mat distance;
  cv::distanceTransform(is_free, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  clearance_m_.reserve(distance.total());
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const double cells = std::max(0.0, static_cast<double>(distance.at<float>(row, column)) - 0.5);
      clearance_m_.push_back(static_cast<float>(cells * cell_m_));
    }
  }
}

Vec2 ClearFloor::centre(std::size_t cell) const {
  return cell_m_ * Vec2(box_.low.x + column_of(cell) + 0.5, box_.low.y + row_of(cell) + 0.5);
}

std::vector<bool> ClearFloor::reached_from(const Vec2& p_map, double clearance_min_m) const {
  std::vector<bool> is_reached(size(), false);
  std::optional<std::size_t> nearest;
  double nearest_m = kNearStart_m;
  for (std::size_t cell = 0; cell < size(); ++cell) {
    const double distance_m = (centre(cell) - p_map).norm();
    if (clearance_m(cell) < clearance_min_m || distance_m > nearest_m) continue;
    nearest = cell;
    nearest_m = distance_m;
  }
  if (!nearest) return is_reached;
  // The outermost cells are not free, so there is a neighbour on every side.
  const auto columns = static_cast<std::size_t>(columns_);
  std::vector<std::size_t> open = {*nearest};
  is_reached[*nearest] = true;
  while (!open.empty()) {
    const std::size_t cell = open.back();
    open.pop_back();
    for (const std::size_t next : {cell + 1, cell - 1, cell + columns, cell - columns}) {
      if (is_reached[next] || clearance_m(next) < clearance_min_m) continue;
      is_reached[next] = true;
      open.push_back(next);
    }
  }
  return is_reached;
}

}  // namespace aisle
