#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/learning/landmark_localiser.hpp"

namespace aisle {

struct LandmarkRelocationParams {
  double apart_m = 0.8;   ///< between places that are tried
  double window_m = 0.7;  ///< around each
  double window_rad = 15 * kDegree;
  double distinct_share = 0.75;
  double matched_share_min = 0.7;
  int pairs_min = 4;

  void describe(FieldList& fields);
};

/// Where else on its ways the vehicle may be: for one that has lost itself.
class LandmarkRelocator {
 public:
  LandmarkRelocator(const LandmarkRelocationParams& params, const LandmarkLocaliserParams& matching)
      : params_(params), matching_(matching), mwght_(matching.mwght) {}

  /// Tries places along ways, each with a window around it, and says which fits what is seen best.
  /// @param T_map_tried  where vehicles drive: poses not much farther apart than `apart_m`, either way round
  /// @return nullopt unless one place fits clearly better than any other, and well: look-alike doors are not
  ///         guessed at
  std::optional<Pose2> find(const LandmarkMap& map, std::span<const Pose2> T_map_tried,
                            std::span<const LandmarkSighting> sightings);

 private:
  struct Candidate {
    Pose2 T_map_vehicle;
    double value = 0;          ///< of its peak
    double matched_share = 0;  ///< of the sightings' weights, with pairs on the map
  };

  void try_place(const LandmarkMap& map, const Pose2& T_map_tried,
                 std::span<const LandmarkSighting> sightings);
  void judge_by_pairs(const LandmarkMap& map, std::span<const LandmarkSighting> sightings);

  LandmarkRelocationParams params_;
  LandmarkLocaliserParams matching_;
  Mwght mwght_;
  std::vector<int> near_;
  std::vector<WeightedPoint> learned_, seen_;
  std::vector<Candidate> candidates_;
};

}  // namespace aisle
