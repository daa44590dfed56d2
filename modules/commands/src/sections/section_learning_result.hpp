#pragma once
/// Learning a path by sections, from a recorded or a simulated drive.

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

/// Finds the floor's edges in one cycle after another.
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

/// L03 section 3.1, from a session that was just opened, of any vehicle. One without images is a problem.
Result<DrivenList> read_section_drive(const std::filesystem::path& session, SessionCycles& cycles,
                                      const SectionLearnerParams& params, Progress& progress);

struct SectionLearningResult {
  Building building;  ///< with the route alone
  DrivenList driven;
  std::vector<std::size_t> taken;  ///< of the drives: those that went the path
};

/// L03 section 3.2, from one or more drives of one way. One that leads nowhere is a problem.
Result<SectionLearningResult> learn_sections(std::span<const DrivenList> drives, const std::string& route,
                                             const SectionLearningParams& params);

/// Why a vehicle would get lost on what was learned, and what would help; nullopt: it would not.
std::optional<std::string> gets_lost(const SectionLearningResult& learned,
                                     const SectionLearningParams& params);

}  // namespace aisle
