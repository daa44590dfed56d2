#include "aisle/simulation/paths/clearance_grid.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "aisle/geometry/box2.hpp"

namespace aisle {
namespace {

constexpr double kClearanceCellsMax = 8e6;
constexpr double kHalfDiagonal = 0.7072;  ///< cells: how far an obstacle may be from the middle of its cell

}  // namespace

ClearanceGrid::ClearanceGrid(std::span<const Segment2> obstacles, double cell_m) : cell_m_(cell_m) {
  if (obstacles.empty()) throw std::invalid_argument("ClearanceGrid: no obstacles");
  const Box2 box = box_around(obstacles);
  const Vec2 span = box.sizes() + Vec2::Constant(4 * cell_m);
  cell_m_ = std::max(cell_m, std::sqrt(span.x() * span.y() / kClearanceCellsMax));
  corner_ = box.min() - Vec2::Constant(2 * cell_m_);
  columns_ = static_cast<int>(std::ceil((box.max().x() - corner_.x()) / cell_m_)) + 2;
  rows_ = static_cast<int>(std::ceil((box.max().y() - corner_.y()) / cell_m_)) + 2;

  cv::Mat free(rows_, columns_, CV_8U, cv::Scalar(1));
  cv::rectangle(free, {0, 0, columns_, rows_}, cv::Scalar(0));  // nobody knows what is beyond
  for (const Segment2& s : obstacles) {
    const int steps = static_cast<int>(std::ceil(s.length() / (cell_m_ / 4))) + 1;
    for (int i = 0; i <= steps; ++i) {
      const Vec2 at = (s.start + (s.end - s.start) * i / steps - corner_) / cell_m_;
      free.at<std::uint8_t>(static_cast<int>(at.y()), static_cast<int>(at.x())) = 0;
    }
  }
  cv::Mat distance;
  cv::distanceTransform(free, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  clearance_m_.reserve(distance.total());
  for (int y = 0; y < rows_; ++y) {
    for (int x = 0; x < columns_; ++x) {
      const double cells = std::max(0.0, static_cast<double>(distance.at<float>(y, x)) - kHalfDiagonal);
      clearance_m_.push_back(static_cast<float>(cells * cell_m_));
    }
  }
}

bool ClearanceGrid::contains(const Vec2& p) const {
  const Vec2 at = (p - corner_) / cell_m_;
  return at.minCoeff() >= 0 && at.x() < columns_ && at.y() < rows_;
}

std::size_t ClearanceGrid::cell_at(const Vec2& p) const {
  const Vec2 at = (p - corner_) / cell_m_;
  return static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(at.x());
}

double ClearanceGrid::clearance_m(const Vec2& p) const {
  return contains(p) ? clearance_m(cell_at(p)) : 0;
}

Vec2 ClearanceGrid::centre(std::size_t cell) const {
  const std::size_t columns = static_cast<std::size_t>(columns_), row = cell / columns;
  return corner_ + cell_m_ * Vec2(static_cast<double>(cell % columns) + 0.5, static_cast<double>(row) + 0.5);
}

}  // namespace aisle
