#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/localisation/view_fit.hpp"

namespace aisle {

struct PlaceSearchParams {
  ViewFitParams fit;
  double explained_min = 0.5;    ///< a pose that explains a smaller share of the view is none
  double margin_m = 1.2;         ///< surface by which the best place must be ahead of every other (more than
                                 ///< one thing that was carried from there to here), and ...
  double margin_deviations = 3;  ///< ... so many standard deviations of what chance makes of its misfit
  double chance_m = 0.5;  ///< pieces of surface this far apart are explained or not, each by its own chance
  double apart_m = 0.3;   ///< poses nearer than this, from where they settle at one another, and ...
  double apart_rad = 15 * kDegree;  ///< ... this are one place
  int hits = 160;                   ///< of the view, for the search
  int places_max = 50;              ///< with more, the search is cut short
  int nodes_max = 4000000;          ///< likewise
  int nodes_per_scan = 60000;       ///< that it looks at before it lets the vehicle's cycle go on

  void describe(FieldList& fields);
};

/// What was seen, as places are judged by it: in the vehicle's frame.
struct SurfaceView {
  std::vector<ViewBeam> beams;
  std::vector<Vec2> hits;  ///< of all beams
  double piece_m = 0;      ///< surface that each stands for

  double surface_m() const { return piece_m * static_cast<double>(beams.size()); }
};

/// @param piece_m  surface that each beam stands for
SurfaceView view_of(std::vector<ViewBeam> beams, double piece_m);

/// A place where the vehicle may be.
struct PlaceCandidate {
  Pose2 T_map_vehicle;
  Mat3 information = Mat3::Zero();  ///< of (x, y, theta), from what was seen
  ViewFit fit;
};

/// The place at which a pose settles on the building's surfaces. @return none: the view does not fit there
std::optional<PlaceCandidate> settle(const SurfaceField& field, const SurfaceView& view,
                                     const Pose2& T_map_guess, const PlaceSearchParams& params);

/// Whether two poses are the same place.
bool is_same_place(const Pose2& a, const Pose2& b, const PlaceSearchParams& params);

/// Places that one view allows, each once, the best first.
class PlaceCandidates {
 public:
  explicit PlaceCandidates(const PlaceSearchParams& params) : params_(params) {}

  /// Of two at the same place the better one stays.
  void add(const PlaceCandidate& place);
  void drop_beaten() { places_.resize(rivals().size()); }
  /// The vehicle has moved.
  void carry(const Pose2& T_last_now);

  /// The best one, and all that are not clearly worse.
  std::span<const PlaceCandidate> rivals() const;
  std::span<const PlaceCandidate> all() const { return places_; }
  bool empty() const { return places_.empty(); }
  /// A place with a greater misfit is clearly worse than the best; infinite, if there is none.
  double misfit_max_m() const;

 private:
  PlaceSearchParams params_;
  std::vector<PlaceCandidate> places_;
};

}  // namespace aisle
