#include "aisle/learning/landmark_relocation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aisle {
namespace {

constexpr double kPromising = 0.7;      // of the best value: places whose pairs are looked at
constexpr std::size_t kJudgedMax = 24;  // places whose pairs are looked at in a picture
constexpr int kJudgedPicturesMax = 12;  // before all places are tried again
constexpr double kRoughSigma_m = 0.1;   // of a displacement, before its pairs settle it
constexpr double kRoughSigma_rad = 2 * kDegree;
constexpr double kAgreed_m = 0.25;  // answers of two pictures that are the same

}  // namespace

void LandmarkRelocationParams::describe(FieldList& fields) {
  fields.real("apart_m", apart_m, {0.1, 5}, "between places that are tried");
  fields.real("window_m", window_m, {0.1, 3}, "displacements up to this are tried around each");
  fields.angle("window_deg", window_rad, {1, 90}, "turns up to this are tried around each");
  fields.count("places_per_picture", places_per_picture, {1, 10000}, "so many places are tried in a cycle");
  fields.real("distinct_share", distinct_share, {0, 1}, "another place this good makes an answer ambiguous");
  fields.real("matched_share_min", matched_share_min, {0, 1}, "so much of what is seen must be known there");
  fields.real("agreement_min", agreement_min, {0, 1}, "so nearly must it lie upon what is known there");
  fields.count("pairs_min", pairs_min, {1, 100}, "so many sightings must be known there");
  fields.count("agreeing_pictures", agreeing_pictures, {1, 100}, "so many in a row must say the same");
}

LandmarkRelocator::LandmarkRelocator(const LandmarkRelocationParams& params,
                                     const LandmarkLocaliserParams& matching, std::vector<Pose2> T_map_tried)
    : params_(params), matching_(matching), T_map_tried_(std::move(T_map_tried)), mwght_(matching.mwght) {}

void LandmarkRelocator::start() {
  tried_ = 0;
  judged_ = 0;
  candidates_.clear();
  T_map_agreed_.clear();
}

std::optional<Pose2> LandmarkRelocator::look(const LandmarkMap& map,
                                             std::span<const LandmarkSighting> sightings) {
  if (sightings.size() < static_cast<std::size_t>(params_.pairs_min)) return std::nullopt;
  if (judged_ >= kJudgedPicturesMax) start();
  if (tried_ < T_map_tried_.size()) {
    const std::size_t end =
        std::min(tried_ + static_cast<std::size_t>(params_.places_per_picture), T_map_tried_.size());
    while (tried_ < end) try_place(map, T_map_tried_[tried_++], sightings);
    if (tried_ == T_map_tried_.size()) keep_promising();
    return std::nullopt;
  }
  ++judged_;
  const auto found = judge(map, sightings);
  const bool agrees = found && (T_map_agreed_.empty() ||
                                (T_map_agreed_.back().position() - found->position()).norm() < kAgreed_m);
  if (!agrees) T_map_agreed_.clear();
  if (found) T_map_agreed_.push_back(*found);
  return T_map_agreed_.size() < static_cast<std::size_t>(params_.agreeing_pictures) ? std::nullopt : found;
}

void LandmarkRelocator::keep_promising() {
  std::sort(candidates_.begin(), candidates_.end(),
            [](const Candidate& a, const Candidate& b) { return a.value > b.value; });
  std::erase_if(candidates_, [least = candidates_.empty() ? 0 : kPromising * candidates_.front().value](
                                 const Candidate& c) { return c.value < least; });
  if (candidates_.size() > kJudgedMax) candidates_.resize(kJudgedMax);
}

/// Votes of the Hough transform are broad: wrong places come near the right one. Pairs of sightings and
/// landmarks, with their errors and brighter sides, tell them apart.
std::optional<Pose2> LandmarkRelocator::judge(const LandmarkMap& map,
                                              std::span<const LandmarkSighting> sightings) {
  LandmarkLocaliser localiser(matching_, {}, {});
  const Candidate* best = nullptr;
  for (Candidate& candidate : candidates_) {
    localiser.place(about(candidate.T_map_vehicle, kRoughSigma_m, kRoughSigma_rad));
    candidate.agreement = 0;
    // once to come near, once to see how well it fits there
    if (localiser.correct(map, sightings) != LandmarkMatch::kMatched ||
        localiser.correct(map, sightings) != LandmarkMatch::kMatched ||
        localiser.pairs().size() < static_cast<std::size_t>(params_.pairs_min) ||
        localiser.matched_share() < params_.matched_share_min ||
        localiser.agreement() < params_.agreement_min)
      continue;
    candidate.T_map_vehicle = localiser.pose();
    candidate.agreement = localiser.agreement();
    if (best == nullptr || candidate.agreement > best->agreement) best = &candidate;
  }
  if (best == nullptr) return std::nullopt;
  for (const Candidate& other : candidates_) {
    const Pose2 off = between(best->T_map_vehicle, other.T_map_vehicle);
    const bool elsewhere =
        off.position().norm() > matching_.mwght.apart_m || std::abs(off.theta) > matching_.mwght.apart_rad;
    if (elsewhere && other.agreement > params_.distinct_share * best->agreement) return std::nullopt;
  }
  return best->T_map_vehicle;
}

void LandmarkRelocator::try_place(const LandmarkMap& map, const Pose2& T_map_tried,
                                  std::span<const LandmarkSighting> sightings) {
  Vec2 low = sightings.front().p_vehicle, high = low;
  seen_.clear();
  for (const LandmarkSighting& sighting : sightings) {
    low = low.cwiseMin(sighting.p_vehicle);
    high = high.cwiseMax(sighting.p_vehicle);
    seen_.push_back({sighting.p_vehicle, confidence_weight(sighting.p_vehicle, matching_.confidence_m2)});
  }
  const double reach_m = (high - low).norm() / 2 + params_.window_m + high.norm() * params_.window_rad;
  map.within(T_map_tried * Vec2((low + high) / 2), reach_m, near_);
  if (near_.size() < static_cast<std::size_t>(params_.pairs_min)) return;
  const Pose2 T_tried_map = T_map_tried.inverse();
  learned_.clear();
  for (const int i : near_) {
    const Landmark& landmark = map[static_cast<std::size_t>(i)];
    learned_.push_back({T_tried_map * landmark.p_map, 1});
  }
  const MwghtWindow window{
      .x_half_m = params_.window_m, .y_half_m = params_.window_m, .turn_half_rad = params_.window_rad};
  const auto match = mwght_.match(learned_, seen_, window);
  if (!match) return;
  candidates_.push_back({T_map_tried * match->best.displacement, match->best.value});
  if (match->runner_up)
    candidates_.push_back({T_map_tried * match->runner_up->displacement, match->runner_up->value});
}

}  // namespace aisle
