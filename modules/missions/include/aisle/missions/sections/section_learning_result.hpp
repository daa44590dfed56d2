#pragma once
/// Learning a route of sections, from recorded or simulated drives.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/learning/sections/section_learning.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/vision/floor/floor_edges.hpp"

namespace aisle {

struct SectionLearnerParams {
  FloorEdgeParams floor_edges{.looks_past = 2};
  SectionLearningParams learning;

  void describe(FieldList& fields) {
    fields.group("floor_edges", floor_edges);
    fields.group("learning", learning);
  }
};

/// Detects the floor's edges of a drive, cycle by cycle.
class SectionRunCollector {
 public:
  SectionRunCollector(const FloorEdgeParams& params, const VehicleDescription& vehicle);

  void add(const Observation& observation);

  std::vector<SectionCycle> cycles;

 private:
  VehicleDescription vehicle_;
  std::string camera_;
  FloorEdgeDetector detector_;
};

/// L03 section 3.1, from a session that was just opened, of any vehicle. A session without images is a
/// problem.
Result<DrivenList> read_section_drive(const std::filesystem::path& session, SessionCycles& cycles,
                                      const SectionLearnerParams& params, Progress& progress);

struct SectionLearningResult {
  Building building;  ///< with this route only
  DrivenList driven;
  std::vector<std::size_t> taken;  ///< indices of the drives that followed the route
};

/// L03 section 3.2, from one or more drives along one route. A drive that leads nowhere is a problem.
Result<SectionLearningResult> learn_sections(std::span<const DrivenList> drives, const std::string& route,
                                             const SectionLearningParams& params);

/// Why a vehicle would get lost on the learned route, and what would help; nullopt: it would not.
std::optional<std::string> gets_lost(const SectionLearningResult& learned,
                                     const SectionLearningParams& params);

}  // namespace aisle
