#include "aisle/localisation/place_candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "aisle/core/random.hpp"

namespace aisle {
namespace {

constexpr double kBasin_m = 0.25;  // poses within so much of one another settle at the same one
constexpr double kBasin_rad = 5 * kDegree;
constexpr int kRoughHits = 60;       // of a first look at a pose,
constexpr double kRough = 0.12;      // which may miss so much of the share that is explained
constexpr double kScoreLoss = 0.05;  // the search's grid may cost the true pose so much of its score

/// Neighbours fit and fail together: in another order, a bad pose shows after a few of them.
void scatter(std::vector<Vec2>& hits) {
  Random random(1);
  for (std::size_t i = hits.size(); i > 1; --i) std::swap(hits[i - 1], hits[random.index(i)]);
}

std::vector<Vec2> some_hits(std::span<const ViewBeam> beams, int count) {
  const std::size_t step = std::max<std::size_t>(1, beams.size() / static_cast<std::size_t>(count));
  std::vector<Vec2> hits;
  hits.reserve(beams.size() / step + 1);
  for (std::size_t i = 0; i < beams.size(); i += step) hits.push_back(beams[i].p_hit);
  scatter(hits);
  return hits;
}

bool is_near(const Pose2& a, const Pose2& b, double within_m, double within_rad) {
  return (a.position() - b.position()).norm() < within_m &&
         std::abs(wrap_angle(a.theta - b.theta)) < within_rad;
}

std::array<int, 3> basin_of(const Pose2& T) {
  return {static_cast<int>(std::floor(T.x / kBasin_m)), static_cast<int>(std::floor(T.y / kBasin_m)),
          static_cast<int>(std::floor(T.theta / kBasin_rad))};
}

/// Examines poses one by one, and keeps what may be the place.
class Examination {
 public:
  Examination(const SurfaceField& field, std::span<const ViewBeam> beams, double piece_m,
              const PlaceSearchParams& params)
      : field_(field),
        beams_(beams),
        piece_m_(piece_m),
        params_(params),
        view_m_(piece_m * static_cast<double>(beams.size())),
        some_(some_hits(beams, kRoughHits)) {
    for (const ViewBeam& beam : beams) hits_.push_back(beam.p_hit);
  }

  void examine(const Pose2& T_map_guess) {
    if (!examined_.insert(basin_of(T_map_guess)).second) return;
    const Vec2& p_laser = beams_.front().p_laser;
    const SurfaceAlignment rough = align_to_surfaces(field_, some_, p_laser, T_map_guess, Mat3::Zero());
    const double explained_min = std::max(params_.explained_min, 1 - misfit_max_m() / view_m_);
    if (rough.near_share < explained_min - kRough) return;
    const SurfaceAlignment laid =
        align_to_surfaces(field_, hits_, p_laser, rough.T_map_vehicle, Mat3::Zero());
    if (!field_.can_stand(laid.T_map_vehicle.position())) return;
    const ViewFit fit = fit_of(field_, beams_, piece_m_, laid.T_map_vehicle, params_.fit);
    if (fit.explained_share() < params_.explained_min || fit.misfit_m > misfit_max_m()) return;
    keep({laid.T_map_vehicle, laid.information, fit});
  }

  /// A pose with a greater misfit is no rival. What does not fit is clutter: pieces of it fit elsewhere by
  /// chance, so the difference of two misfits varies as a count of such pieces does.
  double misfit_max_m() const {
    if (places_.empty()) return view_m_;
    const double best_m = places_.front().fit.misfit_m;
    return best_m + params_.margin_m + params_.margin_deviations * std::sqrt(params_.chance_m * best_m);
  }

  std::vector<PlaceCandidate>& places() { return places_; }

 private:
  void keep(const PlaceCandidate& place) {
    const auto same = [&](const PlaceCandidate& other) {
      return is_same_place(other.T_map_vehicle, place.T_map_vehicle, params_);
    };
    const auto known = std::find_if(places_.begin(), places_.end(), same);
    if (known != places_.end() && known->fit.misfit_m <= place.fit.misfit_m) return;
    if (known != places_.end()) places_.erase(known);
    const auto better = [](const PlaceCandidate& a, const PlaceCandidate& b) {
      return a.fit.misfit_m < b.fit.misfit_m;
    };
    places_.insert(std::upper_bound(places_.begin(), places_.end(), place, better), place);
    std::erase_if(places_, [&](const PlaceCandidate& other) { return other.fit.misfit_m > misfit_max_m(); });
  }

  const SurfaceField& field_;
  std::span<const ViewBeam> beams_;
  double piece_m_;
  const PlaceSearchParams& params_;
  double view_m_;
  std::vector<Vec2> hits_;
  std::vector<Vec2> some_;  ///< enough of them to see that a pose is none
  std::set<std::array<int, 3>> examined_;
  std::vector<PlaceCandidate> places_;
};

}  // namespace

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
  fields.count("rival_nodes", rival_nodes, {0, 1000000000}, "likewise, once two places fit");
}

bool is_same_place(const Pose2& a, const Pose2& b, const PlaceSearchParams& params) {
  return is_near(a, b, params.apart_m, params.apart_rad);
}

PlaceSearch find_places(const SurfaceField& field, const LikelihoodPyramid& map,
                        std::span<const ViewBeam> beams, double piece_m, const PlaceSearchParams& params) {
  PlaceSearch result;
  result.view_m = piece_m * static_cast<double>(beams.size());
  if (beams.empty()) return result;
  Examination examination(field, beams, piece_m, params);
  PoseSearch search(map, some_hits(beams, params.hits), params.explained_min * (1 - kScoreLoss));
  auto nodes_max = static_cast<std::size_t>(params.nodes_max);
  std::size_t nodes_alone = 0;
  while (examination.places().size() < static_cast<std::size_t>(params.places_max)) {
    const double score_min = 1 - examination.misfit_max_m() / result.view_m - kScoreLoss;
    if (examination.places().size() > 1) {
      if (nodes_alone == 0) nodes_alone = search.nodes();
      nodes_max = std::min(nodes_max, nodes_alone + static_cast<std::size_t>(params.rival_nodes));
    }
    const auto pose = search.next(score_min, nodes_max);
    if (!pose) break;
    examination.examine(pose->T_map_vehicle);
  }
  result.is_complete = !search.is_cut_short();
  result.misfit_max_m = examination.misfit_max_m();
  result.nodes = search.nodes();
  result.places = std::move(examination.places());
  return result;
}

}  // namespace aisle
