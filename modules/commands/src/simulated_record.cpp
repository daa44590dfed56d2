#include "simulated_record.hpp"

#include <utility>

namespace aisle {

Result<Observation> SimulatedRecord::keep(Observation observation) {
  pictures_ += observation.pictures.size();
  if (!session_) return observation;
  const SimulatedTruth& truth = vehicle_.truth();
  auto kept = session_->keep(std::move(observation));
  if (!kept) return kept.problems();
  Problems problems = session_->keep_truth(truth.stamp_s, truth.T_world_vehicle);
  if (!problems.empty()) return problems;
  return kept;
}

Problems SimulatedRecord::keep(const Decision& decision) {
  return session_ ? session_->keep(decision) : Problems{};
}

Problems close(std::optional<SessionRecord>& session) {
  return session ? session->close() : Problems{};
}

}  // namespace aisle
