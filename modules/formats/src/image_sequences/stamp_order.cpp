#include "image_sequences/stamp_order.hpp"

#include <fmt/format.h>

#include "aisle/core/median.hpp"

namespace aisle {
namespace {

/// The median of the steps ahead; 0 if there are none.
double usual_step_ahead_s(const std::vector<ListedImage>& images) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < images.size(); ++i) {
    const double step_s = images[i].stamp_s - images[i - 1].stamp_s;
    if (step_s >= kStampStepMin_s) steps_s.push_back(step_s);
  }
  return steps_s.empty() ? 0 : median(std::move(steps_s));
}

}  // namespace

Problems order_stamps(ImageList& list) {
  std::vector<ListedImage>& images = list.images;
  const double usual_s = usual_step_ahead_s(images);
  if (images.size() > 1 && usual_s == 0)
    return {
        {{list.recording.string()}, "has stamps that stand still; --image-rate HZ gives the images' rate"}};
  LeftOut backward;
  double shift_s = 0;
  for (std::size_t i = 1; i < images.size(); ++i) {
    const double recorded_s = images[i].stamp_s, before_s = images[i - 1].stamp_s;
    if (recorded_s + shift_s - before_s < kStampStepMin_s) {
      backward.add({{images[i].file.string()}, "has no later stamp than the image before"});
      shift_s = before_s + usual_s - recorded_s;
    }
    images[i].stamp_s = recorded_s + shift_s;
  }
  if (!images.empty() && images.back().stamp_s > kStampMax_s) {
    return {{{list.recording.string()},
             "has a clock that jumps so often that its stamps make no sense; --image-rate HZ gives the "
             "images' rate"}};
  }
  if (backward.count() > 0) {
    list.warnings.push_back(
        {backward.first().where,
         fmt::format("{}; at {} such places the order of recording is kept and the usual {:.3f} s are taken",
                     backward.first().what, backward.count(), usual_s)});
  }
  return {};
}

}  // namespace aisle
