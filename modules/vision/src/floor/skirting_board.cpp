#include "floor/skirting_board.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace aisle {
namespace {

constexpr double kBinLeast = 0.004;              // of the depth beneath the horizon
constexpr int kHighestBin = 136;                 // at most, beneath the upper edge of the highest board
constexpr int kReachLeast = 4, kReachMost = 12;  // bins: half of what a step must last ...
constexpr double kReach_rows = 1.5;              // ... and no less than its blur
constexpr int kBinsMost = kHighestBin + 2 * kReachMost;  // above a line, and as many beneath it
constexpr double kHighest = 0.8;                         // of the camera's height
constexpr double kBoardLeast_m = 0.03;                   // lower boards are ignored
constexpr int kSettleBins = 3;  // in which a step's steepest place is; of one far beneath the upper edge ...
constexpr int kSettlePart =
    6;  // ... within this part of the distance to it, as its blur may be clear only lower
constexpr std::size_t kParts = 4;        // of a line
constexpr double kPartContrast = 0.5;    // share of the least contrast that each part must show
constexpr double kSeenColumnsMin = 0.5;  // share of the line's columns in which its floor point can be seen

/// Bins of depth, each as much deeper than the one before as a share of its depth: whatever runs along a wall
/// at one height is in one bin in every column.
class DepthBins {
 public:
  explicit DepthBins(const SkirtingBoardParams& params)
      : camera_height_m_(params.camera_height_m),
        height_max_m_(std::min(params.height_max_m, kHighest * params.camera_height_m)),
        size_(std::max(kBinLeast, log_depth(height_max_m_) / kHighestBin)),
        count_(std::min(bin_of(height_max_m_) + 2 * kReachMost, kBinsMost)) {
    for (int bin = -count_; bin < count_; ++bin)
      shares_[static_cast<std::size_t>(bin + count_)] = std::exp((bin + 0.5) * size_);
  }

  double height_max_m() const { return height_max_m_; }
  double size() const { return size_; }
  /// Above a line, and as many beneath it.
  int count() const { return count_; }
  /// A bin's middle as a share of the line's depth.
  double share(int bin) const { return shares_[static_cast<std::size_t>(bin + count_)]; }
  /// The bin in which a height above a floor point is seen; positive: the floor point beneath an upper edge
  /// of that height.
  int bin_of(double height_m) const { return static_cast<int>(std::lround(log_depth(height_m) / size_)); }

 private:
  double log_depth(double height_m) const {
    return std::log(camera_height_m_ / (camera_height_m_ - height_m));
  }

  double camera_height_m_, height_max_m_;
  double size_;
  int count_;
  std::array<double, std::size_t{2} * kBinsMost> shares_{};
};

/// Mean brightness by height above and beneath a line.
class BandProfile {
 public:
  /// @param depth  of the line, in its middle
  BandProfile(const DepthBins& bins, double depth)
      : bins_(&bins),
        reach_(std::clamp(static_cast<int>(std::ceil(kReach_rows / (depth * bins.size()))), kReachLeast,
                          kReachMost)) {}

  int reach() const { return reach_; }

  void add(const LevelView& view, int column, double depth) {
    const LevelView::Rows seen = view.seen(column);
    const std::uint8_t* grey = view.column(column);
    for (int bin = -bins_->count(); bin < bins_->count(); ++bin) {
      const int row = static_cast<int>(std::floor(depth * bins_->share(bin) - view.depth(0) + 0.5));
      if (row < seen.first || row >= seen.end) continue;
      sums_[index(bin)] += grey[row];
      ++counts_[index(bin)];
    }
  }

  void add(const BandProfile& part) {
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      sums_[i] += part.sums_[i];
      counts_[i] += part.counts_[i];
    }
  }

  int count(int bin) const { return counts_[index(bin)]; }

  /// The same without bright parts thinner than the sides of a lasting step, such as laser light on a wall: a
  /// morphological opening.
  BandProfile without_thin_lights() const {
    const auto end = std::size_t{2} * static_cast<std::size_t>(bins_->count());
    const auto width = std::size_t{2} * static_cast<std::size_t>(reach_);
    std::array<double, std::size_t{2} * kBinsMost> opened{};
    for (std::size_t first = 0; first + width <= end; ++first) {
      const double darkest = darkest_of(first, first + width);
      for (std::size_t i = first; i < first + width; ++i) opened[i] = std::max(opened[i], darkest);
    }
    BandProfile without(*this);
    for (std::size_t i = 0; i < end; ++i) without.sums_[i] = counts_[i] * opened[i];
    return without;
  }

  /// How much brighter it lastingly is above the lower border of a bin than beneath; 0: no lasting step.
  double step(int bin) const {
    const auto far = mean(bin - reach_, bin), farther = mean(bin - 2 * reach_, bin - reach_);
    const auto near = mean(bin, bin + reach_), nearer = mean(bin + reach_, bin + 2 * reach_);
    if (!far || !farther || !near || !nearer) return 0;
    const double brighter = std::min(*far, *farther) - std::max(*near, *nearer);
    const double darker = std::min(*near, *nearer) - std::max(*far, *farther);
    return brighter > 0 ? brighter : -std::max(0.0, darker);
  }

  int clearest(int first, int last) const {
    int best = first;
    for (int bin = first + 1; bin <= last; ++bin)
      if (std::abs(step(bin)) > std::abs(step(best))) best = bin;
    return best;
  }

  /// The steepest place of a step, in bins.
  double settled(int bin) const {
    const double sign = step(bin) < 0 ? -1 : 1;
    const auto steepness = [&](int at) {
      return sign * (mean(at - 2, at).value_or(0) - mean(at, at + 2).value_or(0));
    };
    int steepest = bin;
    const int around = std::max(kSettleBins, std::min(reach_, bin / kSettlePart));
    for (int at = bin - around; at <= bin + around; ++at)
      if (steepness(at) > steepness(steepest)) steepest = at;
    const double above = steepness(steepest - 1), here = steepness(steepest),
                 beneath = steepness(steepest + 1);
    const double bend = above - 2 * here + beneath;
    return steepest + (bend < 0 ? std::clamp(0.5 * (above - beneath) / bend, -0.5, 0.5) : 0);
  }

 private:
  std::size_t index(int bin) const { return static_cast<std::size_t>(bin + bins_->count()); }

  /// Of the bins that are seen; 0 if none is.
  double darkest_of(std::size_t first, std::size_t end) const {
    std::optional<double> darkest;
    for (std::size_t i = first; i < end; ++i) {
      if (counts_[i] > 0) darkest = std::min(darkest.value_or(255), sums_[i] / counts_[i]);
    }
    return darkest.value_or(0);
  }

  std::optional<double> mean(int first, int end) const {
    if (first < -bins_->count() || end > bins_->count()) return std::nullopt;
    double sum = 0;
    int count = 0;
    for (int bin = first; bin < end; ++bin) {
      sum += sums_[index(bin)];
      count += counts_[index(bin)];
    }
    if (count == 0) return std::nullopt;
    return sum / count;
  }

  const DepthBins* bins_;
  int reach_;
  std::array<double, std::size_t{2} * kBinsMost> sums_{};
  std::array<int, std::size_t{2} * kBinsMost> counts_{};
};

/// All of a line, and its parts from left to right.
struct LineProfiles {
  BandProfile whole;
  std::array<BandProfile, kParts> parts;
  int columns = 0;
};

LineProfiles profiles_of(const LevelView& view, const FloorLine& line, const DepthBins& bins) {
  const BandProfile none(bins, view.depth(line.row_middle));
  LineProfiles profiles{none, {none, none, none, none}, 0};
  const int first = static_cast<int>(line.first_column), last = static_cast<int>(line.last_column);
  profiles.columns = last - first + 1;
  for (int column = first; column <= last; ++column) {
    const int part = static_cast<int>(kParts) * (column - first) / profiles.columns;
    profiles.parts[static_cast<std::size_t>(part)].add(view, column, view.depth(line.row_at(column)));
  }
  for (const BandProfile& part : profiles.parts) profiles.whole.add(part);
  return profiles;
}

/// The bin of the clearest step beneath the line at a board's height, if it is clear, clearer than all above
/// it, and there in every part of the line.
std::optional<int> floor_point_bin(const LineProfiles& profiles, const DepthBins& bins, double contrast_min) {
  const BandProfile& whole = profiles.whole;
  const int highest = bins.bin_of(kBoardLeast_m), lowest = bins.bin_of(bins.height_max_m());
  const int floor_point =
      whole.clearest(highest, lowest + whole.reach());  // a blurred step is clear a little lower
  const double contrast = whole.step(floor_point);
  const BandProfile lasting = whole.without_thin_lights();
  const double above = lasting.step(lasting.clearest(-lowest, -highest));
  if (std::abs(contrast) < contrast_min || std::abs(above) > std::abs(contrast) ||
      whole.count(floor_point) < kSeenColumnsMin * profiles.columns)
    return std::nullopt;
  const bool is_everywhere =
      std::all_of(profiles.parts.begin(), profiles.parts.end(), [&](const BandProfile& part) {
        return part.count(floor_point) == 0 ||
               std::copysign(1.0, contrast) * part.step(floor_point) > kPartContrast * contrast_min;
      });
  if (!is_everywhere) return std::nullopt;
  return floor_point;
}

}  // namespace

std::optional<FloorLine> floor_point_beneath(const LevelView& view, const FloorLine& line,
                                             const SkirtingBoardParams& params) {
  const DepthBins bins(params);
  if (bins.height_max_m() <= kBoardLeast_m || line.contrast < 0) return std::nullopt;
  const LineProfiles profiles = profiles_of(view, line, bins);
  const auto floor_point = floor_point_bin(profiles, bins, params.contrast_min);
  if (!floor_point) return std::nullopt;
  const double ratio = std::exp(profiles.whole.settled(*floor_point) * bins.size());
  FloorLine lower = line;
  lower.row_middle = ratio * view.depth(line.row_middle) - view.depth(0);
  lower.slope *= ratio;
  lower.sigma_row *= ratio;
  lower.sigma_slope *= ratio;
  lower.contrast = profiles.whole.step(*floor_point);
  return lower;
}

}  // namespace aisle
