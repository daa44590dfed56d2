#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/learning/landmarks/landmark_localiser.hpp"
#include "aisle/learning/landmarks/landmark_surroundings.hpp"

namespace aisle {

struct LandmarkRelocationParams {
  double apart_m = 0.8;   ///< between places that are tried
  double window_m = 0.7;  ///< around each
  double window_rad = 15 * kDegree;
  int places_per_image = 16;
  double distinct_evidence = 8;
  double missed_evidence = 2.5;
  double unknown_evidence = 1;
  double matched_share_min = 0.5;
  int pairs_min = 5;
  int agreeing_images = 4;

  void describe(FieldList& fields);
};

/// Where on its paths the vehicle may be: for one that has lost itself. It compares what it has seen since
/// then, from where it stands or slowly drives, with all places that it knows: some with each image, so
/// that an image costs the same however large the building. Then the promising ones are looked at more
/// closely, pair by pair and by what should have been seen on the way there, and the best must stay the best
/// for several images.
class LandmarkRelocator {
 public:
  /// @param T_map_tried  where vehicles drive: poses not much farther apart than `apart_m`, either way round
  LandmarkRelocator(const LandmarkRelocationParams& params, const LandmarkLocaliserParams& matching,
                    const VehicleDescription& vehicle, std::vector<Pose2> T_map_tried);

  /// Nothing that was seen so far counts: the vehicle is elsewhere.
  void start();

  /// The vehicle has gone on.
  void predict(const OdometryReading& reading);

  /// Takes in one more image.
  /// @return where the vehicle is; nullopt unless one place fits clearly better than any other, and well, for
  ///         several images in a row: look-alike doors are not guessed at
  std::optional<Pose2> look(const LandmarkMap& map, std::span<const LandmarkSighting> image);

  /// How often it has come to no answer since the start: all places were tried, or there was too little to
  /// try them with.
  int rounds() const { return rounds_; }

 private:
  struct Candidate {
    Pose2 T_map_vehicle;
    double value = 0;     ///< of its peak
    double evidence = 0;  ///< of the pairs there, less what is missed or unknown
    double matched_share = 0;
    std::vector<LandmarkPair> pairs;
  };
  static bool is_same_place(const Candidate& a, const Candidate& b);

  void begin_round();
  bool try_places(const LandmarkMap& map, std::span<const LandmarkSighting> seen);
  void try_place(const LandmarkMap& map, const Pose2& T_map_tried, std::span<const LandmarkSighting> seen);
  bool judge_candidates(const LandmarkMap& map, std::span<const LandmarkSighting> seen);
  void judge(Candidate& candidate, const LandmarkMap& map, std::span<const LandmarkSighting> seen);
  int missed_landmarks(const LandmarkMap& map, const Candidate& candidate) const;
  void keep_promising();
  void keep_best();
  bool best_is_distinct() const;

  LandmarkRelocationParams params_;
  std::vector<Pose2> T_map_tried_;
  LandmarkSurroundings surroundings_;
  LandmarkLocaliser localiser_;  ///< of one candidate at a time
  LandmarkLocaliserParams matching_;
  Mwght mwght_;
  int rounds_ = 0;
  std::size_t tried_ = 0;   ///< places, in this round
  std::size_t judged_ = 0;  ///< candidates, of those that are promising
  int agreed_ = 0;          ///< images in which the best stayed the best
  std::vector<Candidate> candidates_;
  std::vector<Candidate> former_;  ///< best ones of the round before, to be judged in this one, too
  LandmarkPatterns patterns_;      ///< at one place
};

}  // namespace aisle
