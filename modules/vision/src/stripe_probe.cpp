#include "aisle/vision/stripe_probe.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace aisle {
namespace {

constexpr int kLinkRows = 2;            // from column to column
constexpr std::size_t kGapColumns = 2;  // up to the next peak of a stripe
constexpr int kThinRows = 4;            // laser light is no thicker
constexpr int kLightColumns = 40;       // so wide is nothing but laser light

}  // namespace

void StripeProbeParams::describe(FieldList& fields) {
  fields.real("reach_m", reach_m, {0.5, 10}, "from the lens; farther off, paper looks as thin as a stripe");
  fields.real("light_reach_m", light_reach_m, {0.5, 20}, "so far any wall shows that the markers are on");
  fields.count("flank_px", flank_px, {2, 20}, "rows from the middle of a stripe to beside it");
  fields.real("contrast_min", contrast_min, {1, 200},
              "by which a stripe outshines both sides, in grey levels");
  fields.real("noise_factor", noise_factor, {1, 50}, "and by how many times the floor's usual contrast");
  fields.count("columns_min", columns_min, {1, 100}, "of the narrowest stripe");
  fields.real("columns_per_m", columns_per_m, {0, 100},
              "times its distance: narrower, it may be a corner of paper");
  fields.real("mirrored_share", mirrored_share, {0, 1},
              "of a stripe's contrast: fainter below it is mirrored");
}

StripeProbe::StripeProbe(const StripeProbeParams& params, const CameraIntrinsics& intrinsics,
                         const CameraMount& mount, int width_px, int height_px, double height_m)
    : params_(params),
      camera_(intrinsics),
      mount_(mount),
      width_px_(width_px),
      height_px_(height_px),
      height_m_(height_m),
      p_vehicle_lens_(mount.p_vehicle_camera.head<2>()) {
  lay_columns(camera_);
  if (places_.empty()) throw std::invalid_argument("the camera sees no laser light within reach");
}

/// Upwards from below, the light plane is ever farther away.
void StripeProbe::lay_columns(const CameraModel& camera) {
  const BackProjection plane(camera, mount_, height_m_);
  columns_.resize(static_cast<std::size_t>(width_px_));
  first_row_ = height_px_;
  const int end_row = height_px_ - params_.flank_px;
  std::vector<Vec2> upwards;
  for (int u = 0; u < width_px_; ++u) {
    Column& column = columns_[static_cast<std::size_t>(u)];
    upwards.clear();
    for (int v = end_row - 1; v >= params_.flank_px; --v) {
      const auto p = plane.point({u, v});
      if (!p || away_m(*p) > params_.light_reach_m) break;
      upwards.push_back(*p);
    }
    column.end_row = end_row;
    column.first_row = end_row - static_cast<int>(upwards.size());
    column.first_place = places_.size();
    places_.insert(places_.end(), upwards.rbegin(), upwards.rend());
    first_row_ = std::min(first_row_, column.first_row);
  }
}

const Vec2& StripeProbe::place(const Column& column, int row) const {
  return places_[column.first_place + static_cast<std::size_t>(row - column.first_row)];
}

/// From the usual contrast between rows of a coarse grid of places.
int StripeProbe::threshold(const Image& picture) const {
  constexpr int kStep_px = 8;
  long total = 0, count = 0;
  for (int v = first_row_; v + params_.flank_px < height_px_; v += kStep_px) {
    const std::uint8_t *here = picture.row(v), *below = picture.row(v + params_.flank_px);
    for (int u = 0; u < width_px_; u += kStep_px) {
      total += std::min(std::abs(here[u] - below[u]), 20);
      ++count;
    }
  }
  const double usual = static_cast<double>(total) / static_cast<double>(std::max(count, 1L));
  return static_cast<int>(std::ceil(std::max(params_.contrast_min, params_.noise_factor * usual)));
}

/// How many rows about a place are at least so bright, next to each other.
int StripeProbe::rows_as_bright(const Image& picture, int u, int v, int level) const {
  int rows = 1;
  for (int i = 1; i < params_.flank_px && picture.row(v - i)[u] >= level; ++i) ++rows;
  for (int i = 1; i < params_.flank_px && picture.row(v + i)[u] >= level; ++i) ++rows;
  return rows;
}

void StripeProbe::find_peaks(const Image& picture) {
  const int contrast_min = threshold(picture);
  for (Column& column : columns_) column.peaks_found = 0;
  for (int v = height_px_ - params_.flank_px - 1; v >= first_row_; --v) {
    const std::uint8_t *here = picture.row(v), *above = picture.row(v - params_.flank_px),
                       *below = picture.row(v + params_.flank_px), *before = picture.row(v - 1),
                       *after = picture.row(v + 1);
    for (int u = 0; u < width_px_; ++u) {
      const int contrast = here[u] - std::max(above[u], below[u]);
      if (contrast < contrast_min || here[u] < before[u] || here[u] <= after[u]) continue;
      Column& column = columns_[static_cast<std::size_t>(u)];
      if (v < column.first_row || column.peaks_found == kPeaksMax) continue;
      column.peaks[column.peaks_found++] = {
          .row = v, .contrast = contrast, .rows = rows_as_bright(picture, u, v, here[u] - contrast / 2)};
    }
  }
}

const StripeProbe::Peak* StripeProbe::peak_before(std::size_t column, int row) const {
  for (std::size_t back = 1; back <= std::min(kGapColumns, column); ++back) {
    const Column& before = columns_[column - back];
    for (std::size_t i = 0; i < before.peaks_found; ++i)
      if (std::abs(before.peaks[i].row - row) <= kLinkRows) return &before.peaks[i];
  }
  return nullptr;
}

/// Peaks of neighbouring columns at about the same row belong together.
void StripeProbe::link_peaks() {
  chains_.clear();
  for (std::size_t u = 0; u < columns_.size(); ++u) {
    for (std::size_t i = 0; i < columns_[u].peaks_found; ++i) {
      Peak& peak = columns_[u].peaks[i];
      const Peak* before = peak_before(u, peak.row);
      peak.chain = before == nullptr ? chains_.size() : before->chain;
      if (before == nullptr) chains_.push_back({.away_m = away_m(place(columns_[u], peak.row))});
      Chain& chain = chains_[peak.chain];
      const auto column = static_cast<std::size_t>(chain.columns++);
      chain.last_rows[column % kEndColumns] = peak.rows;
    }
  }
  for (Chain& chain : chains_) chain.is_stripe = is_stripe(chain);
}

/// Wider than the corner of a sheet of paper that is as thin as laser light there: 90 degrees seen from above
/// are at least two rows a column, times the lens's height over distance.
bool StripeProbe::is_stripe(const Chain& chain) const {
  const auto is_thin = [](int rows) { return rows <= kThinRows; };
  if (chain.columns < params_.columns_min) return false;
  return chain.columns >= params_.columns_per_m * chain.away_m &&
         std::all_of(chain.last_rows.begin(), chain.last_rows.end(), is_thin);
}

const std::vector<Vec2>& StripeProbe::find(const Image& picture) {
  if (picture.channels != 1 || picture.width_px != width_px_ || picture.height_px != height_px_)
    throw std::invalid_argument("the picture must be grey and of the camera's size");
  find_peaks(picture);
  link_peaks();
  collect();
  return found_;
}

/// The nearest laser light in a column. Floor mirrors the stripe: fainter, and below it.
const StripeProbe::Peak* StripeProbe::nearest_light(const Column& column) const {
  const Peak* nearest = nullptr;
  int brightest = 0;
  for (std::size_t i = column.peaks_found; i-- > 0;) {
    const Peak& peak = column.peaks[i];
    if (!chains_[peak.chain].is_stripe) continue;
    if (peak.contrast >= params_.mirrored_share * brightest) nearest = &peak;
    brightest = std::max(brightest, peak.contrast);
  }
  return nearest;
}

void StripeProbe::collect() {
  found_.clear();
  for (Column& column : columns_) {
    column.free_m = params_.reach_m;
    const Peak* nearest = nearest_light(column);
    if (nearest == nullptr) continue;
    const Vec2& p_vehicle = place(column, nearest->row);
    if (away_m(p_vehicle) > params_.reach_m) continue;
    column.free_m = away_m(p_vehicle);
    found_.push_back(p_vehicle);
  }
  sees_light_ = std::any_of(chains_.begin(), chains_.end(),
                            [](const Chain& chain) { return chain.columns >= kLightColumns; });
}

StripeProbe::Seen StripeProbe::seen_at(const Vec2& p_vehicle) const {
  constexpr double kSure_m = 0.15;
  const auto pixel = camera_.project(mount_.to_camera({p_vehicle.x(), p_vehicle.y(), height_m_}));
  if (!pixel) return Seen::kNothing;
  const int u = static_cast<int>(std::lround(pixel->x())), v = static_cast<int>(std::lround(pixel->y()));
  if (u < 0 || u >= width_px_) return Seen::kNothing;
  const Column& column = columns_[static_cast<std::size_t>(u)];
  if (v >= column.end_row || away_m(p_vehicle) > params_.reach_m) return Seen::kNothing;
  return away_m(p_vehicle) + kSure_m < column.free_m ? Seen::kFree : Seen::kNothing;
}

}  // namespace aisle
