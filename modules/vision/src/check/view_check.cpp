#include "aisle/vision/check/view_check.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "aisle/core/median.hpp"
#include "check/view_hints.hpp"

namespace aisle {

void ViewCheckParams::describe(FieldList& fields) {
  fields.count("images_min", images_min, {1, 1000}, "of fewer images nothing is judged");
  fields.real("share_min", share_min, {0, 1},
              "a feature is seen if more images than this share show it, beyond chance; else not");
  fields.count("verticals_min", verticals_min, {1, 100},
               "an image needs so many vertical lines, found again in the same image smaller and darker");
  fields.count("standing_min", standing_min, {1, 100},
               "an image needs so many vertical lines on a wall-floor edge");
  fields.real("floor_beneath_min", floor_beneath_min, {0, 1},
              "a wall-floor edge has free floor beneath it along this share of its length");
  fields.real("horizon_apart_max", horizon_apart_max, {0, 1},
              "how far from its median the row of the corridor's end may be, as a share of the height");
  fields.real("floor_overlap_min", floor_overlap_min, {0, 1},
              "overlap (IoU) of the free floor with that found in the same image smaller and darker");
  fields.real("floor_beyond_max", floor_beyond_max, {0, 1},
              "share of the free floor that may lie on the wall's side of the wall-floor edges");
  fields.real("floor_above_max", floor_above_max, {0, 1},
              "share of the free floor that may be higher in the image than the corridor's end");
  fields.real("floor_share_min", floor_share_min, {0, 1}, "least share of the image that is free floor");
}

namespace {

constexpr double kNormalDeviations = 1.645;  // of 90 % of a normal distribution, both sides

bool is_one_camera(std::span<const ImageEvidence> images) {
  return std::all_of(images.begin(), images.end(), [&](const ImageEvidence& image) {
    return image.width_px == images[0].width_px && image.height_px == images[0].height_px;
  });
}

template <class Value>
double median_over(std::span<const ImageEvidence> images, const Value& value) {
  std::vector<double> values;
  values.reserve(images.size());
  for (const ImageEvidence& image : images) values.push_back(value(image));
  return median(std::move(values));
}

/// Of the corridor's end, where an edge leads to it: from above, as shares of the height, sorted.
std::vector<double> horizon_rows(std::span<const ImageEvidence> images) {
  std::vector<double> rows;
  for (const ImageEvidence& image : images)
    if (image.vanishing_point && (image.left.is_found || image.right.is_found))
      rows.push_back(image.vanishing_point->y());
  std::sort(rows.begin(), rows.end());
  return rows;
}

ViewMedians medians_of(std::span<const ImageEvidence> images) {
  ViewMedians medians;
  const auto over = [&](const auto& value) { return median_over(images, value); };
  medians.width_px = over([](const ImageEvidence& image) { return image.width_px; });
  medians.height_px = over([](const ImageEvidence& image) { return image.height_px; });
  medians.quality.dark_share = over([](const ImageEvidence& image) { return image.quality.dark_share; });
  medians.quality.bright_share = over([](const ImageEvidence& image) { return image.quality.bright_share; });
  medians.quality.contrast = over([](const ImageEvidence& image) { return image.quality.contrast; });
  medians.quality.blur_across = over([](const ImageEvidence& image) { return image.quality.blur_across; });
  medians.quality.blur_down = over([](const ImageEvidence& image) { return image.quality.blur_down; });
  medians.verticals = over([](const ImageEvidence& image) { return image.verticals; });
  medians.standing = over([](const ImageEvidence& image) { return image.standing; });
  medians.found_again_share = over([](const ImageEvidence& image) {
    return image.verticals > 0 ? static_cast<double>(image.found_again) / image.verticals : 0.0;
  });
  medians.floor_share = over([](const ImageEvidence& image) { return image.floor_share; });
  medians.floor_left_share = over([](const ImageEvidence& image) { return image.floor_left_share; });
  medians.floor_above_end = over([](const ImageEvidence& image) { return image.floor_above_end; });
  medians.floor_beyond_edges = over([](const ImageEvidence& image) { return image.floor_beyond_edges; });
  medians.floor_overlap = over([](const ImageEvidence& image) { return image.floor_overlap; });
  std::vector<double> leans_rad;
  for (const ImageEvidence& image : images)
    if (image.lean_rad) leans_rad.push_back(*image.lean_rad);
  if (!leans_rad.empty()) medians.lean_rad = median(std::move(leans_rad));
  if (const auto rows = horizon_rows(images); is_one_camera(images) && !rows.empty()) {
    medians.horizon = rows[rows.size() / 2];
    medians.horizon_range = rows[rows.size() * 3 / 4] - rows[rows.size() / 4];
  }
  return medians;
}

GoodViews good_views(const ImageEvidence& image, const ViewMedians& medians, const ViewCheckParams& params) {
  const bool is_level = !medians.horizon ||
                        (image.vanishing_point &&
                         std::abs(image.vanishing_point->y() - *medians.horizon) <= params.horizon_apart_max);
  const auto is_good_edge = [&](const EdgeEvidence& edge) {
    return edge.is_found && edge.is_found_again && edge.floor_beneath >= params.floor_beneath_min && is_level;
  };
  GoodViews views;
  views.left_edge = is_good_edge(image.left);
  views.right_edge = is_good_edge(image.right);
  views.verticals = image.found_again >= params.verticals_min;
  views.floor_points = image.standing >= params.standing_min;
  // Over a bare carpet the corridor's end is anywhere: it counts where something of a building is seen.
  const bool is_end_known = views.left_edge || views.right_edge || views.verticals;
  views.floor = image.floor_overlap >= params.floor_overlap_min &&
                image.floor_beyond_edges <= params.floor_beyond_max &&
                (!is_end_known || image.floor_above_end <= params.floor_above_max) &&
                image.floor_share >= params.floor_share_min;
  return views;
}

template <class IsGood>
FeatureCheck over_views(const std::vector<GoodViews>& views, const ViewCheckParams& params,
                        const IsGood& is_good) {
  return judged(static_cast<int>(std::count_if(views.begin(), views.end(), is_good)),
                static_cast<int>(views.size()), params);
}

SteadinessCheck steadiness_of(std::span<const PairEvidence> pairs) {
  SteadinessCheck steadiness;
  std::vector<double> overlaps;
  for (const PairEvidence& pair : pairs) {
    if (!pair.is_alike) continue;
    ++steadiness.pairs;
    steadiness.edges += static_cast<int>(pair.left_came) + static_cast<int>(pair.right_came);
    steadiness.edges_stayed += static_cast<int>(pair.left_stayed) + static_cast<int>(pair.right_stayed);
    steadiness.verticals += pair.verticals;
    steadiness.verticals_followed += pair.followed;
    overlaps.push_back(pair.floor_overlap);
  }
  if (!overlaps.empty()) steadiness.floor_overlap = median(std::move(overlaps));
  return steadiness;
}

}  // namespace

FeatureCheck judged(int good, int images, const ViewCheckParams& params) {
  FeatureCheck check{.images = images, .good = good};
  if (images == 0) return check;
  const double n = images, share = good / n, z2 = kNormalDeviations * kNormalDeviations;
  const double middle = (share + z2 / (2 * n)) / (1 + z2 / n);
  const double half =
      kNormalDeviations / (1 + z2 / n) * std::sqrt(share * (1 - share) / n + z2 / (4 * n * n));
  check.share_low = std::max(0.0, middle - half);
  check.share_high = std::min(1.0, middle + half);
  if (images < params.images_min) return check;
  check.verdict = check.share_low >= params.share_min   ? ViewVerdict::kSeen
                  : check.share_high < params.share_min ? ViewVerdict::kNotSeen
                                                        : ViewVerdict::kDoubtful;
  return check;
}

ViewCheck check_views(std::span<const ImageEvidence> images, std::span<const PairEvidence> pairs,
                      bool is_lens_known, const ViewCheckParams& params) {
  if (images.empty()) throw std::invalid_argument("a check needs at least one image");
  ViewCheck check;
  check.medians = medians_of(images);
  for (const ImageEvidence& image : images) check.views.push_back(good_views(image, check.medians, params));
  const auto over = [&](const auto& is_good) { return over_views(check.views, params, is_good); };
  check.left_edge = over([](const GoodViews& view) { return view.left_edge; });
  check.right_edge = over([](const GoodViews& view) { return view.right_edge; });
  check.edges = over([](const GoodViews& view) { return view.left_edge || view.right_edge; });
  check.verticals = over([](const GoodViews& view) { return view.verticals; });
  check.floor_points = over([](const GoodViews& view) { return view.floor_points; });
  check.floor = over([](const GoodViews& view) { return view.floor; });
  check.landmarks = over([](const GoodViews& view) { return view.verticals && view.floor_points; });
  check.sections = check.edges;
  check.rooms = check.floor;
  check.steadiness = steadiness_of(pairs);
  check.hints = view_hints(check, images, is_lens_known, params);
  return check;
}

}  // namespace aisle
