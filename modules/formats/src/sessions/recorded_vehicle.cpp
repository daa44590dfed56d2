#include "aisle/formats/sessions/recorded_vehicle.hpp"

namespace aisle {

std::optional<Observation> RecordedVehicle::sense() {
  decision_.reset();
  auto cycle = cycles_.next();
  if (!cycle) {
    problems_ = cycle.problems();
    return std::nullopt;
  }
  if (!cycle->has_value()) return std::nullopt;
  decision_ = std::move((*cycle)->decision);
  return std::move((*cycle)->observation);
}

}  // namespace aisle
