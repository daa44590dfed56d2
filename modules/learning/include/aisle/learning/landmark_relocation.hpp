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
  int places_per_picture = 16;
  double distinct_share = 0.8;
  double matched_share_min = 0.7;
  double agreement_min = 0.5;
  int pairs_min = 6;
  int agreeing_pictures = 4;

  void describe(FieldList& fields);
};

/// Where on its ways the vehicle may be: for one that stands and has lost itself. Picture after picture it
/// tries some of the places that there are, so that a picture costs the same however large the building;
/// when all were tried, pictures are compared with the promising ones only, until several in a row agree.
class LandmarkRelocator {
 public:
  /// @param T_map_tried  where vehicles drive: poses not much farther apart than `apart_m`, either way round
  LandmarkRelocator(const LandmarkRelocationParams& params, const LandmarkLocaliserParams& matching,
                    std::vector<Pose2> T_map_tried);

  /// Nothing that was seen so far counts: the vehicle stands elsewhere.
  void start();

  /// Takes in one more picture from the same place.
  /// @return nullopt unless one place fits clearly better than any other, and well, in several pictures in a
  ///         row: look-alike doors are not guessed at
  std::optional<Pose2> look(const LandmarkMap& map, std::span<const LandmarkSighting> sightings);

 private:
  struct Candidate {
    Pose2 T_map_vehicle;
    double value = 0;      ///< of its peak
    double agreement = 0;  ///< of the last picture with the map there; 0: too little
  };

  void try_place(const LandmarkMap& map, const Pose2& T_map_tried,
                 std::span<const LandmarkSighting> sightings);
  void keep_promising();
  std::optional<Pose2> judge(const LandmarkMap& map, std::span<const LandmarkSighting> sightings);

  LandmarkRelocationParams params_;
  LandmarkLocaliserParams matching_;
  std::vector<Pose2> T_map_tried_;
  Mwght mwght_;
  std::size_t tried_ = 0;  ///< places, since the last start
  int judged_ = 0;         ///< pictures, since all were tried
  std::vector<Candidate> candidates_;
  std::vector<Pose2> T_map_agreed_;  ///< of pictures in a row
  std::vector<int> near_;
  std::vector<WeightedPoint> learned_, seen_;
};

}  // namespace aisle
