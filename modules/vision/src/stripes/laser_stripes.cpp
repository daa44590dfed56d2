#include "aisle/vision/stripes/laser_stripes.hpp"

#include <algorithm>
#include <cmath>

#include "level_counts.hpp"
#include "stripes/stripe_contrast.hpp"
#include "stripes/stripe_corners.hpp"
#include "stripes/stripe_links.hpp"
#include "stripes/stripe_peaks.hpp"

namespace aisle {

void StripeParams::describe(FieldList& fields) {
  fields.real("contrast_min", contrast_min, {1, 255},
              "grey levels by which a stripe outshines its surroundings");
  fields.real("noise_factor", noise_factor, {1, 20}, "and by how many times the image's median contrast");
  fields.real("white_share", white_share, {0, 1}, "how much less white light counts than coloured light");
  fields.real("width_max_share", width_max_share, {0.005, 0.2},
              "of the image's height: wider ones are lamps");
  fields.real("gradient_min", gradient_min, {0, 1}, "steepest step of each flank, as a share of the peak");
  fields.real("slope_max", slope_max, {0, 5}, "rows per column: steeper ones are not stripes");
  fields.real("gap_max_share", gap_max_share, {0, 0.2}, "of the image's width: longer gaps break a stripe");
  fields.real("length_min_share", length_min_share, {0.005, 1},
              "of the image's width: shorter ones are dropped");
  fields.real("faint_share", faint_share, {0, 1},
              "of a stripe's contrast: fainter ones in its columns are mirrored");
  fields.real("corner_px", corner_px, {0.2, 20}, "a stripe bent by more than this has a corner");
}

namespace {

constexpr int kWidthMin_px = 7;         // of the widest stripe, in small images
constexpr double kStripeFillMin = 0.7;  // share of a stripe's columns where it is seen

int median_brightness(const Image& image) {
  LevelCounts counts;
  for (const std::uint8_t value : image.bytes) counts.add(value);
  return counts.median();
}

double mean_contrast(const PeakChain& chain) {
  double sum = 0;
  for (const StripePeak& peak : chain) sum += peak.contrast;
  return sum / static_cast<double>(chain.size());
}

bool is_long(const PeakChain& chain, double length_min_px) {
  const int columns = chain.back().column - chain.front().column + 1;
  return columns >= length_min_px && static_cast<double>(chain.size()) >= kStripeFillMin * columns;
}

/// A far brighter stripe in most of the same columns: this one is its mirror image or its halo.
bool is_outshone(const PeakChain& chain, const std::vector<PeakChain>& chains, double faint_share) {
  const int first = chain.front().column, last = chain.back().column;
  int covered = 0;
  for (const PeakChain& other : chains) {
    if (mean_contrast(chain) >= faint_share * mean_contrast(other)) continue;
    covered += std::max(0, std::min(last, other.back().column) - std::max(first, other.front().column) + 1);
  }
  return 2 * covered > last - first + 1;
}

LaserStripe stripe_of(const PeakChain& chain, double corner_px) {
  LaserStripe stripe;
  for (const StripePeak& peak : chain) stripe.points_px.emplace_back(peak.column, peak.row);
  stripe.corners_px = polyline_corners(stripe.points_px, corner_px);
  return stripe;
}

}  // namespace

std::vector<LaserStripe> find_laser_stripes(const Image& image, const StripeParams& params) {
  if (image.bytes.empty()) return {};
  const int width_max_px =
      std::max(kWidthMin_px, static_cast<int>(std::lround(params.width_max_share * image.height_px)));
  const Image contrast = stripe_contrast(image, width_max_px + 1, params.white_share);
  const double contrast_min =
      std::max(params.contrast_min, params.noise_factor * median_brightness(contrast));

  const auto peaks = find_stripe_peaks(
      contrast, {static_cast<int>(std::ceil(contrast_min)), width_max_px, params.gradient_min});
  const int gap_max_px = static_cast<int>(std::lround(params.gap_max_share * image.width_px));
  std::vector<PeakChain> chains = link_stripe_peaks(peaks, {gap_max_px, params.slope_max});

  const double length_min_px = std::max(2.0, params.length_min_share * image.width_px);
  std::erase_if(chains, [&](const PeakChain& chain) { return !is_long(chain, length_min_px); });
  std::vector<LaserStripe> stripes;
  for (const PeakChain& chain : chains)
    if (!is_outshone(chain, chains, params.faint_share))
      stripes.push_back(stripe_of(chain, params.corner_px));
  std::sort(stripes.begin(), stripes.end(), [](const LaserStripe& a, const LaserStripe& b) {
    return std::pair(a.points_px.front().x(), a.points_px.front().y()) <
           std::pair(b.points_px.front().x(), b.points_px.front().y());
  });
  return stripes;
}

}  // namespace aisle
