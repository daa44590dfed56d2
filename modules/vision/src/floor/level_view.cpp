#include "floor/level_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace aisle {

namespace {

constexpr double kNominalHeight_px = 480;  // a row is about one pixel of an image this high
constexpr double kSteepest = 3;            // downwards per ahead
constexpr double kWidest = 1.5;            // to the side per ahead
constexpr double kLeastAhead = 0.1;        // of a unit vector
constexpr int kRowsMax = 1000;
constexpr int kMeasured = 40;  // points of an image's width that its field of view is measured by

Mat3 level_axes(const Vec3& ahead) {
  const Vec2 heading = ahead.head<2>().normalized();
  Mat3 axes;
  axes.col(0) = Vec3(heading.y(), -heading.x(), 0);
  axes.col(1) = -Vec3::UnitZ();
  axes.col(2) = Vec3(heading.x(), heading.y(), 0);
  return axes;
}

}  // namespace

LevelView::LevelView(const CameraModel& camera, const CameraMount& mount, int columns, double distance_max_m)
    : camera_(camera),
      mount_(mount),
      R_vehicle_camera_(mount.R_vehicle_camera()),
      R_vehicle_level_(level_axes(R_vehicle_camera_.col(2))),
      columns_given_(columns),
      distance_max_m_(distance_max_m) {}

void LevelView::look_at(const Image& grey) {
  if (grey.channels != 1) throw std::invalid_argument("LevelView: a grey image has one channel");
  if (grey.width_px != width_px_ || grey.height_px != height_px_) prepare(grey.width_px, grey.height_px);
  auto out = grey_.begin();
  for (const Sample& sample : samples_) {
    if (sample.offset >= 0) {
      const std::uint8_t* upper = grey.bytes.data() + sample.offset;
      const std::uint8_t* lower = upper + width_px_;
      const int above = 128 * upper[0] + sample.right * (upper[1] - upper[0]);
      const int beneath = 128 * lower[0] + sample.right * (lower[1] - lower[0]);
      *out = static_cast<std::uint8_t>((128 * above + sample.below * (beneath - above) + (1 << 13)) >> 14);
    }
    ++out;
  }
}

void LevelView::prepare(int width_px, int height_px) {
  width_px_ = width_px;
  height_px_ = height_px;
  rows_ = 0;
  seen_.clear();
  samples_.clear();
  grey_.clear();
  if (!measure(width_px, height_px)) return;
  seen_.resize(static_cast<std::size_t>(columns_given_));
  samples_.reserve(seen_.size() * static_cast<std::size_t>(rows_));
  for (int column = 0; column < columns_given_; ++column) {
    Rows& seen = seen_[static_cast<std::size_t>(column)];
    for (int row = 0; row < rows_; ++row) {
      const Vec2 slopes(first_slope_ + column * slope_per_column_, depth(row) * slope_per_row_);
      samples_.push_back(sample_of(slopes, width_px, height_px));
      if (samples_.back().offset < 0) continue;
      if (seen.end != row) seen.first = row;
      seen.end = row + 1;
    }
  }
  grey_.assign(samples_.size(), 0);
}

/// The field of view beneath the horizon. @return whether there is any
bool LevelView::measure(int width_px, int height_px) {
  const double farthest = mount_.p_vehicle_camera.z() / distance_max_m_;
  double left = std::numeric_limits<double>::infinity(), right = -left, down = -left;
  const double step_px = std::max(1.0, width_px / static_cast<double>(kMeasured));
  for (int row = 0; row * step_px < height_px; ++row) {
    for (int column = 0; column * step_px < width_px; ++column) {
      const auto ray = camera_.ray({column * step_px, row * step_px});
      if (!ray) continue;
      const Vec3 level = R_vehicle_level_.transpose() * R_vehicle_camera_ * ray->direction.normalized();
      if (level.z() < kLeastAhead || level.y() < farthest * level.z()) continue;
      left = std::min(left, level.x() / level.z());
      right = std::max(right, level.x() / level.z());
      down = std::max(down, level.y() / level.z());
    }
  }
  left = std::max(left, -kWidest);
  right = std::min(right, kWidest);
  down = std::min(down, kSteepest);
  const auto centre = camera_.ray(0.5 * Vec2(width_px - 1, height_px - 1));
  if (!centre || !(right > left) || !(down > farthest)) return false;
  slope_per_row_ = centre->by_pixel(1, 1) * std::max(1.0, height_px / kNominalHeight_px);
  slope_per_row_ = std::max(slope_per_row_, (down - farthest) / kRowsMax);
  slope_per_column_ = (right - left) / columns_given_;
  first_slope_ = left + slope_per_column_ / 2;
  rows_above_ = farthest / slope_per_row_;
  rows_ = static_cast<int>((down - farthest) / slope_per_row_) + 1;
  return true;
}

LevelView::Sample LevelView::sample_of(const Vec2& slopes, int width_px, int height_px) const {
  const Vec3 direction = R_vehicle_level_ * Vec3(slopes.x(), slopes.y(), 1);
  const auto at = camera_.project(R_vehicle_camera_.transpose() * direction);
  if (!at || !(at->x() >= 0 && at->y() >= 0 && at->x() < width_px - 1 && at->y() < height_px - 1)) return {};
  const auto x = static_cast<int>(at->x()), y = static_cast<int>(at->y());
  return {.offset = y * width_px + x,
          .right = static_cast<std::uint8_t>(std::lround(128 * (at->x() - x))),
          .below = static_cast<std::uint8_t>(std::lround(128 * (at->y() - y)))};
}

Vec2 LevelView::floor_point(double column, double row) const {
  const double ahead_m = mount_.p_vehicle_camera.z() / (depth(row) * slope_per_row_);
  const Vec3 p = mount_.p_vehicle_camera +
                 ahead_m * (R_vehicle_level_ * Vec3(first_slope_ + column * slope_per_column_, 0, 1));
  return p.head<2>();
}

double LevelView::row_beyond(double row, double ahead_m) const {
  const double height_m = mount_.p_vehicle_camera.z();
  return height_m / (height_m / (depth(row) * slope_per_row_) + ahead_m) / slope_per_row_ - rows_above_;
}

std::optional<double> LevelView::column_of(const Vec3& direction_vehicle) const {
  const Vec3 level = R_vehicle_level_.transpose() * direction_vehicle;
  if (level.z() < kLeastAhead * level.norm()) return std::nullopt;
  return (level.x() / level.z() - first_slope_) / slope_per_column_;
}

}  // namespace aisle
