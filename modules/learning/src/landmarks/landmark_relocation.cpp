#include "aisle/learning/landmarks/landmark_relocation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "aisle/learning/landmarks/landmark_expectation.hpp"

namespace aisle {
namespace {

constexpr std::size_t kPromisingMax = 64;  // places whose pairs are examined
constexpr std::size_t kJudgedPerImage = 4;
constexpr std::size_t kBestMax = 4;    // places that are compared image after image
constexpr double kRoughSigma_m = 0.1;  // of a displacement before its pairs refine it
constexpr double kRoughSigma_rad = 2 * kDegree;
constexpr double kSettledSigma_m = 0.05;  // ... and after
constexpr double kSettledSigma_rad = 1 * kDegree;
constexpr int kMissedLooks = 4;       // a landmark expected in this many looks and never seen is missing
constexpr double kMostlyKnown = 0.7;  // share of the sightings; a place where fewer are known ...
constexpr double kMoreDistinct = 3;   // ... must be more distinct by this factor
constexpr double kSamePlace_m = 0.3;
constexpr double kSamePlace_rad = 5 * kDegree;
constexpr double kSamePairs_m = 0.5;  // candidates within this with the same pairs are one place
constexpr double kSamePairs_rad = 12 * kDegree;

bool are_near(const Pose2& a, const Pose2& b, double near_m, double near_rad) {
  const Pose2 off = between(a, b);
  return off.position().norm() < near_m && std::abs(off.theta) < near_rad;
}

}  // namespace

/// Pairs that leave a direction open, like lines of one wall, also fit a little to the side.
bool LandmarkRelocator::is_same_place(const Candidate& a, const Candidate& b) {
  const bool by_same_pairs = !a.pairs.empty() && a.pairs == b.pairs;
  return by_same_pairs ? are_near(a.T_map_vehicle, b.T_map_vehicle, kSamePairs_m, kSamePairs_rad)
                       : are_near(a.T_map_vehicle, b.T_map_vehicle, kSamePlace_m, kSamePlace_rad);
}

void LandmarkRelocationParams::describe(FieldList& fields) {
  fields.real("apart_m", apart_m, {0.1, 5}, "distance between the places that are tried");
  fields.real("window_m", window_m, {0.1, 3}, "displacements up to this are tried around each");
  fields.angle("window_deg", window_rad, {1, 90}, "turns up to this are tried around each");
  fields.count("places_per_image", places_per_image, {1, 10000}, "places tried in a cycle");
  fields.real("distinct_evidence", distinct_evidence, {0, 1000},
              "a place must be more likely than any other by this (logarithm of the ratio), by three times "
              "this where less than 0.7 of what is seen is known");
  fields.real("missed_evidence", missed_evidence, {0, 10},
              "a landmark that should have been seen and was not makes a place less likely by this");
  fields.real("unknown_evidence", unknown_evidence, {0, 10},
              "a sighting of an unknown landmark makes a place less likely by this");
  fields.real("matched_share_min", matched_share_min, {0, 1},
              "share of the sightings that must be known there");
  fields.count("pairs_min", pairs_min, {1, 100}, "sightings that must be known there");
  fields.count("agreeing_images", agreeing_images, {1, 100}, "images in a row that must agree");
}

LandmarkRelocator::LandmarkRelocator(const LandmarkRelocationParams& params,
                                     const LandmarkLocaliserParams& matching,
                                     const VehicleDescription& vehicle, std::vector<Pose2> T_map_tried)
    : params_(params),
      T_map_tried_(std::move(T_map_tried)),
      surroundings_({.localiser = matching}, vehicle),
      localiser_(matching, vehicle, {}),
      matching_(matching),
      mwght_(matching.mwght) {}

void LandmarkRelocator::start() {
  surroundings_.start();
  rounds_ = 0;
  candidates_.clear();
  begin_round();
}

/// The best candidates so far are judged again among the new promising ones: places are tried only along the
/// paths, and the vehicle may have turned away from them since.
void LandmarkRelocator::begin_round() {
  tried_ = 0;
  judged_ = 0;
  agreed_ = 0;
  former_ = std::exchange(candidates_, {});
  std::erase_if(former_, [](const Candidate& candidate) { return candidate.evidence == 0; });
}

void LandmarkRelocator::predict(const OdometryReading& reading) {
  const Pose2 before = surroundings_.T_begin_vehicle();
  surroundings_.predict(reading);
  const Pose2 moved = between(before, surroundings_.T_begin_vehicle());
  for (std::vector<Candidate>* candidates : {&candidates_, &former_}) {
    for (Candidate& candidate : *candidates) candidate.T_map_vehicle = candidate.T_map_vehicle * moved;
  }
}

std::optional<Pose2> LandmarkRelocator::look(const LandmarkMap& map,
                                             std::span<const LandmarkSighting> image) {
  surroundings_.add(image);
  const std::vector<LandmarkSighting>& seen = surroundings_.seen();
  if (seen.size() < static_cast<std::size_t>(params_.pairs_min)) {
    ++rounds_;
    return std::nullopt;
  }
  if (!try_places(map, seen) || !judge_candidates(map, seen)) return std::nullopt;
  if (!best_is_distinct()) {
    ++rounds_;
    begin_round();
    return std::nullopt;
  }
  if (++agreed_ >= params_.agreeing_images) return candidates_.front().T_map_vehicle;
  for (Candidate& candidate : candidates_) judge(candidate, map, seen);
  keep_best();
  return std::nullopt;
}

/// @return whether all were tried before this image
bool LandmarkRelocator::try_places(const LandmarkMap& map, std::span<const LandmarkSighting> seen) {
  if (tried_ == T_map_tried_.size()) return true;
  const std::size_t end =
      std::min(tried_ + static_cast<std::size_t>(params_.places_per_image), T_map_tried_.size());
  while (tried_ < end) try_place(map, T_map_tried_[tried_++], seen);
  if (tried_ == T_map_tried_.size()) keep_promising();
  return false;
}

void LandmarkRelocator::keep_promising() {
  std::sort(candidates_.begin(), candidates_.end(),
            [](const Candidate& a, const Candidate& b) { return a.value > b.value; });
  if (candidates_.size() > kPromisingMax) candidates_.resize(kPromisingMax);
  candidates_.insert(candidates_.end(), former_.begin(), former_.end());
  former_.clear();
}

/// @return whether all were judged before this image
bool LandmarkRelocator::judge_candidates(const LandmarkMap& map, std::span<const LandmarkSighting> seen) {
  if (judged_ == candidates_.size()) return true;
  const std::size_t end = std::min(judged_ + kJudgedPerImage, candidates_.size());
  while (judged_ < end) judge(candidates_[judged_++], map, seen);
  if (judged_ == candidates_.size()) keep_best();
  return false;
}

/// The Hough transform's votes are broad, so wrong places get nearly as many as the right one. Pairs of
/// sightings and landmarks, with their errors and brighter sides, tell them apart.
void LandmarkRelocator::judge(Candidate& candidate, const LandmarkMap& map,
                              std::span<const LandmarkSighting> seen) {
  localiser_.place(about(candidate.T_map_vehicle, kRoughSigma_m, kRoughSigma_rad));
  candidate.evidence = 0;
  candidate.pairs.clear();
  // once to get near, once to see how well it fits there
  if (localiser_.correct(map, seen) != LandmarkMatch::kMatched ||
      localiser_.correct(map, seen) != LandmarkMatch::kMatched)
    return;
  candidate.T_map_vehicle = localiser_.pose();
  candidate.pairs = localiser_.pairs();
  const double missed = params_.missed_evidence * missed_landmarks(map, candidate);
  const double unknown = params_.unknown_evidence * static_cast<double>(seen.size() - candidate.pairs.size());
  candidate.evidence = std::max(0.0, localiser_.evidence() - missed - unknown);
  candidate.matched_share = localiser_.matched_share();
}

/// The number of sure landmarks that should have been seen repeatedly on the way to a place, and never were.
int LandmarkRelocator::missed_landmarks(const LandmarkMap& map, const Candidate& candidate) const {
  struct Tally {
    int looks = 0;
    bool is_seen = false;
  };
  std::map<int, Tally> expected;
  const Pose2 T_map_begin = candidate.T_map_vehicle * surroundings_.T_begin_vehicle().inverse();
  for (const LandmarkSurroundings::Look& look : surroundings_.looks()) {
    const UncertainPose2 there =
        about(T_map_begin * look.T_begin_vehicle, kSettledSigma_m, kSettledSigma_rad);
    for (const ExpectedLandmark& landmark :
         expected_landmarks(map, there, look.image, matching_.landmark_sigma_m)) {
      Tally& tally = expected[landmark.landmark];
      ++tally.looks;
      tally.is_seen = tally.is_seen || landmark.is_seen;
    }
  }
  for (const LandmarkPair& pair : candidate.pairs) expected.erase(static_cast<int>(pair.landmark));
  return static_cast<int>(std::count_if(expected.begin(), expected.end(), [](const auto& landmark) {
    return !landmark.second.is_seen && landmark.second.looks >= kMissedLooks;
  }));
}

/// Sorts by likelihood and keeps each place once.
void LandmarkRelocator::keep_best() {
  std::sort(candidates_.begin(), candidates_.end(),
            [](const Candidate& a, const Candidate& b) { return a.evidence > b.evidence; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < candidates_.size() && kept < kBestMax; ++i) {
    const Candidate candidate = candidates_[i];
    const bool is_known =
        std::any_of(candidates_.begin(), candidates_.begin() + static_cast<std::ptrdiff_t>(kept),
                    [&](const Candidate& better) { return is_same_place(better, candidate); });
    if (!is_known) candidates_[kept++] = candidate;
  }
  candidates_.resize(kept);
  judged_ = kept;
}

bool LandmarkRelocator::best_is_distinct() const {
  if (candidates_.empty()) return false;
  const Candidate& best = candidates_.front();
  const double rival = candidates_.size() > 1 ? candidates_[1].evidence : 0;
  const double distinct_evidence =
      (best.matched_share < kMostlyKnown ? kMoreDistinct : 1) * params_.distinct_evidence;
  return best.matched_share >= params_.matched_share_min && best.evidence - rival >= distinct_evidence;
}

void LandmarkRelocator::try_place(const LandmarkMap& map, const Pose2& T_map_tried,
                                  std::span<const LandmarkSighting> seen) {
  const MwghtWindow window{
      .x_half_m = params_.window_m, .y_half_m = params_.window_m, .turn_half_rad = params_.window_rad};
  patterns_.gather(map, seen, T_map_tried, matching_.confidence_m2, window, matching_.mwght.reach_m);
  if (patterns_.near.size() < static_cast<std::size_t>(params_.pairs_min)) return;
  const auto match = mwght_.match(patterns_.learned, patterns_.seen, window);
  if (!match) return;
  candidates_.push_back({T_map_tried * match->best.displacement, match->best.value});
  if (match->runner_up)
    candidates_.push_back({T_map_tried * match->runner_up->displacement, match->runner_up->value});
}

}  // namespace aisle
