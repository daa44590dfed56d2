#pragma once

#include <optional>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/geometry/camera_model.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// The image that a line detector looks at: the given one, shrunk to a width at which lines are sharp and
/// few pixels wide, and with the lens distortion undone if the camera is known. Keeps its buffers between
/// images.
class WorkingImage {
 public:
  WorkingImage(int width_max_px, const std::optional<CameraModel>& camera);

  /// `grey` must live as long as grey() is used.
  /// @throws std::invalid_argument unless it has one channel
  void look_at(const Image& grey);

  const Image& grey() const { return *grey_; }
  int width_px() const { return grey_->width_px; }
  int height_px() const { return grey_->height_px; }
  /// Whether a point of the image as given is in it.
  bool is_given(const Vec2& given_px) const;

  /// Where a point of the working image is in the image as given; nullopt where the camera sees nothing.
  std::optional<Vec2> given(const Vec2& working_px) const;
  /// The inverse.
  std::optional<Vec2> working(const Vec2& given_px) const;

  /// Given pixels per working pixel, horizontally.
  double shrink() const { return shrink_.x(); }
  /// Whether straight lines of the working image may be curves in the image as given.
  bool bends_lines() const { return camera_.has_value(); }

 private:
  struct Sample {
    int offset = -1;         ///< of the upper left of four pixels in the shrunk image; -1: nothing is seen
    std::uint8_t right = 0;  ///< share of the right pixels, of 128
    std::uint8_t below = 0;  ///< share of the lower pixels, of 128
  };

  void shrink_given();
  void sum_rows(double top, double bottom);
  void prepare_straightening();
  void straighten();
  std::optional<Vec2> seen_at(const Vec2& working_px) const;
  Vec2 enlarged(const Vec2& shrunk_px) const;
  Vec2 shrunk_of_given(const Vec2& given_px) const;

  int width_max_px_;
  std::optional<CameraModel> camera_;
  const Image* given_ = nullptr;
  const Image* grey_ = nullptr;
  int given_width_px_ = 0, given_height_px_ = 0;
  Vec2 shrink_ = Vec2::Ones();  ///< given pixels per working pixel, across and down
  Image shrunk_;
  Image straight_;
  std::vector<float> column_sums_;
  std::vector<double> integral_;
  std::vector<Sample> samples_;        ///< one per pixel of the straight image
  Vec2 centre_px_ = Vec2::Zero();      ///< of the image as given: there straightening changes nothing
  Vec2 centre_slopes_ = Vec2::Zero();  ///< x and y of its ray
  Mat2 slopes_by_pixel_ = Mat2::Identity();
};

}  // namespace aisle
