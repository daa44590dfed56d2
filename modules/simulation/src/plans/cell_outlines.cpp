#include "plans/cell_outlines.hpp"

#include <array>

namespace aisle {
namespace {

/// A step along the border of a cell, in the order of left turns.
enum class Heading : std::uint8_t { kRight, kUp, kLeft, kDown };

constexpr std::array<LatticePoint, 4> kSteps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
/// The cell ahead on the left, seen from a lattice point.
constexpr std::array<LatticePoint, 4> kAheadLeft = {{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};

constexpr Heading turned(Heading heading, unsigned quarter_turns) {
  return static_cast<Heading>((static_cast<unsigned>(heading) + quarter_turns) % 4);
}
constexpr Heading left_of(Heading heading) {
  return turned(heading, 1);
}
constexpr Heading right_of(Heading heading) {
  return turned(heading, 3);
}

class OutlineFollower {
 public:
  explicit OutlineFollower(const FloorPlan& plan) : plan_(plan), followed_(plan.solid.size(), false) {}

  std::vector<Outline> follow_all() {
    std::vector<Outline> outlines;
    for (int y = 0; y < plan_.height; ++y) {
      for (int x = 0; x < plan_.width; ++x) {
        const bool is_floor_of_free_cell = !plan_.is_solid(x, y) && plan_.is_solid(x, y - 1);
        if (is_floor_of_free_cell && !followed_[plan_.index(x, y)]) outlines.push_back(follow({x, y}));
      }
    }
    return outlines;
  }

 private:
  bool is_solid_ahead(LatticePoint at, Heading heading, bool left) const {
    const LatticePoint cell = kAheadLeft[static_cast<unsigned>(left ? heading : right_of(heading))];
    return plan_.is_solid(at.x + cell.x, at.y + cell.y);
  }

  Outline follow(LatticePoint start) {
    Outline corners;
    LatticePoint at = start;
    Heading heading = Heading::kRight;
    do {
      if (heading == Heading::kRight) followed_[plan_.index(at.x, at.y)] = true;
      at = {at.x + kSteps[static_cast<unsigned>(heading)].x, at.y + kSteps[static_cast<unsigned>(heading)].y};
      Heading next = heading;
      if (is_solid_ahead(at, heading, true)) {
        next = left_of(heading);
      } else if (!is_solid_ahead(at, heading, false)) {
        next = right_of(heading);
      }
      if (next != heading) corners.push_back(at);
      heading = next;
    } while (!(at == start && heading == Heading::kRight));
    return corners;
  }

  const FloorPlan& plan_;
  std::vector<bool> followed_;  ///< the step along the lower side of a cell
};

}  // namespace

std::vector<Outline> cell_outlines(const FloorPlan& plan) {
  return OutlineFollower(plan).follow_all();
}

}  // namespace aisle
