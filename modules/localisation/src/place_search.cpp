#include "aisle/localisation/place_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/core/random.hpp"

namespace aisle {
namespace {

constexpr double kBasin_m = 0.25;  // poses within so much of one another settle at the same one
constexpr double kBasin_rad = 5 * kDegree;
constexpr int kRoughHits = 60;       // of a first look at a pose,
constexpr double kRough = 0.12;      // which may miss so much of the share that is explained
constexpr double kScoreLoss = 0.05;  // the search's grid may cost the true pose so much of its score
constexpr std::size_t kNodesPerExamination = 200;  // that take about as long

/// Neighbours fit and fail together: in another order, a bad pose shows after a few of them.
void scatter(std::vector<Vec2>& hits) {
  Random random(1);
  for (std::size_t i = hits.size(); i > 1; --i) std::swap(hits[i - 1], hits[random.index(i)]);
}

std::vector<Vec2> some_of(const std::vector<Vec2>& all, int count) {
  const std::size_t step = std::max<std::size_t>(1, all.size() / static_cast<std::size_t>(count));
  std::vector<Vec2> hits;
  hits.reserve(all.size() / step + 1);
  for (std::size_t i = 0; i < all.size(); i += step) hits.push_back(all[i]);
  scatter(hits);
  return hits;
}

std::array<int, 3> basin_of(const Pose2& T) {
  return {static_cast<int>(std::floor(T.x / kBasin_m)), static_cast<int>(std::floor(T.y / kBasin_m)),
          static_cast<int>(std::floor(T.theta / kBasin_rad))};
}

}  // namespace

PlaceSearch::PlaceSearch(const SurfaceField& field, const LikelihoodPyramid& map, SurfaceView view,
                         PlaceCandidates known, const PlaceSearchParams& params)
    : field_(field),
      params_(params),
      view_(std::move(view)),
      some_hits_(some_of(view_.hits, kRoughHits)),
      search_(map, some_of(view_.hits, params.hits), params.explained_min * (1 - kScoreLoss)),
      places_(std::move(known)) {
  places_.drop_beaten();
}

bool PlaceSearch::advance() {
  const auto nodes_max = static_cast<std::size_t>(params_.nodes_max);
  std::size_t slice_end = search_.nodes() + static_cast<std::size_t>(params_.nodes_per_scan);
  while (!has_ended_) {
    const auto pose = search_.next(explained_min() - kScoreLoss, std::min(slice_end, nodes_max));
    if (pose) {
      if (examine(pose->T_map_vehicle)) slice_end -= std::min(slice_end, kNodesPerExamination);
      has_ended_ = places_.all().size() >= static_cast<std::size_t>(params_.places_max);
    } else {
      has_ended_ = !search_.is_cut_short() || search_.nodes() >= nodes_max;
      break;
    }
  }
  return has_ended_;
}

/// @return whether that took any work
bool PlaceSearch::examine(const Pose2& T_map_guess) {
  if (!examined_.insert(basin_of(T_map_guess)).second) return false;
  const SurfaceAlignment rough =
      align_to_surfaces(field_, some_hits_, view_.beams.front().p_laser, T_map_guess, Mat3::Zero());
  if (rough.near_share < explained_min() - kRough) return true;
  const auto place = settle(field_, view_, rough.T_map_vehicle, params_);
  if (place && place->fit.misfit_m <= places_.misfit_max_m()) {
    places_.add(*place);
    places_.drop_beaten();
  }
  return true;
}

/// A pose that explains less of the view is no rival of the best.
double PlaceSearch::explained_min() const {
  return std::max(params_.explained_min, 1 - places_.misfit_max_m() / view_.surface_m());
}

}  // namespace aisle
