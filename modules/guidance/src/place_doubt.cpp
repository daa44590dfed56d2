#include "aisle/guidance/place_doubt.hpp"

namespace aisle {
namespace {

constexpr int kPictures = 15;    // that are looked at
constexpr int kFittingMin = 4;   // of them, where the vehicle believes to be ...
constexpr int kFittingEach = 4;  // ... and for each that contradicts the map

}  // namespace

Suspicion PlaceDoubt::look(const LandmarkMap& map, const UncertainPose2& T_map_believed,
                           std::span<const LandmarkSighting> picture) {
  localiser_.place(T_map_believed);
  const LandmarkMatch match = localiser_.correct(map, picture);
  if (match == LandmarkMatch::kMatched) ++fitting_;
  if (match == LandmarkMatch::kUnmatched) ++contradicting_;
  if (++pictures_ < kPictures) return Suspicion::kOpen;
  const bool fits = fitting_ >= kFittingMin && fitting_ >= kFittingEach * contradicting_;
  return fits ? Suspicion::kDispelled : Suspicion::kConfirmed;
}

}  // namespace aisle
