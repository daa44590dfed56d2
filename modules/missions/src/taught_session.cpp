#include "aisle/missions/taught_session.hpp"

#include "aisle/formats/sessions/session_truth.hpp"
#include "aisle/missions/route_name.hpp"

namespace aisle {

Result<std::string> route_of_session(const std::filesystem::path& session, const SessionOrigin& origin) {
  const std::string named = origin.route.empty() ? "route" : origin.route;
  if (Problems problems = check_route_name({session.string(), 0, "route"}, named); !problems.empty())
    return problems;
  return named;
}

Result<std::size_t> take_observations(const std::filesystem::path& session, SessionCycles& cycles,
                                      Progress& progress,
                                      const std::function<void(const Observation&)>& take) {
  std::size_t images = 0;
  bool is_empty = true;
  while (true) {
    auto cycle = cycles.next();
    if (!cycle) return cycle.problems();
    if (!cycle->has_value()) break;
    is_empty = false;
    images += (*cycle)->observation.images.size();
    take((*cycle)->observation);
    progress.report("looking at images", images, 0);
  }
  if (is_empty) return Problem{{session.string()}, "has no cycles"};
  return images;
}

Result<std::vector<Pose2>> true_poses(const std::filesystem::path& session, std::size_t cycles) {
  auto truth = read_true_poses(session);
  if (!truth) return truth.problems();
  if (truth->T_map_vehicle.size() != cycles) return std::vector<Pose2>();
  return std::move(truth->T_map_vehicle);
}

}  // namespace aisle
