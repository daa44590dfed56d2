#include "working_image.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace aisle {

WorkingImage::WorkingImage(int width_max_px, const std::optional<CameraModel>& camera)
    : width_max_px_(width_max_px), camera_(camera) {}

void WorkingImage::look_at(const Image& grey) {
  if (grey.channels != 1) throw std::invalid_argument("WorkingPicture: a grey image has one channel");
  const bool same_size = grey.width_px == given_width_px_ && grey.height_px == given_height_px_;
  given_ = grey_ = &grey;
  given_width_px_ = grey.width_px;
  given_height_px_ = grey.height_px;
  shrink_ = Vec2::Ones();
  if (grey.width_px > width_max_px_) shrink_given();
  if (!camera_ || grey.bytes.empty()) return;
  if (!same_size) prepare_straightening();
  straighten();
}

/// Each pixel the mean of the area that it covers, parts of pixels included.
void WorkingImage::shrink_given() {
  const int height =
      std::max(1, static_cast<int>(std::lround(1.0 * given_->height_px * width_max_px_ / given_->width_px)));
  if (shrunk_.width_px != width_max_px_ || shrunk_.height_px != height)
    shrunk_ = Image(width_max_px_, height);
  shrink_ = Vec2(given_->width_px, given_->height_px).cwiseQuotient(Vec2(width_max_px_, height));
  integral_.resize(static_cast<std::size_t>(given_->width_px) + 2);
  for (int v = 0; v < height; ++v) {
    sum_rows(v * shrink_.y(), (v + 1) * shrink_.y());
    constexpr double kHalf = 0.5;  // to round, not to cut
    std::uint8_t* out = shrunk_.row(v);
    double before = 0;
    for (int u = 0; u < width_max_px_; ++u) {
      const double end = (u + 1) * shrink_.x();
      const auto whole = static_cast<std::size_t>(end);
      const double share = end - static_cast<double>(whole);
      const double up_to = integral_[whole] + share * (integral_[whole + 1] - integral_[whole]);
      out[u] = static_cast<std::uint8_t>(kHalf + (up_to - before) / (shrink_.x() * shrink_.y()));
      before = up_to;
    }
  }
  grey_ = &shrunk_;
}

/// integral_[x]: sum over the columns left of x in the rows from `top` to `bottom`, parts of rows included.
void WorkingImage::sum_rows(double top, double bottom) {
  column_sums_.assign(static_cast<std::size_t>(given_->width_px), 0.0F);
  for (int y = static_cast<int>(top); y < given_->height_px && y < bottom; ++y) {
    const auto share = static_cast<float>(std::min(bottom, y + 1.0) - std::max(top, static_cast<double>(y)));
    const std::uint8_t* row = given_->row(y);
    for (std::size_t x = 0; x < column_sums_.size(); ++x) column_sums_[x] += share * row[x];
  }
  integral_[0] = 0;
  for (std::size_t x = 0; x < column_sums_.size(); ++x) integral_[x + 1] = integral_[x] + column_sums_[x];
  integral_.back() = integral_[column_sums_.size()];
}

/// The straight image is the pinhole image that agrees with the shrunk one around the centre.
void WorkingImage::prepare_straightening() {
  constexpr Sample kNone;
  samples_.assign(grey_->bytes.size(), kNone);
  straight_ = Image(grey_->width_px, grey_->height_px);
  centre_px_ = 0.5 * Vec2(given_width_px_ - 1, given_height_px_ - 1);
  const auto centre = camera_->ray(centre_px_);
  if (!centre) {
    camera_.reset();
    return;
  }
  centre_slopes_ = centre->direction.head<2>();
  slopes_by_pixel_ = centre->by_pixel;
  auto* sample = samples_.data();
  for (int v = 0; v < grey_->height_px; ++v) {
    for (int u = 0; u < grey_->width_px; ++u, ++sample) {
      const auto seen = seen_at(Vec2(u, v));
      if (!seen) continue;
      const Vec2 at = shrunk_of_given(*seen);
      if (!(at.x() >= 0 && at.y() >= 0 && at.x() < grey_->width_px - 1 && at.y() < grey_->height_px - 1))
        continue;
      const auto x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
      sample->offset = y * grey_->width_px + x;
      sample->right = static_cast<std::uint8_t>(std::lround(128 * (at.x() - x)));
      sample->below = static_cast<std::uint8_t>(std::lround(128 * (at.y() - y)));
    }
  }
}

/// Where the camera shows nothing, the last pixel of the row is repeated, so that no vertical edge arises.
void WorkingImage::straighten() {
  const Image& from = *grey_;
  std::uint8_t* out = straight_.bytes.data();
  int last = 0;
  for (const Sample& sample : samples_) {
    if (sample.offset >= 0) {
      const std::uint8_t* upper = from.bytes.data() + sample.offset;
      const std::uint8_t* lower = upper + from.width_px;
      const int above = 128 * upper[0] + sample.right * (upper[1] - upper[0]);
      const int beneath = 128 * lower[0] + sample.right * (lower[1] - lower[0]);
      last = (128 * above + sample.below * (beneath - above) + (1 << 13)) >> 14;
    }
    *out++ = static_cast<std::uint8_t>(last);
  }
  grey_ = &straight_;
}

bool WorkingImage::is_given(const Vec2& given_px) const {
  return given_px.x() >= -0.5 && given_px.y() >= -0.5 && given_px.x() <= given_width_px_ - 0.5 &&
         given_px.y() <= given_height_px_ - 0.5;
}

std::optional<Vec2> WorkingImage::given(const Vec2& working_px) const {
  if (!camera_) return enlarged(working_px);
  return seen_at(working_px);
}

std::optional<Vec2> WorkingImage::seen_at(const Vec2& working_px) const {
  const Vec2 slopes = centre_slopes_ + slopes_by_pixel_ * (enlarged(working_px) - centre_px_);
  return camera_->project(Vec3(slopes.x(), slopes.y(), 1));
}

std::optional<Vec2> WorkingImage::working(const Vec2& given_px) const {
  if (!camera_) return shrunk_of_given(given_px);
  const auto ray = camera_->ray(given_px);
  if (!ray) return std::nullopt;
  const Vec2 slopes = ray->direction.head<2>() - centre_slopes_;
  return shrunk_of_given(centre_px_ + slopes_by_pixel_.inverse() * slopes);
}

Vec2 WorkingImage::enlarged(const Vec2& shrunk_px) const {
  return ((shrunk_px.array() + 0.5) * shrink_.array() - 0.5).matrix();
}

Vec2 WorkingImage::shrunk_of_given(const Vec2& given_px) const {
  return ((given_px.array() + 0.5) / shrink_.array() - 0.5).matrix();
}

}  // namespace aisle
