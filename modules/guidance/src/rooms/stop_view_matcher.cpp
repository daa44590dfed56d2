#include "aisle/guidance/rooms/stop_view_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "aisle/vision/places/brightness_view.hpp"
#include "aisle/vision/places/view_recognition.hpp"

namespace aisle {
namespace {

double mean_off(const BrightnessView& a, const BrightnessView& b) {
  const double sum = std::transform_reduce(a.begin(), a.end(), b.begin(), 0.0, std::plus<>(),
                                           [](double x, double y) { return std::abs(x - y); });
  return sum / static_cast<double>(a.size());
}

bool are_within(double delta, const BrightnessView& a, const BrightnessView& b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [&](double x, double y) { return std::abs(x - y) <= delta; });
}

}  // namespace

void StopViewParams::describe(FieldList& fields) {
  fields.flag("by_extremes", by_extremes, "compare where columns are brightest and darkest, as published");
  fields.real("delta", delta, {0, 1},
              "with by_extremes: error allowed at each of the eight places, as a share of the part's width");
  fields.group("columns", columns);
  fields.real("unlike_max", unlike_max, {0, 2}, "else: one minus the least correlation with a learned view");
  fields.real("within_m", within_m, {0, 20}, "distance to the end from which it looks for views");
  fields.real("rival_m", rival_m, {0, 10}, "views farther apart than this are of different places");
  fields.real("rival_factor", rival_factor, {1, 100},
              "by which the best view must be more similar than those");
  fields.count("confirmations", confirmations, {1, 100}, "images in a row that must agree");
  fields.real("agree_m", agree_m, {0.001, 5}, "by which their corrections may differ");
  fields.real("gain", gain, {0.01, 1}, "how much one image corrects the path left");
}

StopViewMatcher::StopViewMatcher(const StopViewParams& params, const std::vector<StopView>& views)
    : params_(params), unlike_(views.size()) {
  for (const StopView& view : views) {
    left_m_.push_back(view.left_m);
    extremes_.push_back(view.seen.brightness);
    // A route learned by an earlier version has no columns.
    if (view.seen.columns.bytes.empty()) params_.by_extremes = true;
  }
  if (params_.by_extremes) return;
  for (const StopView& view : views) curves_.emplace_back(params_.columns, view.seen.columns);
}

void StopViewMatcher::take(const Image& image, double left_m) {
  if (left_m_.empty() || left_m > params_.within_m) return;
  const auto seen_left_m = match(image);
  if (!seen_left_m) return shifts_m_.clear();
  shifts_m_.push_back(*seen_left_m - left_m);
  if (shifts_m_.size() > static_cast<std::size_t>(params_.confirmations)) shifts_m_.pop_front();
  const auto [least, most] = std::minmax_element(shifts_m_.begin(), shifts_m_.end());
  if (shifts_m_.size() < static_cast<std::size_t>(params_.confirmations) || *most - *least > params_.agree_m)
    return;
  const double mean_m =
      std::accumulate(shifts_m_.begin(), shifts_m_.end(), 0.0) / static_cast<double>(shifts_m_.size());
  shift_m_ = shift_m_ ? *shift_m_ + params_.gain * (mean_m - *shift_m_) : mean_m;
}

/// The path left at the most similar learned view, if it matches and no view of another place is nearly as
/// similar.
std::optional<double> StopViewMatcher::match(const Image& image) {
  return params_.by_extremes ? match_extremes(image) : match_curves(image);
}

std::optional<double> StopViewMatcher::match_curves(const Image& image) {
  const ViewCurves seen(params_.columns, column_view(image));
  std::transform(curves_.begin(), curves_.end(), unlike_.begin(),
                 [&](const ViewCurves& view) { return view.unlikeness(seen); });
  const auto found = recognise_view(unlike_, left_m_, params_.rival_m);
  if (!found || !found->is_sure(params_.unlike_max, params_.rival_factor)) return std::nullopt;
  return left_m_[found->view];
}

std::optional<double> StopViewMatcher::match_extremes(const Image& image) {
  const BrightnessView seen = brightness_view(image);
  std::transform(extremes_.begin(), extremes_.end(), unlike_.begin(),
                 [&](const BrightnessView& view) { return mean_off(seen, view); });
  const auto found = recognise_view(unlike_, left_m_, params_.rival_m);
  if (!found || !found->is_sure(params_.delta, params_.rival_factor) ||
      !are_within(params_.delta, seen, extremes_[found->view]))
    return std::nullopt;
  return left_m_[found->view];
}

}  // namespace aisle
