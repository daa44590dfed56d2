#include "aisle/vision/standing_things.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "aisle/core/angle.hpp"

namespace aisle {

void StandingThingParams::describe(FieldList& fields) {
  fields.real("reach_m", reach_m, {2, 20}, "how far from the camera the floor is looked at");
  fields.real("foot_max_m", foot_max_m, {1, 20}, "things that stand farther away are left for later");
  fields.real("height_min_m", height_min_m, {0.05, 1}, "of a thing; what hides less floor may lie on it");
  fields.real("strip_height_m", strip_height_m, {0.01, 0.5}, "of the least skirting of a wall");
  fields.real("strip_width_m", strip_width_m, {0.1, 5}, "a skirting is seen at least so wide");
  fields.real("tolerance", tolerance, {1, 100}, "by which floor may look different, in grey levels");
  fields.real("tolerance_share", tolerance_share, {0, 1}, "and this share of its brightness");
  fields.real("texture_max", texture_max, {0, 100}, "by which a rough floor may look different at most");
  fields.real("tint_tolerance", tint_tolerance, {1, 500}, "by which its colour may differ, in grey levels");
  fields.real("drift_per_m", drift_per_m, {0, 200}, "of the floor's brightness along a ray, in grey levels");
  fields.real("foot_step", foot_step, {1, 100}, "of brightness at a thing's foot, in grey levels");
}

namespace {

constexpr int kCell_px = 4;
constexpr double kCentral_m = 0.3;  // to either side: the floor in front that brightness is learned from
constexpr std::size_t kNearSamples = 6;
constexpr double kLearning = 0.2;        // share of a new picture
constexpr double kLightJump = 1.3;       // a greater change of the whole picture is one of light
constexpr double kLowCameraShare = 0.5;  // of its height: as high are things for a low camera
constexpr double kShadeShare = 0.8;      // how far back the foot of a thing is looked for
constexpr std::size_t kAgain = 2;        // samples that look like floor again: floor
constexpr double kJoin_m = 0.05;         // feet on neighbouring rays so close belong together,
constexpr double kJoinShare = 0.12;      // and with this share of the distance more
constexpr std::size_t kNeighbours = 2;   // rays that a thing covers at least

}  // namespace

StandingThingDetector::StandingThingDetector(const StandingThingParams& params,
                                             const CameraIntrinsics& intrinsics, const CameraMount& mount,
                                             int width_px, int height_px)
    : params_(params),
      mount_(mount),
      width_px_(width_px),
      height_px_(height_px),
      columns_(width_px / kCell_px),
      rows_(height_px / kCell_px) {
  step_rad_ = kCell_px / intrinsics.fx_px;
  lay_rays(CameraModel(intrinsics), width_px, height_px);
  if (samples_.empty()) throw std::invalid_argument("the camera sees no floor within reach");
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  gaps_.resize(rays_.size());
  near_looks_.reserve(kNearSamples * rays_.size());
  things_.reserve(rays_.size());
}

/// Along a ray the samples follow each other as the picture's cells do.
void StandingThingDetector::lay_rays(const CameraModel& camera, int width_px, int height_px) {
  const double height_m = mount_.p_vehicle_camera.z();
  const auto sides = static_cast<int>(75 * kDegree / step_rad_);
  first_rad_ = mount_.pan_rad - sides * step_rad_;
  for (int i = 0; i <= 2 * sides; ++i) {
    Ray ray{.direction = unit(first_rad_ + i * step_rad_), .first = samples_.size()};
    for (double down_rad = 80 * kDegree; down_rad > 0; down_rad -= step_rad_) {
      const double away_m = height_m / std::tan(down_rad);
      if (away_m > params_.reach_m) break;
      const Vec2 p = place(ray, away_m);
      const auto pixel = camera.project(mount_.to_camera({p.x(), p.y(), 0}));
      if (!pixel) continue;
      const int u = static_cast<int>(std::lround(pixel->x())), v = static_cast<int>(std::lround(pixel->y()));
      if (u < 0 || v < 0 || u >= kCell_px * (width_px / kCell_px) || v >= kCell_px * (height_px / kCell_px)) {
        continue;
      }
      samples_.push_back(
          {static_cast<std::uint32_t>(v / kCell_px * columns_ + u / kCell_px), static_cast<float>(away_m)});
    }
    ray.end = samples_.size();
    rays_.push_back(ray);
  }
}

Vec2 StandingThingDetector::place(const Ray& ray, double away_m) const {
  return mount_.p_vehicle_camera.head<2>() + away_m * ray.direction;
}

void StandingThingDetector::shrink(const Image& picture) {
  constexpr int kPixels = kCell_px * kCell_px;
  const auto channels = static_cast<std::size_t>(picture.channels);
  Look* out = cells_.data();
  long total = 0;
  for (int row = 0; row < rows_; ++row) {
    for (std::size_t column = 0; column < static_cast<std::size_t>(columns_); ++column, ++out) {
      int sums[3] = {0, 0, 0};
      for (int line = kCell_px * row; line < kCell_px * (row + 1); ++line) {
        const std::uint8_t* pixel = picture.row(line) + kCell_px * column * channels;
        for (int i = 0; i < kCell_px; ++i) {
          for (std::size_t c = 0; c < channels; ++c) sums[c] += *pixel++;
        }
      }
      *out =
          channels == 1
              ? Look{.level = static_cast<std::uint8_t>(sums[0] / kPixels)}
              : Look{.level = static_cast<std::uint8_t>((sums[0] + sums[1] + sums[2]) / (3 * kPixels)),
                     .red_green = static_cast<std::int16_t>((sums[0] - sums[1]) / kPixels),
                     .yellow_blue = static_cast<std::int16_t>(((sums[0] + sums[1]) / 2 - sums[2]) / kPixels)};
      total += out->level;
    }
  }
  mean_level_ = static_cast<double>(total) / static_cast<double>(cells_.size());
}

/// Lamps go on and off: the floor's look goes with the whole picture's.
void StandingThingDetector::follow_light(double mean_before) {
  const double change = (mean_level_ + 1) / (mean_before + 1);
  if (floor_level_ >= 0 && (change > kLightJump || change < 1 / kLightJump))
    floor_level_ = (floor_level_ + 1) * change - 1;
}

/// The median where the picture begins, before the vehicle.
void StandingThingDetector::learn_floor() {
  near_looks_.clear();
  for (const Ray& ray : rays_) {
    if (ray.first == ray.end) continue;
    const double aside_m = std::abs(place(ray, samples_[ray.first].away_m).y());
    if (aside_m >= kCentral_m) continue;
    const std::size_t end = std::min(ray.end, ray.first + kNearSamples);
    for (std::size_t i = ray.first; i < end; ++i) near_looks_.push_back(cells_[samples_[i].cell]);
  }
  if (near_looks_.empty()) return;
  const auto middle = near_looks_.begin() + static_cast<std::ptrdiff_t>(near_looks_.size() / 2);
  std::nth_element(near_looks_.begin(), middle, near_looks_.end(),
                   [](const Look& a, const Look& b) { return a.level < b.level; });
  const bool is_first = floor_level_ < 0;
  if (is_first) floor_level_ = middle->level;
  if (std::abs(middle->level - floor_level_) > tolerance(floor_level_)) return;
  const double share = is_first ? 1 : kLearning;
  floor_level_ += share * (middle->level - floor_level_);
  red_green_ += share * (middle->red_green - red_green_);
  yellow_blue_ += share * (middle->yellow_blue - yellow_blue_);
  texture_ += share * (texture_of_floor() - texture_);
}

/// Within this of their median lie nearly all looks of a rough floor: two median deviations and the
/// tolerance.
double StandingThingDetector::texture_of_floor() {
  const auto off = [&](const Look& look) { return std::abs(look.level - floor_level_); };
  const auto middle = near_looks_.begin() + static_cast<std::ptrdiff_t>(near_looks_.size() / 2);
  std::nth_element(near_looks_.begin(), middle, near_looks_.end(),
                   [&](const Look& a, const Look& b) { return off(a) < off(b); });
  return std::min(2 * off(*middle), params_.texture_max);
}

double StandingThingDetector::tolerance(double level) const {
  return params_.tolerance + params_.tolerance_share * level + texture_;
}

bool StandingThingDetector::is_floor(const Look& look, double level) const {
  return std::abs(look.level - level) <= tolerance(level) &&
         std::hypot(look.red_green - red_green_, look.yellow_blue - yellow_blue_) <= params_.tint_tolerance;
}

StandingThingDetector::Gap StandingThingDetector::gap_of(const Ray& ray) const {
  const double camera_m = mount_.p_vehicle_camera.z();
  double level = floor_level_;
  Gap gap;
  for (std::size_t i = ray.first; i < ray.end;) {
    const Look& look = cells_[samples_[i].cell];
    if (is_floor(look, level)) {
      const double drift = params_.drift_per_m * (samples_[i].away_m - gap.free_m);
      level += std::clamp<double>(look.level - level, -drift, drift);
      gap.free_m = samples_[i++].away_m;
      continue;
    }
    const double from_m = samples_[i].away_m;
    if (from_m > params_.foot_max_m) break;
    const std::size_t end = floor_again(ray, i, level);
    const double hidden_m = camera_m * (1 - from_m / samples_[std::min(end, ray.end - 1)].away_m);
    if (hidden_m >= std::min(params_.height_min_m, kLowCameraShare * camera_m)) {
      const auto foot = foot_of_thing(ray, i);
      if (!foot) {
        level = look.level;
        gap.free_m = samples_[i++].away_m;
        continue;
      }
      gap.is_thing = true;
      gap.thing = *foot;
      gap.free_m = *foot > ray.first ? samples_[*foot - 1].away_m : 0;
      gap.height_m = end < ray.end ? hidden_m : camera_m;
      break;
    }
    if (!gap.has_strip && hidden_m >= params_.strip_height_m && end >= i + kAgain && i > ray.first) {
      gap.has_strip = true;
      gap.strip = i;
      gap.strip_free_m = gap.free_m;
    }
    i = end;
  }
  return gap;
}

/// A thing that looks like the floor at first (a wall in its own shade) begins at the step before. What comes
/// without any step is gloss or light on the floor.
std::optional<std::size_t> StandingThingDetector::foot_of_thing(const Ray& ray, std::size_t thing) const {
  const double step_min = std::max(params_.foot_step, texture_ / 2);
  const auto is_step = [&](std::size_t i) {
    const Look &here = cells_[samples_[i].cell], &before = cells_[samples_[i - 1].cell];
    return std::abs(here.level - before.level) >= step_min ||
           std::abs(here.red_green - before.red_green) >= step_min ||
           std::abs(here.yellow_blue - before.yellow_blue) >= step_min;
  };
  const double nearest_m = kShadeShare * samples_[thing].away_m;
  std::size_t foot = thing;
  while (foot > ray.first && samples_[foot].away_m >= nearest_m && !is_step(foot)) --foot;
  if (samples_[foot].away_m < nearest_m) return std::nullopt;
  while (foot > ray.first && is_step(foot)) --foot;
  return foot == ray.first ? foot : foot + 1;
}

/// The next sample at which floor of this brightness begins; the ray's end if there is none.
std::size_t StandingThingDetector::floor_again(const Ray& ray, std::size_t from, double level) const {
  std::size_t alike = 0;
  for (std::size_t i = from; i < ray.end; ++i) {
    alike = is_floor(cells_[samples_[i].cell], level) ? alike + 1 : 0;
    if (alike == kAgain) return i + 1 - kAgain;
  }
  return ray.end;
}

/// Strips that go on from ray to ray, far enough, are walls; what covers a single ray is nothing.
void StandingThingDetector::confirm() {
  const auto foot = [&](std::size_t i) { return place(rays_[i], samples_[foot_of(gaps_[i])].away_m); };
  const auto stands_out = [&](std::size_t i) { return gaps_[i].is_thing || gaps_[i].has_strip; };
  const auto goes_on = [&](std::size_t i) {
    const double away_m = samples_[foot_of(gaps_[i])].away_m;
    return (foot(i) - foot(i - 1)).norm() <= kJoinShare * away_m + kJoin_m;
  };
  for (std::size_t from = 0, to = 0; from < gaps_.size(); from = to) {
    to = from + 1;
    if (!stands_out(from)) continue;
    while (to < gaps_.size() && stands_out(to) && goes_on(to)) ++to;
    const bool is_wall = (foot(to - 1) - foot(from)).norm() >= params_.strip_width_m;
    for (std::size_t i = from; i < to; ++i) decide(gaps_[i], is_wall, to - from >= kNeighbours);
  }
}

void StandingThingDetector::decide(Gap& gap, bool is_wall, bool is_wide) const {
  if (gap.has_strip && is_wall) {
    gap.is_thing = true;
    gap.thing = gap.strip;
    gap.free_m = gap.strip_free_m;
    gap.height_m = mount_.p_vehicle_camera.z();
  }
  gap.is_thing = gap.is_thing && is_wide;
}

const std::vector<StandingThing>& StandingThingDetector::detect(const Image& picture) {
  const bool is_known = picture.channels == 1 || picture.channels == 3;
  if (!is_known || picture.width_px != width_px_ || picture.height_px != height_px_) {
    throw std::invalid_argument("the picture must be of the camera's size, grey or in colour");
  }
  const double mean_before = mean_level_;
  shrink(picture);
  follow_light(mean_before);
  learn_floor();
  for (std::size_t i = 0; i < rays_.size(); ++i) gaps_[i] = gap_of(rays_[i]);
  confirm();
  things_.clear();
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    const Gap& gap = gaps_[i];
    if (!gap.is_thing) continue;
    things_.push_back({.p_vehicle = place(rays_[i], samples_[gap.thing].away_m),
                       .height_m = gap.height_m,
                       .foot_hidden = gap.thing == rays_[i].first});
  }
  return things_;
}

const StandingThingDetector::Ray* StandingThingDetector::ray_to(const Vec2& p_vehicle) const {
  const Vec2 from_camera = p_vehicle - mount_.p_vehicle_camera.head<2>();
  const double index = (std::atan2(from_camera.y(), from_camera.x()) - first_rad_) / step_rad_;
  if (!(index > -0.5 && index < static_cast<double>(rays_.size()) - 0.5)) return nullptr;
  const Ray* ray = &rays_[static_cast<std::size_t>(std::lround(index))];
  return ray->first == ray->end ? nullptr : ray;
}

StandingThingDetector::Seen StandingThingDetector::seen_at(const Vec2& p_vehicle) const {
  constexpr double kSure_m = 0.15;
  const Ray* ray = ray_to(p_vehicle);
  if (ray == nullptr) return Seen::kNothing;
  const Gap& gap = gaps_[static_cast<std::size_t>(ray - rays_.data())];
  const double away_m = (p_vehicle - mount_.p_vehicle_camera.head<2>()).norm();
  const double begins_m = samples_[ray->first].away_m;
  if (away_m < begins_m) return gap.free_m > begins_m ? Seen::kTooNear : Seen::kNothing;
  return away_m + kSure_m < gap.free_m ? Seen::kFree : Seen::kNothing;
}

}  // namespace aisle
