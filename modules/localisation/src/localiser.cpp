#include "aisle/localisation/localiser.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace aisle {
namespace {

constexpr double kWeak = 1e-6;  // keeps an information matrix invertible along a bare corridor

Mat3 covariance_of(const Mat3& information) {
  return (information + kWeak * Mat3::Identity()).inverse();
}

/// Poses that explain less than `explained_min` are never looked at. Where one of them could still rival the
/// best place, that place stands alone only because nobody looked.
bool were_all_rivals_sought(const PlaceCandidates& places, const SurfaceView& view,
                            const PlaceSearchParams& params) {
  return places.misfit_max_m() <= (1 - params.explained_min) * view.surface_m();
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
  fields.real("search_every_m", search_every_m, {0.05, 10}, "it judges its places again after this path");
  fields.angle("search_every_deg", search_every_rad, {1, 180}, "likewise after this turn");
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
    : params_(params), field_(building), map_(field_), view_(params.view), places_(params.search) {}

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
  look_for_itself(is_new_view);
  if (is_found()) explained_s_ = scan.stamp_s;
}

void Localiser::carry(const Pose2& T_last_now) {
  places_.carry(T_last_now);
  T_begun_now_ = T_begun_now_ * T_last_now;
  if (T_map_leader_) T_map_leader_ = *T_map_leader_ * T_last_now;
  if (T_map_hint_) T_map_hint_ = *T_map_hint_ * T_last_now;
}

void Localiser::look_for_itself(bool is_new_view) {
  const bool was_searching = search_.has_value();
  if (was_searching) {
    if (!search_->advance()) return;
    take_found_places();
  } else if (!is_new_view || !is_time_to_judge()) {
    return;
  }
  const SurfaceView view = view_of(view_.beams(), params_.view.thin_m);
  if (view.surface_m() < params_.view_min_m) return;
  look_again(view);
  judge(view);
  if (was_searching || is_found() || knows_all_) return;
  search_.emplace(field_, map_, view, places_, params_.search);
  T_begun_now_ = {};
}

bool Localiser::is_time_to_judge() const {
  return state_ == LocaliserState::kSearching || state_ == LocaliserState::kLost ||
         view_.path_m() - judged_path_m_ >= params_.search_every_m ||
         view_.turned_rad() - judged_turned_rad_ >= params_.search_every_rad;
}

void Localiser::take_found_places() {
  places_ = search_->places();
  knows_all_ = search_->is_complete();
  const bool fits_nowhere = knows_all_ && places_.empty() && search_->view_m() >= params_.not_here_view_m;
  if (fits_nowhere && state_ != LocaliserState::kLost) state_ = LocaliserState::kNotHere;
  T_map_leader_.reset();
  places_.carry(T_begun_now_);
  search_.reset();
}

/// Where the places are by what is seen now; those that it does not fit are dropped.
void Localiser::look_again(const SurfaceView& view) {
  judged_path_m_ = view_.path_m();
  judged_turned_rad_ = view_.turned_rad();
  PlaceCandidates left(params_.search);
  for (const PlaceCandidate& place : places_.all()) {
    if (const auto settled = settle(field_, view, place.T_map_vehicle, params_.search)) left.add(*settled);
  }
  places_ = std::move(left);
  knows_all_ = knows_all_ && !places_.empty();
}

/// The place that the hint means, if it fits no worse than the best.
std::optional<PlaceCandidate> Localiser::told_place(const SurfaceView& view) {
  if (!T_map_hint_ || places_.empty()) return std::nullopt;
  PlaceCandidates meant(params_.search);
  const auto add_if_meant = [&](const PlaceCandidate& place) {
    const Pose2 off = between(*T_map_hint_, place.T_map_vehicle);
    if (off.position().norm() < params_.hint_m && std::abs(off.theta) < params_.hint_rad) meant.add(place);
  };
  if (const auto place = settle(field_, view, *T_map_hint_, params_.search)) add_if_meant(*place);
  std::for_each(places_.all().begin(), places_.all().end(), add_if_meant);
  if (!meant.empty() && meant.all().front().fit.misfit_m <= places_.misfit_max_m())
    return meant.all().front();
  T_map_hint_.reset();
  hint_was_wrong_ = true;
  return std::nullopt;
}

/// The only place that this view allows, and the last one as well.
std::optional<PlaceCandidate> Localiser::confirmed_place() {
  const auto rivals = places_.rivals();
  const std::optional<Pose2> T_map_last = std::exchange(T_map_leader_, std::nullopt);
  if (!knows_all_ || rivals.size() != 1) return std::nullopt;
  T_map_leader_ = rivals.front().T_map_vehicle;
  if (!T_map_last || !is_same_place(*T_map_last, *T_map_leader_, params_.search)) return std::nullopt;
  return rivals.front();
}

void Localiser::judge(const SurfaceView& view) {
  auto place = told_place(view);
  if (!were_all_rivals_sought(places_, view, params_.search)) {
    T_map_leader_.reset();
  } else if (!place) {
    place = confirmed_place();
  }
  if (place) {
    believe(*place);
  } else if (!places_.empty()) {
    state_ = LocaliserState::kAmbiguous;
  } else if (state_ == LocaliserState::kAmbiguous) {
    state_ = LocaliserState::kSearching;
  }
}

void Localiser::believe(const PlaceCandidate& place) {
  T_map_vehicle_ = {place.T_map_vehicle, covariance_of(place.information)};
  T_map_hint_.reset();
  T_map_leader_.reset();
  places_ = PlaceCandidates(params_.search);
  knows_all_ = false;
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
}

}  // namespace aisle
