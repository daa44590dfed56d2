#include "aisle/guidance/exploration/exploring_phase.hpp"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace aisle {
namespace {

using PhaseAfter = std::map<std::pair<ExploringPhase, ExploringEvent>, ExploringPhase>;

PhaseAfter allowed_pairs() {
  using enum ExploringPhase;
  using enum ExploringEvent;
  return {
      {{kLooking, kLookedAround}, kSearching},  {{kLooking, kPathDropped}, kLooking},
      {{kLooking, kGaveUp}, kGivenUp},          {{kSearching, kPathFound}, kDriving},
      {{kSearching, kTrailFound}, kRetreating}, {{kSearching, kProbeFound}, kProbing},
      {{kSearching, kPathEnded}, kSearching},   {{kSearching, kPathDropped}, kSearching},
      {{kSearching, kCameHome}, kHome},         {{kSearching, kGaveUp}, kGivenUp},
      {{kDriving, kPathFound}, kDriving},       {{kDriving, kPathEnded}, kSearching},
      {{kDriving, kPathDropped}, kSearching},   {{kDriving, kGaveUp}, kGivenUp},
      {{kRetreating, kPathEnded}, kSearching},  {{kRetreating, kPathDropped}, kSearching},
      {{kRetreating, kGaveUp}, kGivenUp},       {{kProbing, kPathEnded}, kSearching},
      {{kProbing, kPathDropped}, kSearching},   {{kProbing, kGaveUp}, kGivenUp},
      {{kHome, kPathDropped}, kHome},           {{kHome, kGaveUp}, kHome},
      {{kGivenUp, kPathDropped}, kGivenUp},     {{kGivenUp, kGaveUp}, kGivenUp},
  };
}

TEST(ExploringPhase, EveryEventLeadsToItsPhaseOrCannotHappen) {
  const PhaseAfter allowed = allowed_pairs();
  std::size_t visited = 0;
  for (std::size_t row = 0; row < kExploringPhases; ++row) {
    for (std::size_t column = 0; column < kExploringEvents; ++column) {
      const auto phase = static_cast<ExploringPhase>(row);
      const auto event = static_cast<ExploringEvent>(column);
      SCOPED_TRACE(std::string(name_of(phase)) + ", " + std::string(name_of(event)));
      EXPECT_FALSE(name_of(phase).empty() || name_of(event).empty());
      const auto expected = allowed.find({phase, event});
      if (expected == allowed.end()) {
        EXPECT_THROW(phase_after(phase, event), std::logic_error);
        continue;
      }
      EXPECT_EQ(phase_after(phase, event), expected->second);
      ++visited;
    }
  }
  EXPECT_EQ(visited, allowed.size());
}

}  // namespace
}  // namespace aisle
