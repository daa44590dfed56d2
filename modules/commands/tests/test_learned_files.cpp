#include <gmock/gmock.h>

#include "aisle/commands/learned_files.hpp"

namespace aisle {
namespace {

using testing::StartsWith;

TEST(LearnedFiles, MatchTheAnnouncedNames) {
  Building building;
  building.landmarks.add({.p_map = {1, 1}});
  const MapTruth truth({{0, 0, 0}, {1, 0, 0}}, {{5, 0, 0}, {6, 0, 0}});
  std::vector<std::string> names;
  for (const OutputFile& file : learned_files(building, truth, {{1, 1.1}})) {
    names.push_back(file.name);
    if (file.name == "landmarks.svg") {
      EXPECT_THAT(file.bytes, StartsWith("<?xml"));
    }
  }
  EXPECT_EQ(names, learned_file_names());
}

TEST(LearnedFiles, AreCompleteWithoutTruthAndWithoutALandmark) {
  EXPECT_EQ(learned_files(Building(), MapTruth(), {}).size(), learned_file_names().size());
}

}  // namespace
}  // namespace aisle
