#include "aisle/guidance/place_doubt.hpp"

namespace aisle {
namespace {

constexpr int kTellingPictures = 15;  // that fit or contradict are enough
constexpr int kPicturesMax = 30;
constexpr int kContradictingMin = 3;  // fewer may be the wrong feet that woke the suspicion
constexpr int kFittingEach = 4;       // so many that fit outweigh one that contradicts

}  // namespace

Suspicion PlaceDoubt::look(const LandmarkMap& map, const UncertainPose2& T_map_believed,
                           std::span<const LandmarkSighting> picture) {
  localiser_.place(T_map_believed);
  const LandmarkMatch match = localiser_.correct(map, picture);
  if (match == LandmarkMatch::kMatched) ++fitting_;
  if (match == LandmarkMatch::kUnmatched) ++contradicting_;
  ++pictures_;
  if (fitting_ + contradicting_ < kTellingPictures && pictures_ < kPicturesMax) return Suspicion::kOpen;
  const bool is_elsewhere = contradicting_ >= kContradictingMin && kFittingEach * contradicting_ > fitting_;
  return is_elsewhere ? Suspicion::kConfirmed : Suspicion::kDispelled;
}

}  // namespace aisle
