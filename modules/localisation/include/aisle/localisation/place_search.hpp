#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <vector>

#include "aisle/localisation/place_candidates.hpp"
#include "aisle/localisation/pose_search.hpp"

namespace aisle {

/// One search of the whole building for all places that a view allows, a slice at a time.
class PlaceSearch {
 public:
  /// @param field, map  must outlive the search
  /// @param view        not empty
  /// @param known       places that the view allows, as far as they are known
  PlaceSearch(const SurfaceField& field, const LikelihoodPyramid& map, SurfaceView view,
              PlaceCandidates known, const PlaceSearchParams& params);

  /// Searches on, for a slice of `nodes_per_scan`. @return whether it has ended
  bool advance();
  /// It has ended, and no other place fits: every pose was looked at.
  bool is_complete() const { return has_ended_ && !search_.is_cut_short(); }
  /// Those found so far that are not clearly worse than the best.
  const PlaceCandidates& places() const { return places_; }
  double view_m() const { return view_.surface_m(); }
  std::size_t nodes() const { return search_.nodes(); }

 private:
  bool examine(const Pose2& T_map_guess);
  double explained_min() const;

  const SurfaceField& field_;
  PlaceSearchParams params_;
  SurfaceView view_;
  std::vector<Vec2> some_hits_;  ///< enough of them to see that a pose is none
  PoseSearch search_;
  std::set<std::array<int, 3>> examined_;
  PlaceCandidates places_;
  bool has_ended_ = false;
};

}  // namespace aisle
