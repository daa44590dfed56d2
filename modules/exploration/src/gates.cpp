#include "aisle/exploration/gates.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "gate_sill.hpp"

namespace aisle {
namespace {

constexpr double kCountedBehind_m2 = 2;  // more floor behind a gate is not told apart
constexpr std::size_t kRimMax = 24;      // points that stand for a rim
constexpr double kBesideCells = 1.5;     // between two that touch distances differ by less

class GateFinder {
 public:
  GateFinder(const FloorGrid& floor, const FloorClearance& clearance, const FloorDistances& reached,
             const GateParams& params, CellMarks& marks)
      : floor_(floor), clearance_(clearance), reached_(reached), params_(params), marks_(marks) {
    marks_.assign(clearance.size(), kNothing);
  }

  std::vector<Gate> find() {
    std::vector<FloorCell> sills = mark_sills();
    std::vector<Gate> gates;
    for (const FloorCell cell : sills) {
      if (marks_[clearance_.index(cell)] != kSill) continue;
      Gate gate = gather(cell);
      measure_behind(gate);
      if (gate.behind_m2 >= params_.area_min_m2 && !gate.rim.empty()) gates.push_back(std::move(gate));
    }
    return gates;
  }

 private:
  enum Mark : std::uint8_t { kNothing, kSill, kTaken, kCounted };

  bool is_sure(FloorCell cell) const { return clearance_.to_doubtful_m(cell) >= params_.room_m; }
  bool may_be_floor(FloorCell cell) const {
    return clearance_.to_occupied_m(cell) >= params_.room_m + params_.doubt_m;
  }
  bool is_doubtful(FloorCell cell) const {
    return clearance_.room().contains(cell) && may_be_floor(cell) && !is_sure(cell);
  }

  template <class Visit>
  static void for_neighbours(FloorCell cell, int reach, Visit visit) {
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        if (x != 0 || y != 0) visit(FloorCell{cell.x + x, cell.y + y});
      }
    }
  }

  std::vector<FloorCell> mark_sills() {
    std::vector<FloorCell> sills;
    const double sure_m = params_.room_m, beside_doubt_m = sure_m + kBesideCells * floor_.cell_m();
    clearance_.for_cells(floor_.known(), [&](FloorCell cell, std::size_t index) {
      const double room_m = clearance_.to_doubtful_m(index);
      if (room_m < sure_m || room_m >= beside_doubt_m) return;
      if (!may_be_floor(cell) || reached_.to(cell) == FloorDistances::kUnreached) return;
      bool borders = false;
      for_neighbours(cell, 1, [&](FloorCell next) { borders = borders || is_doubtful(next); });
      if (!borders) return;
      marks_[index] = kSill;
      sills.push_back(cell);
    });
    return sills;
  }

  Gate gather(FloorCell first) {
    const int gap = static_cast<int>(params_.cluster_gap_m / floor_.cell_m());
    Gate gate;
    gate.sill.push_back(first);
    marks_[clearance_.index(first)] = kTaken;
    for (std::size_t i = 0; i < gate.sill.size(); ++i) {
      for_neighbours(FloorCell(gate.sill[i]), gap, [&](FloorCell next) {
        if (!clearance_.room().contains(next) || marks_[clearance_.index(next)] != kSill) return;
        marks_[clearance_.index(next)] = kTaken;
        gate.sill.push_back(next);
      });
    }
    measure_sill(floor_, gate);
    gate.way_m = FloorDistances::kUnreached;
    for (const FloorCell cell : gate.sill) gate.way_m = std::min<double>(gate.way_m, reached_.to(cell));
    return gate;
  }

  /// Walks over the doubtful floor behind the sill, nearest first: its area and where the free floor ends.
  void measure_behind(Gate& gate) {
    std::vector<FloorCell> behind;
    const auto count = [&](FloorCell cell) {
      if (!is_doubtful(cell) || marks_[clearance_.index(cell)] == kCounted) return;
      marks_[clearance_.index(cell)] = kCounted;
      behind.push_back(cell);
    };
    for (const FloorCell cell : gate.sill) for_neighbours(cell, 1, count);
    const double cell_m2 = floor_.cell_m() * floor_.cell_m();
    const auto enough = static_cast<std::size_t>(kCountedBehind_m2 / cell_m2);
    for (std::size_t i = 0; i < behind.size() && behind.size() < enough; ++i)
      for_neighbours(FloorCell(behind[i]), 1, count);
    gate.behind_m2 = static_cast<double>(behind.size()) * cell_m2;
    collect_rim(gate, behind);
    for (const FloorCell cell : behind) marks_[clearance_.index(cell)] = kNothing;
  }

  void collect_rim(Gate& gate, const std::vector<FloorCell>& behind) {
    std::vector<FloorCell> rim;
    const int reach = static_cast<int>(std::ceil(params_.room_m / floor_.cell_m()));
    for (const FloorCell cell : behind) {
      if (floor_.at(cell) == Floor::kUnknown) add_edge(cell, rim);
    }
    if (!rim.empty()) return thin_out(rim, gate);
    // the doubt lies beside floor that is free: what is unknown is within the vehicle's width of it
    for (const FloorCell cell : behind) {
      for_neighbours(cell, reach, [&](FloorCell next) {
        if (floor_.at(next) == Floor::kUnknown) add_edge(next, rim);
      });
    }
    thin_out(rim, gate);
  }

  /// An unknown cell beside a free one lies on the rim.
  void add_edge(FloorCell cell, std::vector<FloorCell>& rim) const {
    bool borders = false;
    for_neighbours(cell, 1, [&](FloorCell next) { borders = borders || floor_.at(next) == Floor::kFree; });
    if (borders) rim.push_back(cell);
  }

  void thin_out(const std::vector<FloorCell>& rim, Gate& gate) const {
    const std::size_t every = rim.size() / kRimMax + 1;
    for (std::size_t i = every / 2; i < rim.size(); i += every) gate.rim.push_back(floor_.centre(rim[i]));
    if (gate.rim.empty() && !rim.empty()) gate.rim.push_back(floor_.centre(rim.front()));
  }

  const FloorGrid& floor_;
  const FloorClearance& clearance_;
  const FloorDistances& reached_;
  const GateParams& params_;
  CellMarks& marks_;
};

}  // namespace

void GateParams::describe(FieldList& fields) {
  fields.real("room_m", room_m, {0.05, 2},
              "from the vehicle's middle line to anything that is not free floor");
  fields.real("doubt_m", doubt_m, {0.02, 0.5}, "where so much more is free of things there may be floor");
  fields.real("area_min_m2", area_min_m2, {0.01, 5}, "less floor behind a gate is no path");
  fields.real("cluster_gap_m", cluster_gap_m, {0.05, 1}, "pieces of a gate so near to each other are one");
}

Gate with_cells_halved(Gate gate) {
  const auto halved = [](FloorCell cell) { return FloorCell{2 * cell.x, 2 * cell.y}; };
  for (FloorCell& cell : gate.sill) cell = halved(cell);
  gate.box = {halved(gate.box.low), halved(gate.box.end)};
  gate.stand = halved(gate.stand);
  return gate;
}

std::vector<Gate> find_gates(const FloorGrid& floor, const FloorClearance& clearance,
                             const FloorDistances& reached, const GateParams& params, CellMarks& marks) {
  return GateFinder(floor, clearance, reached, params, marks).find();
}

}  // namespace aisle
