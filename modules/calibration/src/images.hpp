#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/geometry/camera_model.hpp"

namespace aisle {

/// The image's grey values, without a copy; valid as long as `grey` lives.
inline cv::Mat as_mat(const Image& grey) {
  return {grey.height_px, grey.width_px, CV_8UC1, const_cast<std::uint8_t*>(grey.bytes.data())};  // NOLINT
}

inline cv::Point2f to_cv(const Vec2& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y())};
}

inline cv::Point3f to_cv(const Vec3& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

template <class Points>
auto to_cv(const Points& points) {
  std::vector<decltype(to_cv(points.front()))> converted;
  converted.reserve(points.size());
  for (const auto& p : points) converted.push_back(to_cv(p));
  return converted;
}

inline Mat3 to_eigen(const cv::Matx33d& m) {
  Mat3 converted;
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) converted(row, col) = m(row, col);
  }
  return converted;
}

}  // namespace aisle
