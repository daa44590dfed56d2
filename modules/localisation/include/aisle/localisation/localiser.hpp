#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/localisation/place_search.hpp"

namespace aisle {

struct LocaliserParams {
  LocalViewParams view;
  PlaceSearchParams search;
  double search_every_m = 0.25;  ///< it judges its places by a new view after this path, or ...
  double search_every_rad = 15 * kDegree;
  double view_min_m = 6;        ///< with less surface in view it does not search
  double not_here_view_m = 15;  ///< a view with so much surface that fits nowhere is of another building
  double hint_m = 1.5;          ///< how far a hint may be wrong
  double hint_rad = 30 * kDegree;
  double lost_share = 0.4;  ///< of a scan's beams, but for those that end where the building is not known:
                            ///< with fewer explained for `lost_s` it is lost
  double lost_s = 3;
  double drift_max_m = 0.5;  ///< standard deviation; beyond the known building it goes by odometry so long
  int track_hits = 180;      ///< of a scan, while tracking

  void describe(FieldList& fields);
};

enum class LocaliserState {
  kSearching,  ///< too little was seen
  kAmbiguous,  ///< several places fit, or one that no second view has confirmed
  kNotHere,    ///< what was seen fits nowhere
  kFound,      ///< and tracked since
  kLost,       ///< was found, but what it sees no longer fits; searches again
};

const char* name_of(LocaliserState state);

/// A scan as the localiser takes it, in the vehicle's frame.
struct LocaliserScan {
  std::span<const Vec2> hits;
  Vec2 p_laser = Vec2::Zero();
  double stamp_s = 0;
};

/// Finds a vehicle in a known building from no guess at all, then tracks it, and notices when it is lost.
/// One search of the whole building, a slice with each scan, yields all places where the vehicle may be; each
/// new view judges them again. Only a place that nothing else in the building rivals is called found.
class Localiser {
 public:
  /// @throws std::invalid_argument if the building has no surfaces
  Localiser(const LocaliserParams& params, const Building& building);
  Localiser(const Localiser&) = delete;
  Localiser& operator=(const Localiser&) = delete;

  /// Somebody says that the vehicle is about here. Tells places apart that fit alike; believed only where
  /// what is seen fits.
  void take_hint(const Pose2& T_map_vehicle);

  /// @param T_last_now  the vehicle's motion since the last scan, by odometry
  void take_scan(const LocaliserScan& scan, const UncertainPose2& T_last_now);

  LocaliserState state() const { return state_; }
  bool is_found() const { return state_ == LocaliserState::kFound; }
  /// Where it is, while it is found.
  const UncertainPose2& T_map_vehicle() const { return T_map_vehicle_; }
  /// Where it may be, while it is not found; the best first.
  std::span<const PlaceCandidate> places() const { return places_.rivals(); }
  /// All places that fit are in `places()`.
  bool knows_all_places() const { return knows_all_; }
  /// The hint did not fit what is seen.
  bool hint_was_wrong() const { return hint_was_wrong_; }
  /// Of the last scan's beams that ended in the known building, the share that it explains, while it is
  /// found.
  double explained_share() const { return explained_share_; }

 private:
  void carry(const Pose2& T_last_now);
  void look_for_itself(bool is_new_view);
  bool is_time_to_judge() const;
  void take_found_places();
  void look_again(const SurfaceView& view);
  std::optional<PlaceCandidate> told_place(const SurfaceView& view);
  void judge(const SurfaceView& view);
  std::optional<PlaceCandidate> confirmed_place();
  void believe(const PlaceCandidate& place);
  void track(const LocaliserScan& scan, const UncertainPose2& T_last_now);
  void choose_hits(std::span<const Vec2> hits);

  LocaliserParams params_;
  SurfaceField field_;
  LikelihoodPyramid map_;
  LocalView view_;
  LocaliserState state_ = LocaliserState::kSearching;
  bool hint_was_wrong_ = false;
  std::optional<PlaceSearch> search_;  ///< under way
  Pose2 T_begun_now_;                  ///< the motion since it began
  PlaceCandidates places_;             ///< carried on by odometry
  bool knows_all_ = false;             ///< the vehicle is at one of `places_`
  std::optional<Pose2> T_map_leader_;  ///< the only place that the last view allowed
  std::optional<Pose2> T_map_hint_;
  double judged_path_m_ = 0;
  double judged_turned_rad_ = 0;
  UncertainPose2 T_map_vehicle_;
  double explained_share_ = 0;
  double explained_s_ = 0;  ///< when a scan was last explained
  std::vector<Vec2> hits_;
  std::vector<ViewBeam> beams_;
};

}  // namespace aisle
