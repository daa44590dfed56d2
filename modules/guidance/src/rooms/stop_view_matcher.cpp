#include "aisle/guidance/rooms/stop_view_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "aisle/vision/route/brightness_view.hpp"

namespace aisle {
namespace {

/// How unlike two views are: the mean and the most of the eight differences.
std::pair<double, double> unlikeness(const BrightnessView& a, const BrightnessView& b) {
  double sum = 0, most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double off = std::abs(a[i] - b[i]);
    sum += off;
    most = std::max(most, off);
  }
  return {sum / static_cast<double>(a.size()), most};
}

}  // namespace

void StopViewParams::describe(FieldList& fields) {
  fields.real("delta", delta, {0, 1}, "by which each of the eight positions may be off, of the part's width");
  fields.real("within_m", within_m, {0, 20}, "before the end views are looked for");
  fields.real("rival_m", rival_m, {0, 10}, "views from so far apart are of different places");
  fields.real("rival_factor", rival_factor, {1, 100}, "by which the best view must be more alike than those");
  fields.count("confirmations", confirmations, {1, 100}, "pictures in succession that must agree");
  fields.real("agree_m", agree_m, {0.001, 5}, "how well");
  fields.real("gain", gain, {0.01, 1}, "how much one picture corrects the way that is left");
}

StopViewMatcher::StopViewMatcher(const StopViewParams& params, std::vector<StopView> views)
    : params_(params), views_(std::move(views)) {}

void StopViewMatcher::take(const Image& picture, double left_m) {
  if (views_.empty() || left_m > params_.within_m) return;
  const StopView* view = match(brightness_view(picture));
  if (view == nullptr) return shifts_m_.clear();
  shifts_m_.push_back(view->left_m - left_m);
  if (shifts_m_.size() > static_cast<std::size_t>(params_.confirmations)) shifts_m_.pop_front();
  const auto [least, most] = std::minmax_element(shifts_m_.begin(), shifts_m_.end());
  if (shifts_m_.size() < static_cast<std::size_t>(params_.confirmations) || *most - *least > params_.agree_m)
    return;
  const double mean_m =
      std::accumulate(shifts_m_.begin(), shifts_m_.end(), 0.0) / static_cast<double>(shifts_m_.size());
  shift_m_ = shift_m_ ? *shift_m_ + params_.gain * (mean_m - *shift_m_) : mean_m;
}

/// The learned view that is most alike, if it matches and no other place's does nearly as well.
const StopView* StopViewMatcher::match(const BrightnessView& seen) const {
  const StopView* best = nullptr;
  double least = 0, most_off = 0;
  for (const StopView& view : views_) {
    const auto [mean, most] = unlikeness(seen, view.brightness);
    if (best != nullptr && mean >= least) continue;
    best = &view;
    least = mean;
    most_off = most;
  }
  if (best == nullptr || most_off > params_.delta) return nullptr;
  const bool has_rival = std::any_of(views_.begin(), views_.end(), [&](const StopView& view) {
    return std::abs(view.left_m - best->left_m) > params_.rival_m &&
           unlikeness(seen, view.brightness).first < params_.rival_factor * least;
  });
  return has_rival ? nullptr : best;
}

}  // namespace aisle
