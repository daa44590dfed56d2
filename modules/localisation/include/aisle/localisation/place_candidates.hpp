#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/localisation/pose_search.hpp"
#include "aisle/localisation/view_fit.hpp"

namespace aisle {

struct PlaceSearchParams {
  ViewFitParams fit;
  double explained_min = 0.5;    ///< a pose that explains a smaller share of the view is none
  double margin_m = 2;           ///< surface by which the best place must be ahead of every other, and ...
  double margin_deviations = 3;  ///< ... so many standard deviations of what chance makes of its misfit
  double chance_m = 0.5;  ///< pieces of surface this far apart are explained or not, each by its own chance
  double apart_m = 0.5;   ///< poses nearer than this ...
  double apart_rad = 15 * kDegree;  ///< ... and this are one place
  int hits = 160;                   ///< of the view, for the search
  int places_max = 50;              ///< with more, the search is cut short
  int nodes_max = 4000000;
  int rival_nodes = 200000;  ///< once two places fit, it looks for more of them this far only

  void describe(FieldList& fields);
};

/// A place where the vehicle may be.
struct PlaceCandidate {
  Pose2 T_map_vehicle;
  Mat3 information = Mat3::Zero();  ///< of (x, y, theta), from what was seen
  ViewFit fit;
};

/// Where a view fits a building.
struct PlaceSearch {
  std::vector<PlaceCandidate> places;  ///< the best one, and all that are not clearly worse; the best first
  bool is_complete = false;            ///< no other place fits: every pose was looked at
  double view_m = 0;                   ///< surface in the view
  double misfit_max_m = 0;             ///< a place with more is no rival of the best
  std::size_t nodes = 0;               ///< that the search looked at
};

/// Whether two poses are the same place.
bool is_same_place(const Pose2& a, const Pose2& b, const PlaceSearchParams& params);

/// Searches the whole building.
/// @param beams    in the vehicle's frame
/// @param piece_m  surface that each stands for
PlaceSearch find_places(const SurfaceField& field, const LikelihoodPyramid& map,
                        std::span<const ViewBeam> beams, double piece_m, const PlaceSearchParams& params);

}  // namespace aisle
