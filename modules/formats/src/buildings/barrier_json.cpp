#include "buildings/building_parts.hpp"

#include <array>

namespace aisle {
namespace {

constexpr std::size_t kBarriersMax = 1000;
constexpr std::array<std::string_view, 2> kBarrierKinds = {"keep_out", "glass"};

JsonFields barrier_fields(Barrier& barrier) {
  return {needed(field::word("kind", barrier.kind, kBarrierKinds)),
          needed(field::point("start_m", barrier.segment.start, kMapCoordinate_m)),
          needed(field::point("end_m", barrier.segment.end, kMapCoordinate_m))};
}

}  // namespace

JsonPart barriers_part(std::string_view key, std::vector<Barrier>& barriers) {
  return objects_part(key, barriers, kBarriersMax, barrier_fields);
}

}  // namespace aisle
