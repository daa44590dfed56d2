#include "aisle/simulation/moving_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "aisle/geometry/polyline.hpp"
#include "aisle/simulation/obstacles.hpp"

namespace aisle {
namespace {

constexpr double kKeptClear_m = 0.15;  ///< least distance of people to the vehicle
constexpr double kTimeout_s = 4;
constexpr int kPersonSides = 12;

bool is_clear(const MovingBody& box, const Footprint& footprint, const Pose2& T_world_vehicle) {
  const std::vector<Segment2> edges = outline(box);
  const Pose2 T_vehicle_world = T_world_vehicle.inverse();
  const Vec2 p_box = box.T_world_body.inverse() * T_world_vehicle.position();
  const bool holds_vehicle = std::abs(p_box.x()) < box.size.x() / 2 && std::abs(p_box.y()) < box.size.y() / 2;
  return !holds_vehicle && std::none_of(edges.begin(), edges.end(), [&](const Segment2& edge) {
    return intersects(footprint, T_vehicle_world * edge);
  });
}

}  // namespace

std::vector<Segment2> outline(const MovingBody& body) {
  std::vector<Vec2> corners;
  const Vec2 half = body.size / 2;
  switch (body.kind) {
    case MovingBody::Kind::kBox:
      corners = {{-half.x(), -half.y()}, {-half.x(), half.y()}, half, {half.x(), -half.y()}};
      break;
    case MovingBody::Kind::kPerson:
      for (int i = 0; i < kPersonSides; ++i) {
        corners.emplace_back(half.cwiseProduct(unit(-2 * kPi * i / kPersonSides)));
      }
      break;
  }
  std::vector<Segment2> edges;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    edges.push_back(body.T_world_body * Segment2{corners[i], corners[(i + 1) % corners.size()]});
  }
  return edges;
}

Walker::Walker(Person person) : person_(std::move(person)), path_m_(polyline_length_m(person_.path)) {}

Pose2 Walker::pose_after(double distance_m) const {
  const double there_and_back_m = path_m_ > 0 ? std::fmod(distance_m, 2 * path_m_) : 0;
  const bool goes_back = there_and_back_m > path_m_;
  double left_m = goes_back ? 2 * path_m_ - there_and_back_m : there_and_back_m;
  for (std::size_t i = 1; i < person_.path.size(); ++i) {
    const Vec2 leg = person_.path[i] - person_.path[i - 1];
    const double leg_m = leg.norm();
    const bool is_last = i + 1 == person_.path.size();
    if (leg_m == 0 || (left_m > leg_m && !is_last)) {
      left_m -= leg_m;
      continue;
    }
    const Vec2 p = person_.path[i - 1] + std::min(left_m / leg_m, 1.0) * leg;
    return {p.x(), p.y(), wrap_angle(heading_of(leg) + (goes_back ? kPi : 0))};
  }
  return {person_.path.front().x(), person_.path.front().y(), 0};
}

void Walker::turn_back() {
  travelled_m_ = 2 * path_m_ - std::fmod(travelled_m_, 2 * path_m_);
  waited_s_ = 0;
}

std::optional<MovingBody> Walker::step(double now_s, double time_s, const Footprint& footprint,
                                       const Pose2& T_world_vehicle) {
  const double step_m = now_s > person_.start_s ? person_.speed_mps * time_s : 0;
  const Pose2 T_vehicle_world = T_world_vehicle.inverse();
  const auto clear_m_after = [&](double distance_m) {
    return distance_to(footprint, T_vehicle_world * pose_after(distance_m).position());
  };
  const double clear_m = clear_m_after(travelled_m_ + step_m);
  const bool goes_away = is_there_ && clear_m > clear_m_after(travelled_m_);
  const bool has_room = goes_away || clear_m > person_.radius_m + kKeptClear_m;
  if (has_room) {
    travelled_m_ += step_m;
    waited_s_ = 0;
    is_there_ = true;
  }
  if (!is_there_) return std::nullopt;
  if (!has_room && (waited_s_ += time_s) > kTimeout_s) turn_back();
  return MovingBody{.kind = MovingBody::Kind::kPerson,
                    .T_world_body = pose_after(travelled_m_),
                    .size = Vec2::Constant(2 * person_.radius_m),
                    .height_m = person_.height_m};
}

MovingBodies::MovingBodies(std::span<const Person> people) : people_(people.begin(), people.end()) {}

void MovingBodies::step(double now_s, double time_s, const ScenarioPlay& play, const Footprint& footprint,
                        const Pose2& T_world_vehicle) {
  bodies_.clear();
  for (Walker& person : people_) {
    if (const auto body = person.step(now_s, time_s, footprint, T_world_vehicle)) bodies_.push_back(*body);
  }
  for (std::size_t event = 0; event < play.size(); ++event) {
    if (play.is_on(event)) {
      step_event(event, now_s, time_s, play, footprint, T_world_vehicle);
    } else {
      crossing_.erase(event);
      boxes_.erase(event);
    }
  }
}

void MovingBodies::step_event(std::size_t event, double now_s, double time_s, const ScenarioPlay& play,
                              const Footprint& footprint, const Pose2& T_world_vehicle) {
  if (const auto* crossing = std::get_if<CrossingPerson>(&play.fault(event))) {
    Person person = crossing->person;
    person.start_s += now_s;
    Walker& walker = crossing_.try_emplace(event, std::move(person)).first->second;
    if (const auto body = walker.step(now_s, time_s, footprint, T_world_vehicle)) bodies_.push_back(*body);
  } else if (const auto* put = std::get_if<BlockingBox>(&play.fault(event))) {
    const MovingBody box{.T_world_body = put->T_world_box, .size = put->size, .height_m = put->height_m};
    if (!boxes_.contains(event) && is_clear(box, footprint, T_world_vehicle)) boxes_.emplace(event, box);
    if (boxes_.contains(event)) bodies_.push_back(box);
  }
}

std::vector<Segment2> MovingBodies::outlines(double height_m, double margin_m) const {
  std::vector<Segment2> edges;
  for (MovingBody body : bodies_) {
    if (body.height_m < height_m) continue;
    body.size += Vec2::Constant(2 * margin_m);
    const std::vector<Segment2> own = outline(body);
    edges.insert(edges.end(), own.begin(), own.end());
  }
  return edges;
}

}  // namespace aisle
