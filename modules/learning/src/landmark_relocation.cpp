#include "aisle/learning/landmark_relocation.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr double kPromising = 0.7;     // of the best value: places whose pairs are looked at
constexpr double kRoughSigma_m = 0.1;  // of a displacement, before its pairs settle it
constexpr double kRoughSigma_rad = 2 * kDegree;

}  // namespace

void LandmarkRelocationParams::describe(FieldList& fields) {
  fields.real("apart_m", apart_m, {0.1, 5}, "between places that are tried");
  fields.real("window_m", window_m, {0.1, 3}, "displacements up to this are tried around each");
  fields.angle("window_deg", window_rad, {1, 90}, "turns up to this are tried around each");
  fields.real("distinct_share", distinct_share, {0, 1}, "another place this good makes an answer ambiguous");
  fields.real("matched_share_min", matched_share_min, {0, 1}, "so much of what is seen must be known there");
  fields.count("pairs_min", pairs_min, {1, 100}, "so many sightings must be known there");
}

std::optional<Pose2> LandmarkRelocator::find(const LandmarkMap& map, std::span<const Pose2> T_map_tried,
                                             std::span<const LandmarkSighting> sightings) {
  if (sightings.size() < static_cast<std::size_t>(params_.pairs_min)) return std::nullopt;
  candidates_.clear();
  for (const Pose2& T_map_place : T_map_tried) try_place(map, T_map_place, sightings);
  if (candidates_.empty()) return std::nullopt;
  judge_by_pairs(map, sightings);
  const auto by_share = [](const Candidate& a, const Candidate& b) {
    return a.matched_share < b.matched_share;
  };
  const auto best = std::max_element(candidates_.begin(), candidates_.end(), by_share);
  if (best->matched_share < params_.matched_share_min) return std::nullopt;
  for (const Candidate& other : candidates_) {
    const Pose2 off = between(best->T_map_vehicle, other.T_map_vehicle);
    const bool elsewhere =
        off.position().norm() > matching_.mwght.apart_m || std::abs(off.theta) > matching_.mwght.apart_rad;
    if (elsewhere && other.matched_share > params_.distinct_share * best->matched_share) return std::nullopt;
  }
  return best->T_map_vehicle;
}

/// Votes of the Hough transform are broad: wrong places come near the right one. Pairs of sightings and
/// landmarks, with their errors and brighter sides, tell them apart.
void LandmarkRelocator::judge_by_pairs(const LandmarkMap& map, std::span<const LandmarkSighting> sightings) {
  const auto by_value = [](const Candidate& a, const Candidate& b) { return a.value < b.value; };
  const double greatest = std::max_element(candidates_.begin(), candidates_.end(), by_value)->value;
  std::erase_if(candidates_, [&](const Candidate& c) { return c.value < kPromising * greatest; });
  LandmarkLocaliser localiser(matching_, {}, {});
  for (Candidate& candidate : candidates_) {
    localiser.place(about(candidate.T_map_vehicle, kRoughSigma_m, kRoughSigma_rad));
    if (localiser.correct(map, sightings) != LandmarkMatch::kMatched ||
        localiser.pairs().size() < static_cast<std::size_t>(params_.pairs_min))
      continue;
    candidate.T_map_vehicle = localiser.pose();
    candidate.matched_share = localiser.matched_share();
  }
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
