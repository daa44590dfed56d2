#include "check/view_hints.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

// What cameras of labelled images have that see features well, with room: hints come late rather than always.
constexpr double kHintWidthMin_px = 320;
constexpr double kHintDarkShare = 0.25, kHintBrightShare = 0.15;
constexpr double kHintContrastMin = 70;
constexpr double kHintBlur = 0.5;
constexpr double kHintOften = 0.25;  // of the images
constexpr double kHintHorizonLow = 0.58, kHintHorizonHigh = 0.2;
constexpr double kHintHorizonRange = 0.12;
constexpr double kHintLean_rad = 0.07;
constexpr double kHintOneSided = 0.3;

template <class Is>
bool is_often(std::span<const ImageEvidence> images, const Is& is) {
  const auto count = std::count_if(images.begin(), images.end(), is);
  return static_cast<double>(count) >= kHintOften * static_cast<double>(images.size());
}

bool is_one_sided(const ViewCheck& check) {
  if (check.edges.images < 1 || check.edges.verdict == ViewVerdict::kNotSeen) return false;
  const int more = std::max(check.left_edge.good, check.right_edge.good);
  const int less = std::min(check.left_edge.good, check.right_edge.good);
  return more > 0 && less < kHintOneSided * more;
}

}  // namespace

std::vector<ViewHint> view_hints(const ViewCheck& check, std::span<const ImageEvidence> images,
                                 bool is_lens_known, const ViewCheckParams& params) {
  const ViewMedians& medians = check.medians;
  std::vector<ViewHint> hints;
  const auto add_if = [&](bool is_so, ViewHint hint) {
    if (is_so) hints.push_back(hint);
  };
  const auto of_quality = [&](const auto& is) {
    return is_often(images, [&](const ImageEvidence& image) { return is(image.quality); });
  };
  add_if(static_cast<int>(images.size()) < params.images_min, ViewHint::kMoreImages);
  add_if(!is_lens_known, ViewHint::kLensUnknown);
  add_if(medians.width_px < kHintWidthMin_px, ViewHint::kSmall);
  add_if(of_quality([](const ImageQuality& quality) { return quality.dark_share > kHintDarkShare; }),
         ViewHint::kDark);
  add_if(of_quality([](const ImageQuality& quality) { return quality.bright_share > kHintBrightShare; }),
         ViewHint::kBright);
  add_if(of_quality([](const ImageQuality& quality) { return quality.contrast < kHintContrastMin; }),
         ViewHint::kFlat);
  add_if(of_quality([](const ImageQuality& quality) { return quality.blur_across > kHintBlur; }),
         ViewHint::kBlurAcross);
  add_if(of_quality([](const ImageQuality& quality) { return quality.blur_down > kHintBlur; }),
         ViewHint::kBlurDown);
  add_if(medians.horizon && *medians.horizon > kHintHorizonLow, ViewHint::kLooksUp);
  add_if(medians.horizon && *medians.horizon < kHintHorizonHigh, ViewHint::kLooksDown);
  add_if(medians.horizon_range && *medians.horizon_range > kHintHorizonRange, ViewHint::kNods);
  add_if(medians.lean_rad && std::abs(*medians.lean_rad) > kHintLean_rad, ViewHint::kRolled);
  add_if(check.verticals.good > 0 && 2 * check.floor_points.good < check.verticals.good,
         ViewHint::kFeetUnseen);
  add_if(2 * check.floor.good < check.floor.images, ViewHint::kFloorUnclear);
  add_if(is_one_sided(check), ViewHint::kOneSided);
  return hints;
}

}  // namespace aisle
