#include "aisle/maps/section.hpp"

#include <cmath>

namespace aisle {
namespace {

constexpr double kLeastTurn_rad = 1e-9;

/// Appends one piece of path after the other.
class PathLayer {
 public:
  PathLayer(const Pose2& T_map_start, std::vector<std::size_t>* piece_sections)
      : T_map_end_(T_map_start), piece_sections_(piece_sections) {}

  void add(const Arc& arc, std::size_t section) {
    if (arc.length_m == 0 && std::abs(arc.turn_rad) < kLeastTurn_rad) return;
    pieces_.push_back({T_map_end_, arc});
    T_map_end_ = pieces_.back().end();
    if (piece_sections_ != nullptr) piece_sections_->push_back(section);
  }

  /// The parabola starts in another direction than the vehicle's, so the vehicle turns first.
  void add_curve(const Vec2& p_start_end, std::size_t section) {
    const Pose2 T_map_start = T_map_end_;
    const auto turn_to = [&](double heading_rad) {
      add({0, wrap_angle(T_map_start.theta + heading_rad - T_map_end_.theta)}, section);
    };
    turn_to(std::atan2(p_start_end.y(), 2 * p_start_end.x()));
    for (const Vec2& p_start_vertex : curve_vertices(p_start_end)) {
      const Vec2 chord = T_map_end_.inverse() * (T_map_start * p_start_vertex);
      const double turn_rad = 2 * heading_of(chord);
      const double half_rad = turn_rad / 2;
      const double bent = half_rad == 0 ? 1 : half_rad / std::sin(half_rad);
      add({chord.norm() * bent, turn_rad}, section);
    }
    turn_to(kPi / 2);
  }

  Path take() { return Path(std::move(pieces_)); }

 private:
  Pose2 T_map_end_;
  std::vector<PathPiece> pieces_;
  std::vector<std::size_t>* piece_sections_;
};

}  // namespace

std::vector<Vec2> curve_vertices(const Vec2& p_start_end) {
  const double ahead_m = p_start_end.x(), left_m = p_start_end.y();
  const double bend = ahead_m / (left_m * left_m);  // x = ahead - bend (left - y)^2
  std::vector<Vec2> vertices;
  double y = 0;
  constexpr int kQuantaToQuarter = 36;
  for (int quanta = 1; quanta < kQuantaToQuarter; ++quanta) {
    const double direction_rad = quanta * kTurnQuantum_rad;
    const double next = 2 * left_m - y - 1 / (std::tan(direction_rad) * bend);
    if (next <= y) continue;
    if (next >= left_m) break;
    y = next;
    vertices.emplace_back(ahead_m - bend * (left_m - y) * (left_m - y), y);
  }
  vertices.push_back(p_start_end);
  return vertices;
}

Path path_of(const SectionList& sections, const Pose2& T_map_start,
             std::vector<std::size_t>* piece_sections) {
  PathLayer layer(T_map_start, piece_sections);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const Section& section = sections[i];
    if (section.kind == Section::Kind::kTurn) {
      layer.add({0, section.turn_rad}, i);
    } else if (section.kind == Section::Kind::kCurve) {
      layer.add_curve(section.p_start_end, i);
    } else {
      layer.add({section.kind == Section::Kind::kBack ? -section.length_m : section.length_m, 0}, i);
    }
  }
  return layer.take();
}

}  // namespace aisle
