#pragma once

#include <optional>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/geometry/back_projection.hpp"
#include "aisle/geometry/camera_model.hpp"

namespace aisle {

/// The floor as a level camera without distortion would see it from the same place: what is vertical in the
/// building is one column, what is straight is straight. Rows are counted downwards from a row just beneath
/// the horizon; few columns are sampled, each of them densely. Keeps its buffers between images.
class LevelView {
 public:
  struct Rows {
    int first = 0, end = 0;
    int count() const { return end - first; }
  };

  /// @param columns  as many are sampled
  /// @param distance_max_m  the first row is this far away
  LevelView(const CameraModel& camera, const CameraMount& mount, int columns, double distance_max_m);

  /// Samples an image. @throws std::invalid_argument unless it has one channel
  void look_at(const Image& grey);

  int columns() const { return static_cast<int>(seen_.size()); }
  int rows() const { return rows_; }
  /// The rows of a column that the image shows.
  Rows seen(int column) const { return seen_[static_cast<std::size_t>(column)]; }
  /// Brightness of a column from row 0 downwards; only the rows seen.
  const std::uint8_t* column(int column) const {
    return grey_.data() + static_cast<std::size_t>(column) * static_cast<std::size_t>(rows_);
  }
  /// How far beneath the horizon a row is, in rows.
  double depth(double row) const { return row + rows_above_; }
  /// A column's step in units of rows.
  double rows_per_column() const { return slope_per_column_ / slope_per_row_; }

  /// The point of the floor in base_link that is seen there.
  Vec2 floor_point(double column, double row) const;
  /// The row of the floor that is farther ahead than a row's by a distance.
  double row_beyond(double row, double ahead_m) const;
  /// Which column sees a direction of base_link; nullopt if it is not ahead of the camera.
  std::optional<double> column_of(const Vec3& direction_vehicle) const;

 private:
  struct Sample {
    int offset = -1;         ///< of the upper left of four pixels; -1: nothing is seen
    std::uint8_t right = 0;  ///< share of the right pixels, of 128
    std::uint8_t below = 0;  ///< share of the lower pixels, of 128
  };

  void prepare(int width_px, int height_px);
  bool measure(int width_px, int height_px);
  Sample sample_of(const Vec2& slopes, int width_px, int height_px) const;

  CameraModel camera_;
  CameraMount mount_;
  Mat3 R_vehicle_camera_;
  Mat3 R_vehicle_level_;  ///< its columns: right, down, ahead
  int columns_given_;
  double distance_max_m_;
  int width_px_ = 0, height_px_ = 0;  ///< of the images that the samples are for
  int rows_ = 0;
  double first_slope_ = 0, slope_per_column_ = 1;  ///< to the right per ahead
  double rows_above_ = 0, slope_per_row_ = 1;      ///< downwards per ahead
  std::vector<Rows> seen_;
  std::vector<Sample> samples_;
  std::vector<std::uint8_t> grey_;
};

}  // namespace aisle
