#include "detection/check_words.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "aisle/core/angle.hpp"
#include "aisle/core/rounded.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kShareDecimals = 3;

struct HintWords {
  const char* key;
  const char* text;
};

HintWords words_of(ViewHint hint) {
  switch (hint) {
    case ViewHint::kMoreImages:
      return {"more_images", "give more images, of all the places and of the light it will drive in"};
    case ViewHint::kLensUnknown:
      return {"lens_unknown",
              "calibrate the lens (aisle calibrate camera) and give it with --calibration: a lens bends "
              "lines, and "
              "a wide one moves wall-floor edges by pixels without losing them"};
    case ViewHint::kSmall:
      return {"small", "take larger images: 320 columns or more, 640 are enough"};
    case ViewHint::kDark:
      return {"dark", "more light or a longer exposure: much of the images is black"};
    case ViewHint::kBright:
      return {"bright",
              "a shorter exposure, or keep lamps and windows out of view: much of the images is burnt out"};
    case ViewHint::kFlat:
      return {"flat", "more contrast (light, exposure, a clean lens): dark and bright are close together"};
    case ViewHint::kBlurAcross:
      return {"blur_across",
              "focus, a shorter exposure or slower turning: the images are blurred sideways, which "
              "hides vertical lines"};
    case ViewHint::kBlurDown:
      return {"blur_down",
              "focus, a shorter exposure or a stiffer mount: the images are blurred up and down, which "
              "hides wall-floor edges"};
    case ViewHint::kLooksUp:
      return {"looks_up",
              "tilt the camera down, or mount it higher: the corridor's end is low in the images, so "
              "little floor is in view"};
    case ViewHint::kLooksDown:
      return {"looks_down",
              "tilt the camera up: the corridor's end is high in the images, so walls are cut off"};
    case ViewHint::kNods:
      return {"nods",
              "fix the camera's mount, or check a corridor alone: the corridor's end is at other rows from "
              "image to image"};
    case ViewHint::kRolled:
      return {"rolled", "level the camera: vertical lines in its middle lean to one side"};
    case ViewHint::kFeetUnseen:
      return {"feet_unseen",
              "tilt the camera down, or mount it higher: vertical lines are seen, but not where they "
              "stand on the floor"};
    case ViewHint::kFloorUnclear:
      return {"floor_unclear",
              "look at the overlays: floor and walls may look alike, the floor may mirror the walls, "
              "or be patterned; light from above rather than from the far end helps"};
    case ViewHint::kOneSided:
      return {"one_sided",
              "turn the camera to the corridor's middle: wall-floor edges are seen on one side alone"};
  }
  throw std::invalid_argument("no such hint");
}

const char* key_of(ViewVerdict verdict) {
  switch (verdict) {
    case ViewVerdict::kSeen:
      return "seen";
    case ViewVerdict::kDoubtful:
      return "doubtful";
    case ViewVerdict::kNotSeen:
      return "not_seen";
    case ViewVerdict::kNotJudged:
      return "not_judged";
  }
  throw std::invalid_argument("no such verdict");
}

const char* words_of(ViewVerdict verdict) {
  switch (verdict) {
    case ViewVerdict::kSeen:
      return "seen, as far as images alone tell";
    case ViewVerdict::kDoubtful:
      return "doubtful";
    case ViewVerdict::kNotSeen:
      return "not seen well enough";
    case ViewVerdict::kNotJudged:
      return "not judged: too few images";
  }
  throw std::invalid_argument("no such verdict");
}

struct NamedCheck {
  const char* key;
  const char* words;
  FeatureCheck ViewCheck::*check;
};

constexpr std::array kFeatures = {
    NamedCheck{"right_wall_floor_edge", "wall-floor edge on the right", &ViewCheck::right_edge},
    NamedCheck{"left_wall_floor_edge", "wall-floor edge on the left", &ViewCheck::left_edge},
    NamedCheck{"vertical_lines", "vertical lines", &ViewCheck::verticals},
    NamedCheck{"floor_points", "where they stand on the floor", &ViewCheck::floor_points},
    NamedCheck{"free_floor", "free floor", &ViewCheck::floor}};

constexpr std::array kMethods = {
    NamedCheck{"landmarks", "landmarks (vertical lines and where they stand)", &ViewCheck::landmarks},
    NamedCheck{"sections", "sections (a wall-floor edge on either side)", &ViewCheck::sections},
    NamedCheck{"rooms", "rooms (free floor)", &ViewCheck::rooms}};

constexpr std::array kNotJudged = {
    "whether what is seen is right: nobody labelled these images. A thing found in the wrong place every "
    "time looks "
    "consistent; look at the overlays",
    "how high the camera is, and its mount: aisle calibrate floor measures them",
    "laser stripes: any bright stripe may be one; aisle detect stripes shows what would be taken for it"};

Json share_json(double share) {
  return rounded(share, kShareDecimals);
}

Json share_json(const std::optional<double>& share) {
  return share ? share_json(*share) : Json(nullptr);
}

Json degrees_json(const std::optional<double>& angle_rad) {
  return angle_rad ? Json(rounded(to_degrees(*angle_rad), 1)) : Json(nullptr);
}

Json feature_json(const FeatureCheck& check) {
  return {{"verdict", key_of(check.verdict)},
          {"images", check.images},
          {"good", check.good},
          {"share_low", share_json(check.share_low)},
          {"share_high", share_json(check.share_high)}};
}

Json features_json(const ViewCheck& check, std::span<const NamedCheck> named) {
  Json json = Json::object();
  for (const NamedCheck& feature : named) json[feature.key] = feature_json(check.*feature.check);
  return json;
}

Json quality_json(const ImageQuality& quality) {
  return {{"dark_share", share_json(quality.dark_share)},
          {"bright_share", share_json(quality.bright_share)},
          {"contrast", quality.contrast},
          {"blur_across", share_json(quality.blur_across)},
          {"blur_down", share_json(quality.blur_down)}};
}

Json steadiness_json(const SteadinessCheck& steadiness) {
  return {{"pairs", steadiness.pairs},
          {"edges", steadiness.edges},
          {"edges_stayed", steadiness.edges_stayed},
          {"verticals", steadiness.verticals},
          {"verticals_followed", steadiness.verticals_followed},
          {"floor_overlap", steadiness.pairs > 0 ? share_json(steadiness.floor_overlap) : Json(nullptr)}};
}

std::string feature_lines(const ViewCheck& check, std::span<const NamedCheck> named) {
  std::string text;
  for (const NamedCheck& feature : named) {
    const FeatureCheck& of = check.*feature.check;
    text +=
        fmt::format("  {:<50} {:>4} of {:<4} {}\n", feature.words, of.good, of.images, words_of(of.verdict));
  }
  return text;
}

std::string steadiness_line(const SteadinessCheck& steadiness) {
  if (steadiness.pairs == 0)
    return "  from image to image: not judged, no two images in a row show nearly the same\n";
  return fmt::format(
      "  from image to image ({} pairs that show nearly the same): {} of {} edges stay, {} of {} vertical "
      "lines are "
      "followed, free floor overlaps by {:.2f}\n",
      steadiness.pairs, steadiness.edges_stayed, steadiness.edges, steadiness.verticals_followed,
      steadiness.verticals, steadiness.floor_overlap);
}

std::string horizon_line(const ViewMedians& medians, const CheckScope& scope) {
  if (!medians.horizon) return "  the corridor's end: not found, or the images are of several sizes\n";
  std::string tilt = "camera tilt not judged without the lens";
  if (scope.tilt_rad)
    tilt = fmt::format("camera looks {:.1f} degrees {}", std::abs(to_degrees(*scope.tilt_rad)),
                       *scope.tilt_rad < 0 ? "up" : "down");
  return fmt::format(
      "  the corridor's end is at {:.0f} % of the height from above, in half of the images within "
      "{:.0f} %; {}\n",
      100 * *medians.horizon, 100 * *medians.horizon_range, tilt);
}

std::string measured_lines(const ViewCheck& check, const CheckScope& scope) {
  const ViewMedians& medians = check.medians;
  const ImageQuality& quality = medians.quality;
  std::string text = fmt::format(
      "  light: {:.1f} % black, {:.1f} % burnt out, {:.0f} grey levels from dark to bright\n"
      "  blur (0 sharp, 1 nothing sharp): {:.2f} sideways, {:.2f} up and down\n",
      100 * quality.dark_share, 100 * quality.bright_share, quality.contrast, quality.blur_across,
      quality.blur_down);
  text += horizon_line(medians, scope);
  if (medians.lean_rad)
    text +=
        fmt::format("  vertical lines in the middle lean by {:.1f} degrees\n", to_degrees(*medians.lean_rad));
  text += fmt::format(
      "  vertical lines: {:.0f}, {:.0f} of them with a floor point; {:.0f} % found again in the same image "
      "smaller and darker\n",
      medians.verticals, medians.standing, 100 * medians.found_again_share);
  text += fmt::format(
      "  free floor: {:.0f} % of the image, {:.0f} % of it in the left half, {:.0f} % beyond a wall-floor "
      "edge, "
      "{:.0f} % above the corridor's end; overlaps by {:.2f} with that of the image smaller and darker\n",
      100 * medians.floor_share, 100 * medians.floor_left_share, 100 * medians.floor_beyond_edges,
      100 * medians.floor_above_end, medians.floor_overlap);
  return text + steadiness_line(check.steadiness);
}

}  // namespace

Json view_check_json(const ViewCheck& check, const CheckScope& scope) {
  const ViewMedians& medians = check.medians;
  Json hints = Json::array();
  for (const ViewHint hint : check.hints)
    hints.push_back({{"key", words_of(hint).key}, {"text", words_of(hint).text}});
  return {{"found", scope.found},
          {"checked", scope.checked},
          {"left_out", scope.left_out},
          {"lens_known", scope.is_lens_known},
          {"features", features_json(check, kFeatures)},
          {"methods", features_json(check, kMethods)},
          {"medians",
           {{"width_px", medians.width_px},
            {"height_px", medians.height_px},
            {"quality", quality_json(medians.quality)},
            {"horizon", share_json(medians.horizon)},
            {"horizon_range", share_json(medians.horizon_range)},
            {"tilt_deg", degrees_json(scope.tilt_rad)},
            {"lean_deg", degrees_json(medians.lean_rad)},
            {"verticals", medians.verticals},
            {"floor_points", medians.standing},
            {"verticals_found_again", share_json(medians.found_again_share)},
            {"floor_share", share_json(medians.floor_share)},
            {"floor_left_share", share_json(medians.floor_left_share)},
            {"floor_above_end", share_json(medians.floor_above_end)},
            {"floor_beyond_edges", share_json(medians.floor_beyond_edges)},
            {"floor_overlap", share_json(medians.floor_overlap)}}},
          {"steadiness", steadiness_json(check.steadiness)},
          {"hints", std::move(hints)},
          {"not_judged", kNotJudged}};
}

Json evidence_json(const ImageEvidence& evidence, const GoodViews& views) {
  const auto edge = [](const EdgeEvidence& of, bool is_good) -> Json {
    return {{"found", of.is_found},
            {"found_again", of.is_found_again},
            {"floor_beneath", share_json(of.floor_beneath)},
            {"wall_above", share_json(of.wall_above)},
            {"good", is_good}};
  };
  return {{"width_px", evidence.width_px},
          {"height_px", evidence.height_px},
          {"quality", quality_json(evidence.quality)},
          {"right_edge", edge(evidence.right, views.right_edge)},
          {"left_edge", edge(evidence.left, views.left_edge)},
          {"horizon", evidence.vanishing_point ? share_json(evidence.vanishing_point->y()) : Json(nullptr)},
          {"verticals",
           {{"found", evidence.verticals},
            {"in_left_half", evidence.verticals_left},
            {"found_again", evidence.found_again},
            {"floor_points", evidence.standing},
            {"good", views.verticals},
            {"floor_points_good", views.floor_points}}},
          {"floor",
           {{"share", share_json(evidence.floor_share)},
            {"left_share", share_json(evidence.floor_left_share)},
            {"above_end", share_json(evidence.floor_above_end)},
            {"beyond_edges", share_json(evidence.floor_beyond_edges)},
            {"overlap", share_json(evidence.floor_overlap)},
            {"good", views.floor}}}};
}

std::string view_check_text(const ViewCheck& check, const CheckScope& scope) {
  std::string text = fmt::format("{} images", scope.checked);
  if (scope.checked + scope.left_out < scope.found) text += fmt::format(", evenly chosen of {}", scope.found);
  if (scope.left_out > 0) text += fmt::format(", {} left out", scope.left_out);
  text += fmt::format(", lens {}\n\nSeen in\n", scope.is_lens_known ? "known" : "unknown");
  text += feature_lines(check, kFeatures);
  text += "\nEnough to drive by\n" + feature_lines(check, kMethods);
  text += "\nMeasured (medians)\n" + measured_lines(check, scope);
  if (!check.hints.empty()) text += "\nHints: what would probably help (not measured)\n";
  for (const ViewHint hint : check.hints) text += fmt::format("  - {}\n", words_of(hint).text);
  text += "\nNot judged\n";
  for (const char* what : kNotJudged) text += fmt::format("  - {}\n", what);
  return text;
}

}  // namespace aisle
