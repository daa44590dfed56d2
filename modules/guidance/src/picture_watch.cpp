#include "aisle/guidance/picture_watch.hpp"

#include <algorithm>
#include <utility>

namespace aisle {

void PictureWatchParams::describe(FieldList& fields) {
  fields.real("age_max_s", age_max_s, {0.05, 5}, "without a picture that shows something new: stop");
  fields.real("dark_level", dark_level, {0, 100}, "mean grey level below which a picture is black");
  fields.real("bright_level", bright_level, {150, 256}, "mean grey level above which it is washed out");
}

PictureWatch::PictureWatch(const PictureWatchParams& params, std::string camera)
    : params_(params), camera_(std::move(camera)) {}

const CameraPicture* PictureWatch::look(const Observation& observation) {
  const auto found = std::find_if(observation.pictures.begin(), observation.pictures.end(),
                                  [&](const CameraPicture& picture) { return picture.camera == camera_; });
  if (found == observation.pictures.end() || !found->image) {
    if (good_stamp_s_) what_ = "sends no pictures";
    return nullptr;
  }
  if (observation.stamp_s - found->stamp_s > params_.age_max_s) {
    what_ = "is late";
    return nullptr;
  }
  const bool is_same = last_ && *last_ == *found->image;
  last_ = found->image;
  if (is_same) what_ = "is frozen";
  return is_same ? nullptr : &*found;
}

bool PictureWatch::shows_something(const CameraPicture& picture, double mean_level) {
  if (mean_level < params_.dark_level || mean_level > params_.bright_level) {
    what_ = mean_level < params_.dark_level ? "sees no light" : "is dazzled";
    return false;
  }
  good_stamp_s_ = picture.stamp_s;
  return true;
}

std::optional<std::string> PictureWatch::trouble(double now_s) const {
  if (good_stamp_s_ && now_s - *good_stamp_s_ <= params_.age_max_s) return std::nullopt;
  return "camera " + camera_ + " " + what_;
}

}  // namespace aisle
