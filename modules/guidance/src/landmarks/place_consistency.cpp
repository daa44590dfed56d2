#include "aisle/guidance/landmarks/place_consistency.hpp"

#include "aisle/learning/landmarks/landmark_expectation.hpp"

namespace aisle {
namespace {

constexpr int kTellingImages = 15;  // this many images that fit or contradict are enough
constexpr int kImagesMax = 30;
constexpr int kContradictingMin = 3;   // fewer may show the wrong floor points that raised the suspicion
constexpr int kFittingMin = 3;         // images confirm the place even if walls seem to stand elsewhere
constexpr int kFittingEach = 4;        // this many images that fit outweigh one that contradicts
constexpr int kExpectedMin = 10;       // landmarks, summed over all images, tell something ...
constexpr double kSeenShareMin = 0.1;  // ... if fewer than this share are seen, no more than by chance ...
constexpr std::size_t kKnownMin = 2;   // ... and not half of the images show this many known lines ...
constexpr double kMostlyKnown = 0.7;   // ... as at least this share of their sightings

}  // namespace

Suspicion PlaceConsistency::look(const LandmarkMap& map, const UncertainPose2& T_map_believed,
                                 std::span<const LandmarkSighting> image) {
  localiser_.place(T_map_believed);
  const LandmarkMatch match = localiser_.correct(map, image);
  if (match == LandmarkMatch::kMatched) ++fitting_;
  if (match == LandmarkMatch::kUnmatched) ++contradicting_;
  for (const ExpectedLandmark& here : expected_landmarks(map, T_map_believed, image, landmark_sigma_m_)) {
    ++expected_;
    if (here.is_seen) ++seen_;
  }
  const std::size_t known = known_sightings(map, T_map_believed, image, landmark_sigma_m_);
  if (known >= kKnownMin && static_cast<double>(known) >= kMostlyKnown * static_cast<double>(image.size()))
    ++mostly_known_;
  ++images_;
  if (fitting_ + contradicting_ < kTellingImages && images_ < kImagesMax) return Suspicion::kOpen;
  const bool contradicts = contradicting_ >= kContradictingMin && kFittingEach * contradicting_ > fitting_;
  const bool is_missed =
      expected_ >= kExpectedMin && seen_ < kSeenShareMin * expected_ && 2 * mostly_known_ < images_;
  const bool is_unknown = has_jumped_ && fitting_ < kFittingMin;
  return contradicts || is_missed || is_unknown ? Suspicion::kConfirmed : Suspicion::kDispelled;
}

}  // namespace aisle
