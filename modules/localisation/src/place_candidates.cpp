#include "aisle/localisation/place_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace aisle {

void PlaceSearchParams::describe(FieldList& fields) {
  fields.group("fit", fit);
  fields.real("explained_min", explained_min, {0.1, 1}, "share of the view that a place must explain");
  fields.real("margin_m", margin_m, {0.5, 100}, "surface by which a place must be ahead of every other");
  fields.real("margin_deviations", margin_deviations, {0, 10}, "and standard deviations of its own misfit");
  fields.real("chance_m", chance_m, {0.1, 5}, "pieces of surface this far apart fit by chances of their own");
  fields.real("apart_m", apart_m, {0.1, 10}, "poses nearer than this are one place");
  fields.angle("apart_deg", apart_rad, {1, 90}, "and turned by less than this");
  fields.count("hits", hits, {20, 2000}, "hits of the view that the search looks at");
  fields.count("places_max", places_max, {2, 10000}, "places after which the search is cut short");
  fields.count("nodes_max", nodes_max, {1000, 1000000000}, "nodes after which the search is cut short");
  fields.count("nodes_per_scan", nodes_per_scan, {1000, 1000000000}, "nodes that it looks at in a cycle");
}

SurfaceView view_of(std::vector<ViewBeam> beams, double piece_m) {
  SurfaceView view{std::move(beams), {}, piece_m};
  view.hits.reserve(view.beams.size());
  for (const ViewBeam& beam : view.beams) view.hits.push_back(beam.p_hit);
  return view;
}

std::optional<PlaceCandidate> settle(const SurfaceField& field, const SurfaceView& view,
                                     const Pose2& T_map_guess, const PlaceSearchParams& params) {
  const SurfaceAlignment laid =
      align_to_surfaces(field, view.hits, view.beams.front().p_laser, T_map_guess, Mat3::Zero());
  if (!field.can_stand(laid.T_map_vehicle.position())) return std::nullopt;
  const ViewFit fit = fit_of(field, view.beams, view.piece_m, laid.T_map_vehicle, params.fit);
  if (fit.explained_share() < params.explained_min) return std::nullopt;
  return PlaceCandidate{laid.T_map_vehicle, laid.information, fit};
}

bool is_same_place(const Pose2& a, const Pose2& b, const PlaceSearchParams& params) {
  return (a.position() - b.position()).norm() < params.apart_m &&
         std::abs(wrap_angle(a.theta - b.theta)) < params.apart_rad;
}

void PlaceCandidates::add(const PlaceCandidate& place) {
  const auto is_same = [&](const PlaceCandidate& other) {
    return is_same_place(other.T_map_vehicle, place.T_map_vehicle, params_);
  };
  const auto is_better = [](const PlaceCandidate& a, const PlaceCandidate& b) {
    return a.fit.misfit_m < b.fit.misfit_m;
  };
  const auto known = std::find_if(places_.begin(), places_.end(), is_same);
  if (known != places_.end() && !is_better(place, *known)) return;
  if (known != places_.end()) places_.erase(known);
  places_.insert(std::upper_bound(places_.begin(), places_.end(), place, is_better), place);
}

void PlaceCandidates::carry(const Pose2& T_last_now) {
  for (PlaceCandidate& place : places_) place.T_map_vehicle = place.T_map_vehicle * T_last_now;
}

std::span<const PlaceCandidate> PlaceCandidates::rivals() const {
  const double most_m = misfit_max_m();
  const auto is_rival = [&](const PlaceCandidate& place) { return place.fit.misfit_m <= most_m; };
  return {places_.begin(), std::partition_point(places_.begin(), places_.end(), is_rival)};
}

/// What does not fit is clutter: pieces of it fit elsewhere by chance, so the difference of two misfits
/// varies as a count of such pieces does.
double PlaceCandidates::misfit_max_m() const {
  if (places_.empty()) return std::numeric_limits<double>::infinity();
  const ViewFit& best = places_.front().fit;
  return best.misfit_m + params_.margin_m +
         params_.margin_deviations * std::sqrt(params_.chance_m * best.chance_m);
}

}  // namespace aisle
