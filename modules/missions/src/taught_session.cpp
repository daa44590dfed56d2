#include "aisle/missions/taught_session.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "aisle/formats/sessions/session_truth.hpp"
#include "aisle/missions/route_name.hpp"

namespace aisle {
namespace {

/// Hands observations on with every image in the cycle whose end is nearest to when it was taken.
class ImagesInTime {
 public:
  explicit ImagesInTime(const std::function<void(const Observation&)>& take) : take_(take) {}

  void add(Observation observation) {
    std::vector<CameraImage> images = std::move(observation.images);
    observation.images.clear();
    waiting_.push_back(std::move(observation));
    for (CameraImage& image : images) nearest_to(image.stamp_s).images.push_back(std::move(image));
    while (waiting_.front().stamp_s < waiting_.back().stamp_s - kLateMax_s) hand_on();
  }

  void end() {
    while (!waiting_.empty()) hand_on();
  }

 private:
  static constexpr double kLateMax_s = 1;

  Observation& nearest_to(double stamp_s) {
    return *std::min_element(waiting_.begin(), waiting_.end(),
                             [&](const Observation& a, const Observation& b) {
                               return std::abs(a.stamp_s - stamp_s) < std::abs(b.stamp_s - stamp_s);
                             });
  }

  void hand_on() {
    take_(waiting_.front());
    waiting_.pop_front();
  }

  const std::function<void(const Observation&)>& take_;
  std::deque<Observation> waiting_;
};

}  // namespace

Problems check_for_learning(const std::filesystem::path& session, const SessionOrigin& origin) {
  if (!origin.has_odometry)
    return {{{session.string()}, "has no odometry: nothing can be learned from images alone"}};
  if (!origin.has_calibration) {
    return {
        {{session.string()},
         "tells nothing of its camera's lens and mount, by which a map is made: import it with --vehicle"}};
  }
  return {};
}

Result<std::string> route_of_session(const std::filesystem::path& session, const SessionOrigin& origin) {
  const std::string named = origin.route.empty() ? "route" : origin.route;
  if (Problems problems = check_route_name({session.string(), 0, "route"}, named); !problems.empty())
    return problems;
  return named;
}

Result<std::size_t> take_observations(const std::filesystem::path& session, SessionCycles& cycles,
                                      Progress& progress,
                                      const std::function<void(const Observation&)>& take) {
  if (Problems problems = check_for_learning(session, cycles.origin()); !problems.empty()) return problems;
  std::size_t images = 0;
  bool is_empty = true;
  ImagesInTime in_time(take);
  while (true) {
    auto cycle = cycles.next();
    if (!cycle) return cycle.problems();
    if (!cycle->has_value()) break;
    is_empty = false;
    images += (*cycle)->observation.images.size();
    in_time.add(std::move((*cycle)->observation));
    progress.report("looking at images", images, 0);
  }
  in_time.end();
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
