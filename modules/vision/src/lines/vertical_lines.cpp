#include "aisle/vision/lines/vertical_lines.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "aisle/core/square.hpp"
#include "lines/edge_chains.hpp"
#include "lines/straight_pieces.hpp"
#include "lines/vertical_tilt.hpp"
#include "working_image.hpp"

namespace aisle {

void VerticalLineParams::describe(FieldList& fields) {
  fields.count("width_max_px", width_max_px, {64, 4096}, "wider images are shrunk to this");
  fields.count("bands", bands, {20, 1000}, "of rows, in each of which a line is one step of brightness");
  fields.real("contrast_min", contrast_min, {0.5, 100}, "grey levels of the faintest step");
  fields.real("stray_px", stray_px, {0.3, 10}, "from band to band a line strays no farther from its course");
  fields.real("straight_px", straight_px, {0.2, 10}, "a line is cut where it bends by more");
  fields.real("slope_max", slope_max, {0.02, 1}, "columns per row of the most inclined line");
  fields.real("tilt_deviation_max", tilt_deviation_max, {0.01, 1},
              "columns per row by which a line may miss the vertical vanishing point");
  fields.real("gap_share_max", gap_share_max, {0, 1}, "longest gap in a line, as a share of the height");
  fields.real("fade_share", fade_share, {0, 1}, "ends fainter than this share of a line's contrast are cut");
  fields.real("length_share_min", length_share_min, {0.02, 1}, "shortest line, as a share of the height");
  fields.real("fill_min", fill_min, {0, 1}, "least share of a line on which its step is seen");
  fields.real("score_min", score_min, {0, 1},
              "of length, contrast and fill, each at most 1, and less in faint images");
  fields.real("usual_score_min", usual_score_min, {0, 1},
              "an image's good lines count as no fainter than this, when its others are judged by them");
  fields.real("apart_px", apart_px, {0, 50}, "of lines closer than this the stronger remains");
}

namespace {

constexpr double kNominalWidth_px = 640;
constexpr double kChainShareMin = 0.03;  // shortest piece of a line, as a share of the bands
constexpr double kSteepestLink = 0.1;    // by which a chain may be steeper than a line before it is fitted
constexpr double kTiltShareMin = 0.12;   // shortest line that is used for the tilt, as a share of the height
constexpr double kSlopeSlack_px = 1.6;   // a short line's slope is uncertain by this over its length
constexpr double kOppositeShare = 0.75;  // of apart_px, between the two sides of a thin bar
constexpr double kBesideShare = 0.6;     // of its length a line is beside another to be its double
constexpr double kContrastCounted = 40;  // more contrast makes no line stronger
constexpr double kLongShare = 0.3;       // of the height: a line this long has most of the score for length
constexpr double kContrastClear =
    20;  // grey levels: a line of this contrast has most of the score for contrast
constexpr double kEyeLevelTop = 0.3, kEyeLevelBottom = 0.6;  // of the height: there the horizon is expected
constexpr std::ptrdiff_t kBestLines = 2, kGoodLines = 6;     // of an image, by which its others are judged
constexpr double kOffEyeLevel = 0.7;  // score of a line wholly above or below: lamp, bottle, gap in the floor
constexpr int kSmallest_px = 16;      // images smaller than this show no lines

}  // namespace

class VerticalLineDetector::Work {
 public:
  Work(const VerticalLineParams& params, const std::optional<CameraModel>& camera)
      : params_(params), image_(params.width_max_px, camera) {}

  const std::vector<VerticalLine>& detect(const Image& grey) {
    verticals_.clear();
    image_.look_at(grey);
    if (image_.width_px() < kSmallest_px || image_.height_px() < kSmallest_px) return verticals_;
    linker_.link(image_.grey(), link_params());
    cutter_.cut(linker_, piece_params(), lines_);
    keep_leaning_alike();
    keep_strong();
    keep_apart();
    for (const UprightLine& line : lines_) report(line);
    std::sort(verticals_.begin(), verticals_.end(), [](const VerticalLine& a, const VerticalLine& b) {
      return std::pair(a.bottom_px.x(), a.top_px.y()) < std::pair(b.bottom_px.x(), b.top_px.y());
    });
    return verticals_;
  }

 private:
  /// The working image's width as a share of the width that lengths in the parameters apply to.
  double width_share() const { return image_.width_px() / kNominalWidth_px; }
  int height_px() const { return image_.height_px(); }
  int band_rows() const {
    return std::clamp(static_cast<int>(std::lround(1.0 * height_px() / params_.bands)), 2, 32);
  }

  LinkParams link_params() const {
    return {band_rows(), params_.contrast_min, params_.stray_px, params_.slope_max + kSteepestLink,
            params_.slope_max};
  }

  PieceParams piece_params() const {
    PieceParams piece;
    piece.band_rows = band_rows();
    piece.count_min = static_cast<std::size_t>(std::max(4.0, kChainShareMin * height_px() / band_rows()));
    piece.straight_px = std::max(0.9, params_.straight_px * width_share());
    piece.slope_max = params_.slope_max;
    piece.gap_max_px = params_.gap_share_max * height_px();
    piece.fade_share = params_.fade_share;
    piece.width_share = std::max(0.8, width_share());
    return piece;
  }

  void keep_leaning_alike() {
    std::erase_if(lines_, [this](const UprightLine& line) { return line.fill < params_.fill_min; });
    std::sort(lines_.begin(), lines_.end(), [](const UprightLine& a, const UprightLine& b) {
      return std::pair(-a.length_px(), a.u_middle_px) < std::pair(-b.length_px(), b.u_middle_px);
    });
    const auto short_one = std::find_if(lines_.begin(), lines_.end(), [this](const UprightLine& line) {
      return line.length_px() < kTiltShareMin * height_px();
    });
    const VerticalTilt tilt = estimate_tilt({lines_.begin(), short_one}, image_.width_px());
    std::erase_if(lines_, [&](const UprightLine& line) {
      const double off = std::abs(line.slope - tilt.slope_at(line.u_middle_px, image_.width_px()));
      return off > params_.tilt_deviation_max + kSlopeSlack_px / line.length_px();
    });
  }

  void keep_strong() {
    scores_.clear();
    for (const UprightLine& line : lines_) scores_.push_back(score(line));
    std::sort(scores_.begin(), scores_.end(), std::greater<>());
    const double least = params_.score_min * std::sqrt(usual_score());
    std::erase_if(lines_, [&](const UprightLine& line) {
      return line.length_px() < params_.length_share_min * height_px() || score(line) < least;
    });
  }

  /// Usual contrast of an image's good lines without the very best: faint images have faint ones.
  double usual_score() const {
    const auto first = scores_.begin() + std::min(kBestLines, std::ssize(scores_));
    const auto last = scores_.begin() + std::min(kBestLines + kGoodLines, std::ssize(scores_));
    if (first == last) return 1;
    return std::max(params_.usual_score_min,
                    std::accumulate(first, last, 0.0) / static_cast<double>(last - first));
  }

  /// How surely a line stands in the building: long, of high contrast and without gaps. What stands on the
  /// floor and is higher than the camera crosses the horizon.
  double score(const UprightLine& line) const {
    const auto saturated = [](double share) { return 1 - std::exp(-share); };
    const bool at_eye_level =
        line.v_top_px < kEyeLevelBottom * height_px() && line.v_bottom_px > kEyeLevelTop * height_px();
    return saturated(line.length_px() / height_px() / kLongShare) *
           saturated(line.contrast / kContrastClear) * line.fill * square(line.fill) *
           (at_eye_level ? 1 : kOffEyeLevel);
  }

  /// The two edges of a door's gap or a thin bar are one landmark.
  void keep_apart() {
    const auto strength = [](const UprightLine& line) {
      return line.length_px() * std::min(line.contrast, kContrastCounted);
    };
    std::sort(lines_.begin(), lines_.end(), [&](const UprightLine& a, const UprightLine& b) {
      return std::pair(-strength(a), a.u_middle_px) < std::pair(-strength(b), b.u_middle_px);
    });
    std::size_t kept = 0;
    for (const UprightLine& line : lines_) {
      const auto end = lines_.begin() + static_cast<std::ptrdiff_t>(kept);
      const bool doubled = std::any_of(lines_.begin(), end,
                                       [&](const UprightLine& stronger) { return doubles(line, stronger); });
      if (!doubled) lines_[kept++] = line;
    }
    lines_.resize(kept);
  }

  bool doubles(const UprightLine& line, const UprightLine& stronger) const {
    const double top_px = std::max(line.v_top_px, stronger.v_top_px);
    const double bottom_px = std::min(line.v_bottom_px, stronger.v_bottom_px);
    if (bottom_px - top_px < kBesideShare * line.length_px()) return false;
    const double apart_px =
        params_.apart_px * width_share() * (line.step == stronger.step ? 1 : kOppositeShare);
    return std::abs(line.u_at(top_px) - stronger.u_at(top_px)) < apart_px &&
           std::abs(line.u_at(bottom_px) - stronger.u_at(bottom_px)) < apart_px;
  }

  void report(const UprightLine& line) {
    const auto top_px = image_.given({line.u_at(line.v_top_px), line.v_top_px});
    const auto bottom_px = image_.given({line.u_at(line.v_bottom_px), line.v_bottom_px});
    if (!top_px || !bottom_px) return;
    const double sign = line.step == Step::kBrighter ? 1 : -1;
    verticals_.push_back({*top_px, *bottom_px, sign * line.contrast, false});
  }

  VerticalLineParams params_;
  WorkingImage image_;
  EdgeLinker linker_;
  PieceCutter cutter_;
  std::vector<UprightLine> lines_;
  std::vector<double> scores_;
  std::vector<VerticalLine> verticals_;
};

VerticalLineDetector::VerticalLineDetector(const VerticalLineParams& params,
                                           const std::optional<CameraModel>& camera)
    : work_(std::make_unique<Work>(params, camera)) {}
VerticalLineDetector::VerticalLineDetector(VerticalLineDetector&&) noexcept = default;
VerticalLineDetector::~VerticalLineDetector() = default;

const std::vector<VerticalLine>& VerticalLineDetector::detect(const Image& grey) {
  return work_->detect(grey);
}

}  // namespace aisle
