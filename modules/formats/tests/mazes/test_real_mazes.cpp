#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "aisle/exploration/exploration_run.hpp"
#include "aisle/formats/mazes/maze_file.hpp"
#include "real_data.hpp"

namespace aisle {
namespace {

struct IndexRow {
  std::string file;
  std::size_t reachable = 0;
};

std::vector<IndexRow> read_index(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::string line;
  std::getline(stream, line);
  std::vector<IndexRow> rows;
  while (std::getline(stream, line)) {
    std::istringstream fields(line);
    std::string width, height, start, goals;
    IndexRow row;
    std::getline(fields, row.file, '\t');
    fields >> width >> height >> start >> goals >> row.reachable;
    rows.push_back(row);
  }
  return rows;
}

TEST(RealMazes, AreExploredCompletelyByEveryRuleSet) {
  const auto folder = real_data() / "worlds/micromouse";
  AISLE_NEEDS(folder / "INDEX.tsv");
  SilentProgress progress;
  const std::vector<IndexRow> index = read_index(folder / "INDEX.tsv");
  EXPECT_EQ(index.size(), 519U);
  for (const IndexRow& row : index) {
    const auto maze = read_maze(folder / row.file);
    ASSERT_TRUE(maze.ok()) << to_string(maze.problems());
    for (const GridRuleSet set : kGridRuleSets) {
      const auto figures = explore(maze->world, maze->world.start, grid_rules(set), progress).figures;
      EXPECT_TRUE(figures.complete()) << row.file << " by " << name_of(set);
      EXPECT_EQ(figures.reachable, row.reachable) << row.file;
      EXPECT_TRUE(figures.max_edge_uses <= 2 || set != GridRuleSet::kShortcut) << row.file;
    }
  }
}

}  // namespace
}  // namespace aisle
