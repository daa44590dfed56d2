#pragma once
/// Learning a way by sections, from a recorded or a simulated drive.

#include <filesystem>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/session_cycles.hpp"
#include "aisle/learning/section_learning.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/vision/floor_edges.hpp"

namespace aisle {

struct SectionLessonParams {
  FloorEdgeParams floor_edges;
  SectionLearningParams learning;

  void describe(FieldList& fields) {
    fields.group("floor_edges", floor_edges);
    fields.group("learning", learning);
  }
};

/// Finds the floor's edges in one cycle after another.
class SectionTripCollector {
 public:
  SectionTripCollector(const FloorEdgeParams& params, const VehicleDescription& vehicle);

  void add(const Observation& observation);

  std::vector<SectionCycle> cycles;

 private:
  VehicleDescription vehicle_;
  std::string camera_;
  FloorEdgeDetector detector_;
};

/// All cycles of a session that was just opened. A session without pictures is a problem.
Result<std::vector<SectionCycle>> read_section_trip(const std::filesystem::path& session,
                                                    SessionCycles& cycles, const FloorEdgeParams& params,
                                                    Progress& progress);

struct SectionLesson {
  Building building;  ///< with the route alone
  DrivenList driven;
};

/// L03 section 3, from a drive of any vehicle. One that leads nowhere is a problem.
Result<SectionLesson> learn_sections(const std::vector<SectionCycle>& cycles,
                                     const VehicleDescription& vehicle, const std::string& route,
                                     const SectionLessonParams& params);

}  // namespace aisle
