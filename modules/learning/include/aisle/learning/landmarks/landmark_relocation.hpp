#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/learning/landmarks/landmark_localiser.hpp"
#include "aisle/learning/landmarks/landmark_surroundings.hpp"

namespace aisle {

struct LandmarkRelocationParams {
  double apart_m = 0.8;   ///< distance between the places that are tried
  double window_m = 0.7;  ///< search window around each
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

/// Global relocalisation for a vehicle that has lost its pose. It compares what it has seen since then,
/// standing or driving slowly, with all known places, a few with each image, so that the cost of an image
/// does not depend on the size of the building. It then examines the promising ones pair by pair, and by what
/// should have been seen on the way there; the best must stay the best for several images.
class LandmarkRelocator {
 public:
  /// @param T_map_tried  poses where vehicles drive, not much farther apart than `apart_m`, in both headings
  LandmarkRelocator(const LandmarkRelocationParams& params, const LandmarkLocaliserParams& matching,
                    const VehicleDescription& vehicle, std::vector<Pose2> T_map_tried);

  /// Forgets everything seen so far: the vehicle is elsewhere.
  void start();

  /// The vehicle has moved.
  void predict(const OdometryReading& reading);

  /// Takes in one more image.
  /// @return the vehicle's pose; nullopt unless one place fits well, and clearly better than any other, for
  ///         several images in a row: it does not guess among look-alike doors
  std::optional<Pose2> look(const LandmarkMap& map, std::span<const LandmarkSighting> image);

  /// How many rounds since the start had no answer: all places were tried, or there was too little to try
  /// them with.
  int rounds() const { return rounds_; }

 private:
  struct Candidate {
    Pose2 T_map_vehicle;
    double value = 0;     ///< value of its peak
    double evidence = 0;  ///< evidence of its pairs, less that of missed or unknown landmarks
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
  LandmarkLocaliser localiser_;  ///< for one candidate at a time
  LandmarkLocaliserParams matching_;
  Mwght mwght_;
  int rounds_ = 0;
  std::size_t tried_ = 0;   ///< places tried in this round
  std::size_t judged_ = 0;  ///< promising candidates judged in this round
  int agreed_ = 0;          ///< images in which the best stayed the best
  std::vector<Candidate> candidates_;
  std::vector<Candidate> former_;  ///< best of the previous round, to be judged again in this one
  LandmarkPatterns patterns_;      ///< at one place
};

}  // namespace aisle
