#include "aisle/learning/landmarks/landmark_surroundings.hpp"

namespace aisle {
namespace {

constexpr double kBeginSigma = 1e-4;  // the first pose is the origin: exact [m, rad]
constexpr double kLookApart_m = 0.1;
constexpr std::size_t kLooksMax = 64;

}  // namespace

LandmarkSurroundings::LandmarkSurroundings(const LandmarkLearningParams& params,
                                           const VehicleDescription& vehicle)
    : params_(params),
      learner_(params),
      localiser_(params.localiser, vehicle, about({}, kBeginSigma, kBeginSigma)) {}

void LandmarkSurroundings::start() {
  learner_ = LandmarkLearner(params_);
  looks_.clear();
  localiser_.place(about({}, kBeginSigma, kBeginSigma));
}

void LandmarkSurroundings::add(std::span<const LandmarkSighting> image) {
  if (localiser_.correct(learner_.map(), image) != LandmarkMatch::kAmbiguous)
    learner_.merge(image, localiser_.pose());
  keep_look(image);
}

void LandmarkSurroundings::keep_look(std::span<const LandmarkSighting> image) {
  const Vec2 p_begin = T_begin_vehicle().position();
  if (!looks_.empty() && (looks_.back().T_begin_vehicle.position() - p_begin).norm() < kLookApart_m) return;
  looks_.push_back({T_begin_vehicle(), {image.begin(), image.end()}});
  if (looks_.size() > kLooksMax) looks_.pop_front();
}

const std::vector<LandmarkSighting>& LandmarkSurroundings::seen() {
  const Pose2 T_vehicle_begin = T_begin_vehicle().inverse();
  const Mat2 R_vehicle_begin = rotation(T_vehicle_begin.theta);
  seen_.clear();
  for (const Landmark& landmark : learner_.map().all()) {
    if (landmark.weight == 0 || landmark.sightings < params_.sightings_min) continue;
    seen_.push_back({.p_vehicle = T_vehicle_begin * landmark.p_map,
                     .covariance = R_vehicle_begin * landmark.covariance * R_vehicle_begin.transpose(),
                     .brighter_right = landmark.brighter_right});
  }
  return seen_;
}

}  // namespace aisle
