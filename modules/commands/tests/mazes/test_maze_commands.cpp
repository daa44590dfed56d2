#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "aisle/commands/mazes/maze_explore.hpp"
#include "aisle/commands/mazes/maze_generate.hpp"
#include "aisle/commands/mazes/maze_table.hpp"
#include "aisle/formats/mazes/maze_file.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::SizeIs;

class MazeCommands : public testing::Test {
 protected:
  void SetUp() override {
    directory_ = fs::temp_directory_path() / ("aisle-maze-" + std::to_string(getpid()));
    fs::create_directories(directory_);
  }
  void TearDown() override { fs::remove_all(directory_); }

  std::string generated(MazeKind kind, int size, const std::string& name) {
    MazeGenerateOptions options{{kind, size, size}, 1, directory_ / name};
    EXPECT_TRUE(run_maze_generate(options, console_).ok());
    return options.out.string();
  }

  fs::path directory_;
  SilentProgress progress_;
  std::vector<std::string> warnings_;
  Console console_{progress_, [this](const std::string& warning) { warnings_.push_back(warning); }};
};

TEST_F(MazeCommands, TablePrintsEveryRule) {
  const auto outcome = run_maze_table({}, console_);
  ASSERT_TRUE(outcome.ok());
  EXPECT_EQ(outcome->figures["counts"]["inputs"], 52);
  EXPECT_EQ(outcome->figures["counts"]["transition_rules"], 1560);
  EXPECT_EQ(outcome->figures["counts"]["output_rules"], 936);
  EXPECT_THAT(outcome->figures["transition_rules"], SizeIs(1560));
  EXPECT_THAT(outcome->figures["output_rules"], SizeIs(936));
  EXPECT_EQ(std::count(outcome->text.begin(), outcome->text.end(), '\n'), 4 + 1560);
}

TEST_F(MazeCommands, TableIsAlsoWrittenAsJsonAndDot) {
  const auto json = run_maze_table({GridRuleSet::kShortcut, MazeTableFormat::kJson}, console_);
  EXPECT_EQ(nlohmann::json::parse(json->text)["counts"]["inputs"], 80);
  const auto dot = run_maze_table({GridRuleSet::kPublished, MazeTableFormat::kDot}, console_);
  EXPECT_THAT(dot->text, HasSubstr("q_e -> q_r"));
}

TEST_F(MazeCommands, ExploreGivesARowForEachMazeAndTheirSums) {
  MazeExploreOptions options;
  options.files = {generated(MazeKind::kPerfect, 8, "a"), generated(MazeKind::kBraided, 8, "b")};
  options.rules = GridRuleSet::kShortcut;
  options.compare = true;
  const auto outcome = run_maze_explore(options, console_);
  ASSERT_TRUE(outcome.ok()) << to_string(outcome.problems());
  EXPECT_TRUE(outcome->ok);
  const auto& mazes = outcome->figures["mazes"];
  ASSERT_THAT(mazes, SizeIs(2));
  EXPECT_EQ(mazes[0]["file"], options.files[0]);
  EXPECT_EQ(mazes[0]["moves"], 126);
  EXPECT_EQ(mazes[0]["moves_over_lower_bound"], 1.0);
  EXPECT_LE(mazes[1]["max_edge_uses"], 2);
  const auto& total = outcome->figures["total"];
  EXPECT_EQ(total["moves"], mazes[0]["moves"].get<int>() + mazes[1]["moves"].get<int>());
  EXPECT_EQ(total["map_equals_truth"], 2);
  EXPECT_EQ(outcome->figures["compare"]["shortcut"], total["moves"]);
}

TEST_F(MazeCommands, ExploreOverwritesNoPictureUnlessForced) {
  MazeExploreOptions options;
  options.files = {generated(MazeKind::kRooms, 8, "a")};
  options.svg = directory_ / "run.svg";
  options.gif = directory_ / "run.gif";
  const auto outcome = run_maze_explore(options, console_);
  ASSERT_TRUE(outcome.ok()) << to_string(outcome.problems());
  EXPECT_TRUE(fs::exists(*options.svg) && fs::exists(*options.gif));
  EXPECT_THAT(to_string(run_maze_explore(options, console_).problems()),
              HasSubstr("exists already; --force replaces it"));
  options.force = true;
  EXPECT_TRUE(run_maze_explore(options, console_).ok());
}

TEST_F(MazeCommands, ExploreRefusesBadMazesAllAtOnce) {
  MazeExploreOptions options;
  options.files = {(directory_ / "none").string(), directory_.string(), generated(MazeKind::kHall, 4, "a")};
  options.start = Cell{4, 0};
  EXPECT_THAT(run_maze_explore(options, console_).problems(), SizeIs(3));
}

TEST_F(MazeCommands, ExploreNeedsAStartThatIsDrawnOrGiven) {
  MazeExploreOptions options;
  options.files = {(directory_ / "a").string()};
  std::ofstream(options.files[0]) << "o---o\n|   |\no---o\n";
  EXPECT_THAT(to_string(run_maze_explore(options, console_).problems()), HasSubstr("no start is drawn"));
  options.start = Cell{0, 0};
  EXPECT_TRUE(run_maze_explore(options, console_)->ok);
}

TEST_F(MazeCommands, ExploreStartsACompetitionMazeInTheCornerWithAWarning) {
  std::string maze;
  for (int line = 0; line < 33; ++line) {
    for (int cell = 0; cell < 16; ++cell) {
      if (line % 2 == 0) maze += line == 0 || line == 32 ? "o---" : "o   ";
      if (line % 2 == 1) maze += cell == 0 ? "|   " : "    ";
    }
    maze += line % 2 == 0 ? "o\n" : "|\n";
  }
  MazeExploreOptions options;
  options.files = {(directory_ / "a").string()};
  std::ofstream(options.files[0]) << maze;
  EXPECT_TRUE(run_maze_explore(options, console_)->ok);
  ASSERT_THAT(warnings_, SizeIs(1));
  EXPECT_THAT(warnings_[0], HasSubstr("no start is drawn; starting at 0,0"));
}

TEST_F(MazeCommands, WatchShowsEveryCycleWhereThereIsRoom) {
  MazeExploreOptions options;
  options.files = {generated(MazeKind::kSpiral, 4, "a")};
  std::vector<std::string> frames;
  options.watch = Terminal{80, 24, [&](const std::string& frame) { frames.push_back(frame); }};
  ASSERT_TRUE(run_maze_explore(options, console_).ok());
  EXPECT_THAT(frames, SizeIs(1 + 30 + 1));
  EXPECT_THAT(frames.back(), HasSubstr("q_fin"));
  options.watch->rows = 5;
  EXPECT_FALSE(run_maze_explore(options, console_).ok());
}

TEST_F(MazeCommands, GenerateGivesTheSameMazeForTheSameSeed) {
  const MazeGenerateOptions options{{MazeKind::kBraided, 20, 10, 0.3}, 7};
  const auto first = run_maze_generate(options, console_);
  EXPECT_EQ(first->text, run_maze_generate(options, console_)->text);
  const auto read = parse_maze(first->text, "maze");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->world.width(), 20);
  EXPECT_EQ(read->world.height(), 10);
}

TEST_F(MazeCommands, GenerateRefusesImpossibleSizes) {
  EXPECT_THAT(run_maze_generate({{MazeKind::kHall, 0, 5000, 2}}, console_).problems(), SizeIs(3));
}

}  // namespace
}  // namespace aisle
