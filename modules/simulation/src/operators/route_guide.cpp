#include "aisle/simulation/operators/route_guide.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/core/angle.hpp"
#include "aisle/geometry/polyline.hpp"
#include "aisle/maps/view_pattern.hpp"
#include "aisle/simulation/obstacles.hpp"
#include "operators/operator_path.hpp"

namespace aisle {
namespace {

World with_tour(World world, const WorldRoute& route, const std::vector<Vec2>& beyond) {
  world.tour = route.path;
  world.tour.insert(world.tour.end(), beyond.begin(), beyond.end());
  return world;
}

/// Where the vehicle turns back on the lanes around the route's end: before and beyond each.
std::vector<Vec2> turns_about_place(const World& world, const WorldRoute& route, const Footprint& footprint) {
  constexpr double kRunUp_m = 1, kClearance_m = 0.05, kStep_m = 0.1;
  Obstacles obstacles(world, with_clearance(footprint, kClearance_m));
  const Vec2& p = route.path.back();
  const Pose2 T_world_place{p.x(), p.y(), heading_of(p - *(route.path.end() - 2))};
  std::vector<Vec2> turns;
  for (const ViewLane& lane : view_pattern()) {
    const double begin_m = lane.along_m.front() - kRunUp_m, end_m = lane.along_m.back();
    bool is_free = true;
    for (int step = 0; begin_m + step * kStep_m < end_m; ++step)
      is_free = is_free && !obstacles.touch(T_world_place * lane.at(begin_m + step * kStep_m));
    if (!is_free) continue;
    turns.push_back(T_world_place * lane.at(begin_m).position());
    turns.push_back(T_world_place * lane.at(end_m).position());
  }
  return turns;
}

/// Distance along a polyline to its point nearest to `p`, among those from `from_m` to `to_m`.
double along_path_m(const std::vector<Vec2>& path, const Vec2& p, double from_m, double to_m) {
  constexpr double kStep_m = 0.02;
  double best_m = from_m, least_m = -1, begin_m = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 step = path[i] - path[i - 1];
    const double length_m = step.norm();
    const int steps = static_cast<int>(length_m / kStep_m);
    for (int k = 0; k <= steps; ++k) {
      const double at_m = begin_m + k * kStep_m;
      if (at_m < from_m || at_m > to_m) continue;
      const double off_m = (path[i - 1] + k * kStep_m / length_m * step - p).norm();
      if (least_m >= 0 && off_m >= least_m) continue;
      least_m = off_m;
      best_m = at_m;
    }
    begin_m += length_m;
  }
  return best_m;
}

/// Distance along a polyline to the first point after `from_m` where it turns back, or to its end.
double next_turning_back_m(const std::vector<Vec2>& path, double from_m) {
  constexpr double kTurnsBack_rad = 120 * kDegree;
  double along_m = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 step = path[i] - path[i - 1];
    along_m += step.norm();
    const bool turns_back =
        i + 1 == path.size() || std::abs(turn_between(step, path[i + 1] - path[i])) > kTurnsBack_rad;
    if (turns_back && along_m > from_m) return along_m;
  }
  return along_m;
}

}  // namespace

const WorldRoute* route_of(const World& world, const std::string& name) {
  const auto route = std::find_if(world.routes.begin(), world.routes.end(),
                                  [&](const WorldRoute& candidate) { return candidate.name == name; });
  return route == world.routes.end() ? nullptr : &*route;
}

Pose2 start_of(const WorldRoute& route) {
  const Vec2& p = route.path.front();
  return {p.x(), p.y(), heading_of(route.path[1] - p)};
}

RouteGuide::RouteGuide(const World& world, const WorldRoute& route, const VehicleDescription& vehicle,
                       const ScriptedOperatorParams& params, std::uint64_t seed, ShownViews views)
    : route_(route),
      about_place_(views == ShownViews::kPattern ? turns_about_place(world, route, vehicle.footprint)
                                                 : std::vector<Vec2>()),
      driver_(with_tour(world, route, about_place_), vehicle, params, seed) {
  for (const TaughtTurning& turning : world.turnings) {
    if (turning.route != route.name) continue;
    const double at_m = along_path_m(route.path, turning.at, 0, polyline_length_m(route.path));
    const std::string number = std::to_string(turning.number);
    marks_.push_back({at_m - turning.before_m, {Mark::Kind::kTurningBegins, number}});
    marks_.push_back({at_m + turning.after_m, {Mark::Kind::kTurningEnds, number}});
  }
  std::stable_sort(marks_.begin(), marks_.end(),
                   [](const TurningMark& a, const TurningMark& b) { return a.along_m < b.along_m; });
}

OperatorInput RouteGuide::look(const OperatorView& view) {
  constexpr double kAhead_m = 0.6, kTurnedBack_m = 0.12;
  const bool is_at_end = driver_.legs_left() == about_place_.size();
  OperatorInput input = driver_.look(view);
  const double back_m = next_turning_back_m(route_.path, along_m_);
  const double to_m =
      along_m_ < back_m - kTurnedBack_m ? std::min(back_m, along_m_ + kAhead_m) : along_m_ + kAhead_m;
  along_m_ = along_path_m(route_.path, view.T_world_vehicle.position(), along_m_, to_m);
  while (!marks_.empty() && (marks_.front().along_m <= along_m_ || is_at_end)) {
    input.marks.insert(input.marks.begin(), marks_.front().mark);
    marks_.erase(marks_.begin());
  }
  std::erase_if(input.marks, [](const Mark& mark) { return mark.kind == Mark::Kind::kStop; });
  if (is_at_end && !std::exchange(has_shown_path_, true))
    input.marks.push_back({Mark::Kind::kStop, std::string(parking_word(route_.parking))});
  input.gives_up = input.gives_up && !has_shown_path_;
  return input;
}

}  // namespace aisle
