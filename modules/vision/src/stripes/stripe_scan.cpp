#include "aisle/vision/stripes/stripe_scan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "level_counts.hpp"

namespace aisle {
namespace {

constexpr double kStep_rad = 0.25 * kDegree;
constexpr double kImageEdge_px = 4;       // lenses are poor there
constexpr double kNearest_m = 0.1;        // from below the lens
constexpr double kProbe_m = 0.01;         // over which a beam's scale in the image is measured
constexpr double kBlur_px = 1.5;          // of the lens, to either side of a stripe
constexpr double kFlank = 1.6;            // half the thickness and a margin beside it
constexpr std::size_t kBesideFlanks = 2;  // this many flanks before and behind a stripe nothing is as bright
constexpr double kLinkFloor_px = 2;       // from beam to beam, beyond what the steepness explains
constexpr std::size_t kGapBeams = 1;      // that a stripe may skip
constexpr double kNearEdge_m = 0.15;      // a stripe that ends this near to the image's lower edge leaves it
constexpr double kFaint = 3;              // times the least contrast: a stripe that may go on unseen ...
constexpr int kEndBeams = 6;              // ... if it is this faint on one of this many beams at its end
constexpr int kWallBeams = 24;            // that determine where a wall goes on
constexpr double kWallStep = 0.1;         // of the range, from beam to beam
constexpr double kSlopeKept = 0.7;        // of a stripe's slope, from beam to beam
constexpr double kThinnest_px = 2;        // laser light far away
constexpr std::size_t kUsualStep = 7;     // every so many samples one is used for the usual contrast
constexpr double kBefore_m = 0.15;        // a point this far before a laser return is free

std::uint8_t level_difference(int a, int b) {
  return static_cast<std::uint8_t>(std::abs(a - b));
}

}  // namespace

void StripeScanParams::describe(FieldList& fields) {
  fields.real("wide_m", wide_m, {0.2, 20}, "at this range the outermost beams are still in the image");
  fields.real("sure_reach_m", sure_reach_m, {0.5, 20},
              "up to here a stripe is seen on all but grazing-incidence surfaces");
  fields.real("light_reach_m", light_reach_m, {0.5, 20}, "up to here any wall shows that the lasers are on");
  fields.real("contrast_min", contrast_min, {1, 200},
              "grey levels by which a stripe is brighter than what lies before and behind it");
  fields.real("noise_factor", noise_factor, {1, 50}, "and by how many times the image's usual contrast");
  fields.real("beam_m", beam_m, {0.001, 0.05}, "thickness of the light");
  fields.real("steepness_max", steepness_max, {0.5, 10}, "rows per column of the steepest stripe");
  fields.real("width_min_m", width_min_m, {0, 1}, "of the narrowest obstacle");
  fields.count("beams_min", beams_min, {1, 100}, "least number of beams that hit an obstacle");
  fields.real("mirrored_share", mirrored_share, {0, 1},
              "of a stripe's contrast: a fainter one before it is its mirror image in the floor");
  fields.count("lit_beams_min", lit_beams_min, {1, 1000}, "beams of a stripe that can only be laser light");
}

double StripeScan::angle_step_rad() {
  return kStep_rad;
}

StripeScan::StripeScan(const StripeScanParams& params, const CameraIntrinsics& intrinsics,
                       const CameraMount& mount, int width_px, int height_px, double height_m)
    : params_(params),
      T_vehicle_fan_{mount.p_vehicle_camera.x(), mount.p_vehicle_camera.y(), mount.pan_rad},
      width_px_(width_px),
      height_px_(height_px),
      focal_px_(intrinsics.fy_px),
      above_m_(mount.p_vehicle_camera.z() - height_m) {
  lay_beams(CameraModel(intrinsics), mount, height_m);
  if (samples_.empty()) throw std::invalid_argument("the camera sees no laser light within reach");
}

/// Covers the image's width at a few metres, with as many beams to either side.
void StripeScan::lay_beams(const CameraModel& camera, const CameraMount& mount, double height_m) {
  const auto is_seen = [&](int beam) {
    const Vec2 p_vehicle =
        mount.p_vehicle_camera.head<2>() + params_.wide_m * unit(mount.pan_rad + beam * kStep_rad);
    const auto pixel = camera.project(mount.to_camera({p_vehicle.x(), p_vehicle.y(), height_m}));
    return pixel && is_inside(*pixel);
  };
  int half_beams = 0;
  while (is_seen(half_beams + 1) && is_seen(-half_beams - 1)) ++half_beams;
  first_angle_rad_ = -half_beams * kStep_rad;
  for (int beam = -half_beams; beam <= half_beams; ++beam)
    lay_curve(mount.pan_rad + beam * kStep_rad, camera, mount, height_m);
  levels_.resize(samples_.size());
  link_px_ = static_cast<int>(kLinkFloor_px + params_.steepness_max * focal_px_ * kStep_rad);
}

bool StripeScan::is_inside(const Vec2& pixel) const {
  return pixel.x() >= kImageEdge_px && pixel.y() >= kImageEdge_px &&
         pixel.x() < width_px_ - 1 - kImageEdge_px && pixel.y() < height_px_ - 1 - kImageEdge_px;
}

/// Outwards from below the lens, one sample per pixel.
void StripeScan::lay_curve(double angle_rad, const CameraModel& camera, const CameraMount& mount,
                           double height_m) {
  const Vec2 p_vehicle_lens = mount.p_vehicle_camera.head<2>();
  const auto pixel_at = [&](double range_m) {
    const Vec2 p_vehicle = p_vehicle_lens + range_m * unit(angle_rad);
    return camera.project(mount.to_camera({p_vehicle.x(), p_vehicle.y(), height_m}));
  };
  Curve curve{samples_.size(), samples_.size()};
  Beam beam;
  for (double range_m = kNearest_m; range_m < params_.light_reach_m;) {
    const auto pixel = pixel_at(range_m), beyond = pixel_at(range_m + kProbe_m);
    if (!pixel || !beyond || !is_inside(*pixel)) {
      if (curve.end > curve.first) break;
      range_m += kProbe_m;
      continue;
    }
    const double px_per_m = (*beyond - *pixel).norm() / kProbe_m;
    const Vec2 first = pixel->array().floor();
    samples_.push_back(
        {.first_byte = static_cast<std::uint32_t>(first.y()) * static_cast<std::uint32_t>(width_px_) +
                       static_cast<std::uint32_t>(first.x()),
         .right_256 = static_cast<std::uint16_t>(std::lround(256 * (pixel->x() - first.x()))),
         .below_256 = static_cast<std::uint16_t>(std::lround(256 * (pixel->y() - first.y()))),
         .range_m = static_cast<float>(range_m),
         .flank = flank_at(std::hypot(range_m, above_m_))});
    curve.end = samples_.size();
    range_m += 1 / px_per_m;
  }
  if (curve.end > curve.first) {
    const std::size_t nearest = curve.first + samples_[curve.first].flank;
    const std::size_t farthest = curve.end - 1 - samples_[curve.end - 1].flank;
    beam.near_m = samples_[std::min(nearest, curve.end - 1)].range_m;
    beam.far_m = samples_[std::max(farthest, curve.first)].range_m;
  }
  curves_.push_back(curve);
  beams_.push_back(beam);
}

/// Half the stripe's thickness, where it is steepest, and the blur beside it.
std::uint8_t StripeScan::flank_at(double away_m) const {
  const double flank_px = kBlur_px + kFlank * params_.steepness_max * params_.beam_m * focal_px_ / away_m;
  return static_cast<std::uint8_t>(std::clamp(std::lround(flank_px), 3L, 40L));
}

const std::vector<StripeScan::Beam>& StripeScan::find(const Image& image) {
  if (image.channels != 1 || image.width_px != width_px_ || image.height_px != height_px_)
    throw std::invalid_argument("the image must be grey and of the camera's size");
  read(image);
  find_peaks();
  link_peaks();
  choose_nearest();
  mark_uncertain_beyond_ends();
  return beams_;
}

void StripeScan::read(const Image& image) {
  const std::uint8_t* bytes = image.bytes.data();
  const std::size_t below = image.row_bytes();
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Sample& sample = samples_[i];
    const std::uint8_t* at = bytes + sample.first_byte;
    const int upper = (256 - sample.right_256) * at[0] + sample.right_256 * at[1];
    const int lower = (256 - sample.right_256) * at[below] + sample.right_256 * at[below + 1];
    const int level = (256 - sample.below_256) * upper + sample.below_256 * lower;
    levels_[i] = static_cast<std::int16_t>((level + (1 << 15)) >> 16);
  }
}

/// Least contrast of a peak, from the median contrast along the beams.
int StripeScan::threshold() const {
  LevelCounts contrasts;
  for (const Curve& curve : curves_) {
    for (std::size_t i = curve.first; i + samples_[i].flank < curve.end; i += kUsualStep)
      contrasts.add(level_difference(levels_[i], levels_[i + samples_[i].flank]));
  }
  return static_cast<int>(
      std::ceil(std::max(params_.contrast_min, params_.noise_factor * contrasts.median())));
}

void StripeScan::find_peaks() {
  peaks_.clear();
  contrast_min_ = threshold();
  for (std::size_t beam = 0; beam < curves_.size(); ++beam) {
    const Curve& curve = curves_[beam];
    for (std::size_t i = curve.first + 1; i + 1 < curve.end; ++i) {
      const std::size_t flank = samples_[i].flank;
      if (i < curve.first + flank) continue;
      if (i + flank >= curve.end) break;
      const std::int16_t* here = &levels_[i];
      if (here[0] < here[-1] || here[0] <= here[1]) continue;
      const int beside = std::max(*(here - flank), *(here + flank));
      if (here[0] - beside < contrast_min_) continue;
      const int contrast = here[0] - brightest_beside(curve, i);
      if (contrast >= contrast_min_) add_peak(beam, i, contrast);
    }
  }
}

/// The brightest level before and behind a stripe at a sample.
int StripeScan::brightest_beside(const Curve& curve, std::size_t i) const {
  const std::size_t flank = samples_[i].flank;
  const std::size_t first = i - std::min(i - curve.first, kBesideFlanks * flank);
  const std::size_t end = std::min(i + kBesideFlanks * flank + 1, curve.end);
  const auto level = [&](std::size_t k) { return levels_.begin() + static_cast<std::ptrdiff_t>(k); };
  return std::max(*std::max_element(level(first), level(i - flank + 1)),
                  *std::max_element(level(i + flank), level(end)));
}

/// Adds a peak at the middle of what is at least half as bright.
void StripeScan::add_peak(std::size_t beam, std::size_t i, int contrast) {
  const int half = levels_[i] - contrast / 2;
  const std::size_t flank = samples_[i].flank;
  int rows = 0;
  double weights = 0, moment_m = 0;
  const auto add = [&](std::size_t k) {
    const double weight = levels_[k] - half + 1;
    ++rows;
    weights += weight;
    moment_m += weight * samples_[k].range_m;
  };
  add(i);
  for (std::size_t k = 1; k < flank && levels_[i - k] >= half; ++k) add(i - k);
  for (std::size_t k = 1; k < flank && levels_[i + k] >= half; ++k) add(i + k);
  peaks_.push_back({.beam = beam,
                    .sample = i,
                    .row = static_cast<int>(samples_[i].first_byte) / width_px_,
                    .range_m = moment_m / weights,
                    .contrast = contrast,
                    .rows = rows});
}

/// Peaks of neighbouring beams at about the same row belong together.
void StripeScan::link_peaks() {
  chains_.clear();
  std::size_t first = 0;  // that may be linked to
  for (std::size_t p = 0; p < peaks_.size(); ++p) {
    Peak& peak = peaks_[p];
    while (peaks_[first].beam + kGapBeams + 1 < peak.beam) ++first;
    if (const Peak* before = linked_before(peak, first)) {
      const double slope = (peak.row - before->row) / static_cast<double>(peak.beam - before->beam);
      peak.slope = before->slope ? kSlopeKept * *before->slope + (1 - kSlopeKept) * slope : slope;
      peak.chain = before->chain;
    } else {
      peak.chain = chains_.size();
      chains_.push_back({.first_peak = p, .range_m = peak.range_m});
    }
    Chain& chain = chains_[peak.chain];
    if (chain.peaks == 0 || peaks_[chain.last_peak].beam != peak.beam) ++chain.beams;
    chain.last_peak = p;
    ++chain.peaks;
    chain.contrast += peak.contrast;
    chain.range_m = std::min(chain.range_m, peak.range_m);
    chain.thickness += thickness(peak);
  }
  for (std::size_t chain = 0; chain < chains_.size(); ++chain) chains_[chain].is_stripe = is_stripe(chain);
}

/// The nearest peak on the nearest previous beam.
const StripeScan::Peak* StripeScan::linked_before(const Peak& peak, std::size_t first) const {
  const Peak* linked = nullptr;
  for (const Peak* before = &peaks_[first]; before->beam < peak.beam; ++before) {
    const int off = std::abs(before->row - peak.row);
    if (off > link_px_ * static_cast<int>(peak.beam - before->beam)) continue;
    if (linked == nullptr || before->beam > linked->beam || off < std::abs(linked->row - peak.row))
      linked = before;
  }
  return linked;
}

/// As a share of the most that laser light may have there; across the stripe, not along the beam.
double StripeScan::thickness(const Peak& peak) const {
  const double rows_a_column = peak.slope.value_or(0) / (focal_px_ * kStep_rad);
  const double light_px = kThinnest_px + params_.beam_m * focal_px_ / std::hypot(peak.range_m, above_m_);
  return peak.rows / std::hypot(1, rows_a_column) / light_px;
}

/// Paper on the floor is too thick.
bool StripeScan::is_stripe(std::size_t c) const {
  const Chain& chain = chains_[c];
  return chain.beams >= params_.beams_min && chain.beams * kStep_rad * chain.range_m >= params_.width_min_m &&
         chain.thickness <= chain.peaks && outshines_grain(c);
}

/// A stripe has a plain surface before or behind it. The grain of a floor has bright lines, too, but with
/// grain on either side.
bool StripeScan::outshines_grain(std::size_t c) const {
  const Chain& chain = chains_[c];
  LevelCounts before, behind;
  for (std::size_t p = chain.first_peak; p <= chain.last_peak; ++p) {
    if (peaks_[p].chain != c) continue;
    const std::size_t i = peaks_[p].sample, flank = samples_[i].flank;
    const Curve& curve = curves_[peaks_[p].beam];
    for (std::size_t k = flank; k < kBesideFlanks * flank; ++k) {
      if (i >= curve.first + k + flank) before.add(level_difference(levels_[i - k], levels_[i - k - flank]));
      if (i + k + flank < curve.end) behind.add(level_difference(levels_[i + k], levels_[i + k + flank]));
    }
  }
  const int usual = std::min(before.median(), behind.median());
  return chain.contrast >= params_.noise_factor * usual * chain.peaks;
}

/// Chooses the nearest laser return on each beam. A shiny floor mirrors the stripe: fainter, and before it.
void StripeScan::choose_nearest() {
  for (Beam& beam : beams_) {
    beam.range_m = 0;
    beam.may_be_shut = false;
  }
  brightest_.assign(beams_.size(), 0);
  contrast_.assign(beams_.size(), 0);
  for (std::size_t p = peaks_.size(); p-- > 0;) {
    const Peak& peak = peaks_[p];
    if (!chains_[peak.chain].is_stripe) continue;
    int& brightest = brightest_[peak.beam];
    if (peak.contrast >= params_.mirrored_share * brightest) {
      beams_[peak.beam].range_m = static_cast<float>(peak.range_m);
      contrast_[peak.beam] = peak.contrast;
    }
    brightest = std::max(brightest, peak.contrast);
  }
  sees_light_ = std::any_of(chains_.begin(), chains_.end(),
                            [&](const Chain& chain) { return chain.beams >= params_.lit_beams_min; });
}

/// A wall goes on where its stripe is too faint to be seen, or below the image.
void StripeScan::mark_uncertain_beyond_ends() {
  const int beams = static_cast<int>(beams_.size());
  for (int beam = 0; beam < beams; ++beam) {
    if (beams_[static_cast<std::size_t>(beam)].range_m == 0) continue;
    if (beam + 1 < beams && beams_[static_cast<std::size_t>(beam) + 1].range_m == 0)
      mark_uncertain_beyond(beam, 1);
    if (beam > 0 && beams_[static_cast<std::size_t>(beam) - 1].range_m == 0) mark_uncertain_beyond(beam, -1);
  }
}

/// Marks the beams without a return that cross the straight continuation of the stripe.
void StripeScan::mark_uncertain_beyond(int end, int outwards) {
  const int beams = beams_of_wall(end, -outwards);
  if (beams < params_.beams_min || !goes_on_unseen(end, -outwards, beams)) return;
  const Vec2 p_end = hit(end), along = p_end - hit(end - outwards * (beams - 1));
  for (int k = end + outwards; k >= 0 && k < static_cast<int>(beams_.size()); k += outwards) {
    Beam& beam = beams_[static_cast<std::size_t>(k)];
    const Vec2 towards = unit(first_angle_rad_ + k * kStep_rad);
    const double crossing_m = cross(p_end, along) / cross(towards, along);
    if (beam.range_m > 0 || !(crossing_m > 0) || crossing_m > params_.sure_reach_m) return;
    beam.may_be_shut = true;
  }
}

/// Whether the stripe is faint at its end, or the image ends there.
bool StripeScan::goes_on_unseen(int end, int inwards, int beams) const {
  const Beam& last = beams_[static_cast<std::size_t>(end)];
  if (last.range_m < last.near_m + kNearEdge_m) return true;
  int faintest = contrast_[static_cast<std::size_t>(end)];
  for (int i = 1; i < std::min(beams, kEndBeams); ++i)
    faintest = std::min(faintest, contrast_[static_cast<std::size_t>(end + i * inwards)]);
  return faintest < kFaint * contrast_min_;
}

/// How many beams from the stripe's end inwards hit the same wall, at most kWallBeams.
int StripeScan::beams_of_wall(int end, int inwards) const {
  int beams = 1;
  for (; beams < kWallBeams; ++beams) {
    const int next = end + beams * inwards;
    if (next < 0 || next >= static_cast<int>(beams_.size())) break;
    const double range_m = beams_[static_cast<std::size_t>(next)].range_m;
    const double before_m = beams_[static_cast<std::size_t>(next - inwards)].range_m;
    if (std::abs(range_m - before_m) > kWallStep * before_m) break;
  }
  return beams;
}

Vec2 StripeScan::hit(int beam) const {
  return beams_[static_cast<std::size_t>(beam)].range_m * unit(first_angle_rad_ + beam * kStep_rad);
}

void StripeScan::append_lit(std::vector<Vec2>& p_vehicle_returns) const {
  for (std::size_t beam = 0; beam < beams_.size(); ++beam) {
    if (beams_[beam].range_m > 0 && beams_[beam].range_m <= params_.sure_reach_m)
      p_vehicle_returns.push_back(T_vehicle_fan_ * hit(static_cast<int>(beam)));
  }
}

bool StripeScan::is_free(const Vec2& p_vehicle) const {
  const Vec2 p_fan = T_vehicle_fan_.inverse() * p_vehicle;
  const double away_m = p_fan.norm();
  const long k = std::lround((std::atan2(p_fan.y(), p_fan.x()) - first_angle_rad_) / kStep_rad);
  if (!sees_light_ || k < 0 || k >= static_cast<long>(beams_.size())) return false;
  const Beam& beam = beams_[static_cast<std::size_t>(k)];
  if (beam.may_be_shut || away_m < beam.near_m || away_m > std::min<double>(beam.far_m, params_.sure_reach_m))
    return false;
  return beam.range_m == 0 || away_m + kBefore_m < beam.range_m;
}

}  // namespace aisle
