#include "aisle/localisation/localiser.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kWeak = 1e-6;  // keeps an information matrix invertible along a bare corridor

Mat3 covariance_of(const Mat3& information) {
  return (information + kWeak * Mat3::Identity()).inverse();
}

}  // namespace

const char* name_of(LocaliserState state) {
  switch (state) {
    case LocaliserState::kSearching:
      return "searching";
    case LocaliserState::kAmbiguous:
      return "ambiguous";
    case LocaliserState::kNotHere:
      return "not here";
    case LocaliserState::kFound:
      return "found";
    case LocaliserState::kLost:
      break;
  }
  return "lost";
}

void LocaliserParams::describe(FieldList& fields) {
  fields.group("view", view);
  fields.group("search", search);
  fields.real("search_every_m", search_every_m, {0.05, 10}, "it searches again after this path");
  fields.angle("search_every_deg", search_every_rad, {1, 180}, "it searches again after this turn");
  fields.real("view_min_m", view_min_m, {0.5, 100}, "it searches with so much surface in view");
  fields.real("not_here_view_m", not_here_view_m, {1, 1000},
              "a view with so much surface that fits nowhere is of another building");
  fields.real("hint_m", hint_m, {0.1, 20}, "how far a hint may be wrong");
  fields.angle("hint_deg", hint_rad, {1, 180}, "how far the heading of a hint may be wrong");
  fields.real("lost_share", lost_share, {0, 1}, "lost, if a smaller share of the beams is explained");
  fields.real("lost_s", lost_s, {0.1, 60}, "for this long");
  fields.real("drift_max_m", drift_max_m, {0.1, 10},
              "lost as well, if nothing known has been seen until the position is so uncertain");
  fields.count("track_hits", track_hits, {20, 2000}, "hits of a scan that tracking looks at");
}

Localiser::Localiser(const LocaliserParams& params, const Building& building)
    : params_(params), field_(building), map_(field_), view_(params.view) {}

void Localiser::take_hint(const Pose2& T_map_vehicle) {
  T_map_hint_ = T_map_vehicle;
  hint_was_wrong_ = false;
}

void Localiser::take_scan(const LocaliserScan& scan, const UncertainPose2& T_last_now) {
  const bool is_new_view = view_.take(scan.hits, scan.p_laser, T_last_now.mean);
  if (is_found()) {
    track(scan, T_last_now);
    return;
  }
  carry(T_last_now.mean);
  if (is_new_view && is_time_to_search()) search();
  if (is_found()) explained_s_ = scan.stamp_s;
}

void Localiser::carry(const Pose2& T_last_now) {
  for (PlaceCandidate& place : last_.places) place.T_map_vehicle = place.T_map_vehicle * T_last_now;
  if (T_map_alone_) T_map_alone_ = *T_map_alone_ * T_last_now;
  if (T_map_hint_) T_map_hint_ = *T_map_hint_ * T_last_now;
}

bool Localiser::is_time_to_search() const {
  return !has_searched_ || view_.path_m() - searched_path_m_ >= params_.search_every_m ||
         view_.turned_rad() - searched_turned_rad_ >= params_.search_every_rad;
}

void Localiser::search() {
  const std::vector<ViewBeam> beams = view_.beams();
  const double piece_m = params_.view.thin_m;
  if (piece_m * static_cast<double>(beams.size()) < params_.view_min_m) return;
  has_searched_ = true;
  searched_path_m_ = view_.path_m();
  searched_turned_rad_ = view_.turned_rad();
  last_ = find_places(field_, map_, beams, piece_m, params_.search);
  judge(told_place(beams));
}

/// The place that the hint means, if it fits no worse than the best.
std::optional<PlaceCandidate> Localiser::told_place(std::span<const ViewBeam> beams) {
  if (!T_map_hint_ || last_.places.empty()) return std::nullopt;
  const auto is_meant = [&](const PlaceCandidate& place) {
    const Pose2 off = between(*T_map_hint_, place.T_map_vehicle);
    return off.position().norm() < params_.hint_m && std::abs(off.theta) < params_.hint_rad;
  };
  std::vector<Vec2> hits;
  for (const ViewBeam& beam : beams) hits.push_back(beam.p_hit);
  const SurfaceAlignment laid =
      align_to_surfaces(field_, hits, beams.front().p_laser, *T_map_hint_, Mat3::Zero());
  const ViewFit fit = fit_of(field_, beams, params_.view.thin_m, laid.T_map_vehicle, params_.search.fit);
  std::vector<PlaceCandidate> meant{{laid.T_map_vehicle, laid.information, fit}};
  std::copy_if(last_.places.begin(), last_.places.end(), std::back_inserter(meant), is_meant);
  const auto best = std::min_element(meant.begin(), meant.end(), [](const auto& a, const auto& b) {
    return a.fit.misfit_m < b.fit.misfit_m;
  });
  if (is_meant(*best) && best->fit.explained_share() >= params_.search.explained_min &&
      best->fit.misfit_m <= last_.misfit_max_m)
    return *best;
  T_map_hint_.reset();
  hint_was_wrong_ = true;
  return std::nullopt;
}

void Localiser::judge(const std::optional<PlaceCandidate>& told) {
  if (told) {
    believe(*told);
    return;
  }
  const bool is_alone = last_.is_complete && last_.places.size() == 1;
  if (is_alone && T_map_alone_ &&
      is_same_place(*T_map_alone_, last_.places.front().T_map_vehicle, params_.search)) {
    believe(last_.places.front());
    return;
  }
  T_map_alone_.reset();
  if (is_alone) T_map_alone_ = last_.places.front().T_map_vehicle;
  if (state_ == LocaliserState::kLost && last_.places.empty()) return;
  const bool fits_nowhere =
      last_.is_complete && last_.places.empty() && last_.view_m >= params_.not_here_view_m;
  state_ = fits_nowhere           ? LocaliserState::kNotHere
           : last_.places.empty() ? LocaliserState::kSearching
                                  : LocaliserState::kAmbiguous;
}

void Localiser::believe(const PlaceCandidate& place) {
  T_map_vehicle_ = {place.T_map_vehicle, covariance_of(place.information)};
  T_map_hint_.reset();
  T_map_alone_.reset();
  last_ = {};
  state_ = LocaliserState::kFound;
}

void Localiser::choose_hits(std::span<const Vec2> hits) {
  const auto most = static_cast<std::size_t>(params_.track_hits);
  const std::size_t step = (hits.size() + most - 1) / most;
  hits_.clear();
  for (std::size_t i = 0; i < hits.size(); i += step) hits_.push_back(hits[i]);
}

void Localiser::track(const LocaliserScan& scan, const UncertainPose2& T_last_now) {
  T_map_vehicle_ = T_map_vehicle_ * T_last_now;
  choose_hits(scan.hits);
  const Mat3 known = (T_map_vehicle_.covariance + 1e-9 * Mat3::Identity()).inverse();
  const SurfaceAlignment laid = align_to_surfaces(field_, hits_, scan.p_laser, T_map_vehicle_.mean, known);
  T_map_vehicle_ = {laid.T_map_vehicle, covariance_of(known + laid.information)};
  beams_.clear();
  for (const Vec2& hit : hits_) beams_.push_back({scan.p_laser, hit});
  const ViewFit fit = fit_of(field_, beams_, params_.view.thin_m, T_map_vehicle_.mean, params_.search.fit);
  explained_share_ = fit.explained_share_of_known();
  if (explained_share_ >= params_.lost_share) explained_s_ = scan.stamp_s;
  const double drift_m = std::sqrt(T_map_vehicle_.covariance.topLeftCorner<2, 2>().trace());
  if (scan.stamp_s - explained_s_ <= params_.lost_s && drift_m <= params_.drift_max_m) return;
  state_ = LocaliserState::kLost;
  view_.clear();
  has_searched_ = false;
}

}  // namespace aisle
