#include "aisle/learning/rooms/room_learning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "aisle/core/median.hpp"
#include "aisle/vehicle/odometry_step.hpp"
#include "rooms/lasting_edges.hpp"
#include "rooms/pattern_views.hpp"

namespace aisle {

void RoomLearningParams::describe(FieldList& fields) {
  fields.group("path", path);
  fields.group("frame", frame);
  fields.real("frame_from_m", frame_from_m, {0, 20},
              "the parking frame is measured from this distance before the end");
  fields.real("frame_to_m", frame_to_m, {0, 20}, "up to this distance");
  fields.real("views_m", views_m, {0, 20}, "views are learned on this distance before a taught place");
  fields.real("edge_apart_m", edge_apart_m, {0.01, 1}, "edges of the route nearer to each other are merged");
  fields.real("edge_within_m", edge_within_m, {0.5, 20}, "edges farther away are not learned");
  fields.count("edge_sightings", edge_sightings, {1, 1000}, "images that must show an edge");
}

namespace {

std::optional<int> turning_number(const std::string& label) {
  int number = 0;
  const auto [end, error] = std::from_chars(label.data(), label.data() + label.size(), number);
  const bool is_whole = error == std::errc() && end == label.data() + label.size();
  return is_whole && number >= 1 && number <= kTurningNumbers ? std::optional(number) : std::nullopt;
}

/// Reads the marks in the order in which they were made.
class MarkReader {
 public:
  explicit MarkReader(RoomRoute& room) : room_(room) {}

  void read(const Mark& mark, double along_m) {
    const auto number = turning_number(mark.label);
    switch (mark.kind) {
      case Mark::Kind::kTurningBegins:
        if (!number) return wrong(fmt::format("'{}' is no turning; there are 1 to 13", mark.label));
        room_.turnings.push_back({*number, along_m, -1});
        return;
      case Mark::Kind::kTurningEnds:
        return end(along_m);
      case Mark::Kind::kStop:
        if (mark.label.empty()) {
          room_.parking = ParkingStrategy::kView;
        } else if (const auto parking = parking_of(mark.label)) {
          room_.parking = *parking;
        } else {
          wrong(fmt::format("'{}' is no way to park; there are {}", mark.label,
                            fmt::join(kParkingWords, ", ")));
        }
        return;
      case Mark::Kind::kPlace:
        return;
    }
  }

  Problems take() {
    for (const RoomTurning& turning : room_.turnings) {
      if (turning.end_m < turning.start_m) wrong(fmt::format("turning {} has no end", turning.number));
    }
    return std::move(problems_);
  }

 private:
  /// Turnings end in the order in which they began.
  void end(double along_m) {
    const auto open = std::find_if(room_.turnings.begin(), room_.turnings.end(),
                                   [](const RoomTurning& turning) { return turning.end_m < 0; });
    if (open == room_.turnings.end()) return wrong("a turning ends that has not begun");
    open->end_m = along_m;
  }
  void wrong(std::string what) { problems_.push_back({{"", 0, "marks"}, std::move(what)}); }

  RoomRoute& room_;
  Problems problems_;
};

/// The frame's size as seen in the images from a good distance.
std::optional<Vec2> frame_size(std::span<const RoomCycle> cycles, std::span<const Pose2> T_route_vehicle,
                               const RoomLearningParams& params) {
  constexpr std::size_t kImagesMin = 2, kImagesMax = 9;
  const Pose2& T_route_end = T_route_vehicle.back();
  std::vector<double> along_m, across_m;
  for (std::size_t i = 0; i < cycles.size() && along_m.size() < kImagesMax; ++i) {
    const Pose2 T_vehicle_end = between(T_route_vehicle[i], T_route_end);
    const double left_m = T_vehicle_end.position().norm();
    if (left_m < params.frame_from_m || left_m > params.frame_to_m || cycles[i].p_vehicle_painted.empty())
      continue;
    const auto fit = find_frame_and_size(cycles[i].p_vehicle_painted, T_vehicle_end.theta, params.frame);
    if (!fit) continue;
    along_m.push_back(fit->size_m.x());
    across_m.push_back(fit->size_m.y());
  }
  if (along_m.size() < kImagesMin) return std::nullopt;
  return Vec2(median(std::move(along_m)), median(std::move(across_m)));
}

std::vector<StopView> views_before_end(std::span<const RoomCycle> cycles,
                                       std::span<const Pose2> T_route_vehicle, double reach_m) {
  std::vector<StopView> views;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    const double left_m = between(T_route_vehicle[i], T_route_vehicle.back()).position().norm();
    if (cycles[i].view && left_m <= reach_m) views.push_back({left_m, *cycles[i].view});
  }
  return views;
}

bool ends_path(const RoomCycle& cycle) {
  return std::any_of(cycle.marks.begin(), cycle.marks.end(),
                     [](const Mark& mark) { return mark.kind == Mark::Kind::kStop; });
}

/// Cycles up to the stop mark.
std::size_t cycles_of_path(std::span<const RoomCycle> cycles) {
  const auto end = std::find_if(cycles.begin(), cycles.end(), ends_path);
  return static_cast<std::size_t>(end - cycles.begin()) + (end == cycles.end() ? 0 : 1);
}

std::vector<Pose2> poses_by_odometry(std::span<const RoomCycle> cycles, const VehicleDescription& vehicle) {
  std::vector<Pose2> T_route_vehicle;
  Pose2 T_route_now;
  for (const RoomCycle& cycle : cycles)
    T_route_vehicle.push_back(T_route_now = T_route_now * odometry_step(vehicle, cycle.odometry));
  return T_route_vehicle;
}

/// Views from the places of the pattern if those were driven, otherwise from the path to it.
std::vector<StopView> views_of_place(std::span<const RoomCycle> cycles,
                                     std::span<const Pose2> T_route_vehicle, std::size_t path_cycles,
                                     const RoomLearningParams& params) {
  auto views = pattern_views(cycles.subspan(path_cycles), T_route_vehicle.subspan(path_cycles),
                             T_route_vehicle[path_cycles - 1]);
  if (!views.empty()) return views;
  return views_before_end(cycles.first(path_cycles), T_route_vehicle.first(path_cycles), params.views_m);
}

}  // namespace

Result<LearnedRoute> learn_room_route(std::span<const RoomCycle> cycles, const VehicleDescription& vehicle,
                                      const RoomLearningParams& params) {
  constexpr double kPathMin_m = 0.3;
  LearnedRoute learned{.route = {}, .T_route_vehicle = poses_by_odometry(cycles, vehicle)};
  const std::size_t path_cycles = cycles_of_path(cycles);
  const auto on_path = cycles.first(path_cycles);
  const auto T_route_on_path = std::span<const Pose2>(learned.T_route_vehicle).first(path_cycles);
  RoomRoute room;
  MarkReader marks(room);
  double along_m = 0;
  std::optional<RouteBrightness> patch;
  for (const RoomCycle& cycle : on_path) {
    along_m += odometry_step(vehicle, cycle.odometry).position().norm();
    if (!patch) patch = cycle.patch;
    for (const Mark& mark : cycle.marks) marks.read(mark, along_m);
  }
  Problems problems = marks.take();
  if (!patch) problems.push_back({{}, "has no images of the camera top"});
  if (along_m < kPathMin_m) problems.push_back({{}, "the vehicle stood still all the time"});
  if (!problems.empty()) return problems;
  room.brightness = *patch;
  if (room.parking == ParkingStrategy::kFrame) {
    const auto size_m = frame_size(on_path, T_route_on_path, params);
    if (!size_m) return Problem{{}, "shows no parking frame before its end"};
    room.frame_size_m = *size_m;
  }
  if (room.parking == ParkingStrategy::kView)
    room.views = views_of_place(cycles, learned.T_route_vehicle, path_cycles, params);
  room.edges = lasting_edges(on_path, T_route_on_path, params);
  learned.route.path = fit_path(T_route_on_path, params.path);
  learned.route.room = std::move(room);
  return learned;
}

}  // namespace aisle
