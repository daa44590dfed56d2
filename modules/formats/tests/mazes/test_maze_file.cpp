#include "aisle/formats/mazes/maze_file.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "aisle/exploration/maze_generator.hpp"
#include "aisle/formats/images/portable_bitmap.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// Three cells in an L: from (0, 1) down to (0, 0) and right to (1, 0); (1, 1) is cut off.
const std::string kSmall =
    "o---o---o\n"
    "| S |   |\n"
    "o   o---o\n"
    "|     G |\n"
    "o---o---o\n";

std::string complaint(std::string_view bytes) {
  const auto maze = parse_maze(bytes, "maze");
  return maze.ok() ? "accepted" : to_string(maze.problems());
}

std::string with(std::size_t line, std::size_t column, std::string_view text) {
  std::string changed = kSmall;
  changed.replace((line - 1) * 10 + column - 1, text.size(), text);
  return changed;
}

MATCHER_P(IsWorld, expected, "") {
  if (arg.width() != expected.width() || arg.height() != expected.height()) return false;
  for (std::size_t cell = 0; cell < expected.size(); ++cell) {
    if (arg.open(cell) != expected.open(cell)) return false;
  }
  return arg.start == expected.start && arg.goals == expected.goals;
}

TEST(MazeText, ReadsWallsStartAndGoal) {
  const auto maze = parse_maze(kSmall, "maze");
  ASSERT_TRUE(maze.ok()) << to_string(maze.problems());
  const GridWorld& world = maze->world;
  EXPECT_EQ(maze->format, MazeFormat::kText);
  EXPECT_TRUE(maze->has_start);
  EXPECT_EQ(world.start, (Cell{0, 1}));
  EXPECT_THAT(world.goals, ElementsAre(Cell{1, 0}));
  EXPECT_EQ(world.open({0, 1}), bit(Side::kBottom));
  EXPECT_EQ(world.open({0, 0}), bit(Side::kTop) | bit(Side::kRight));
  EXPECT_EQ(world.open({1, 0}), bit(Side::kLeft));
  EXPECT_EQ(world.open({1, 1}), kNoSides);
}

TEST(MazeText, ReadsOtherLineEndsAndBlankLastLines) {
  std::string windows;
  for (const char c : kSmall) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_THAT(parse_maze(windows + "\r\n\r\n", "maze")->world, IsWorld(parse_maze(kSmall, "maze")->world));
  EXPECT_THAT(parse_maze(kSmall.substr(0, kSmall.size() - 1), "maze")->world,
              IsWorld(parse_maze(kSmall, "maze")->world));
}

TEST(MazeText, WithoutAStartBeginsAtTheBottomLeft) {
  const auto maze = parse_maze(with(2, 3, " "), "maze");
  ASSERT_TRUE(maze.ok());
  EXPECT_FALSE(maze->has_start);
  EXPECT_EQ(maze->world.start, (Cell{0, 0}));
}

TEST(MazeText, SaysWhereItIsWrong) {
  EXPECT_EQ(complaint(with(1, 2, "   ")), "maze:1: column 2: the outer wall is missing here");
  EXPECT_EQ(complaint(with(4, 1, " ")), "maze:4: column 1: the outer wall is missing here");
  EXPECT_EQ(complaint(with(3, 6, "-  ")),
            "maze:3: column 6: half a wall; '---' is a wall, three blanks are a gap");
  EXPECT_EQ(complaint(with(2, 7, "x")), "maze:2: column 7: 'x' where S, G or a blank should be");
  EXPECT_EQ(complaint(with(3, 2, "?")), "maze:3: column 2: '?' where a wall or a gap should be");
  EXPECT_EQ(complaint(with(4, 7, "S")), "maze:4: column 7: a second start");
  EXPECT_EQ(complaint(kSmall.substr(0, 25)), "maze:3: column 6: the line has 5 characters, the first one 9");
  EXPECT_EQ(complaint(kSmall.substr(0, 40)),
            "maze:4: column 1: the maze ends after 4 lines; H rows of cells take 2 H + 1");
  EXPECT_EQ(complaint("o--\n| |\no--\n"),
            "maze:1: column 4: the first line has 3 characters; W cells take 4 W + 1");
}

TEST(MazeText, NamesEveryProblemAtOnce) {
  EXPECT_THAT(parse_maze(with(1, 2, "   ").replace(37, 1, "x"), "maze").problems(), SizeIs(2));
}

RC_GTEST_PROP(MazeText, GivesBackWhatWasWritten, ()) {
  const auto kind = *rc::gen::elementOf(std::vector<MazeKind>(std::begin(kMazeKinds), std::end(kMazeKinds)));
  GridWorld world = generate_maze({kind, *rc::gen::inRange(1, 30), *rc::gen::inRange(1, 30)},
                                  Random(*rc::gen::arbitrary<std::uint64_t>()));
  world.goals.clear();
  const auto read = parse_maze(maze_text(world), "maze");
  RC_ASSERT(read.ok());
  RC_ASSERT(testing::Value(read->world, IsWorld(world)));
}

TEST(MazeNumber, ReadsTheSameMaze) {
  const auto maze = parse_maze("0 0 0 0 1 1\n0 1 1 1 0 1\n1 0 1 1 1 0\n1 1 1 1 1 1\n", "maze");
  ASSERT_TRUE(maze.ok()) << to_string(maze.problems());
  EXPECT_EQ(maze->format, MazeFormat::kNumber);
  GridWorld expected = parse_maze(kSmall, "maze")->world;
  expected.start = {0, 0};
  expected.goals.clear();
  EXPECT_THAT(maze->world, IsWorld(expected));
}

TEST(MazeNumber, SaysWhereItIsWrong) {
  EXPECT_EQ(complaint("0 0 1 0 1 1\n1 0 1 1 1 1\n"),
            "maze:2: cell (1, 0) has a wall in the west that cell (0, 0) has not");
  EXPECT_EQ(complaint("0 0 1 1 0 1\n"), "maze:1: cell (0, 0): the outer wall in the south is missing");
  EXPECT_EQ(complaint("0 0 1 7 1 1\n"), "maze:1: column 7: '7' is not a whole number from 0 to 1");
  EXPECT_EQ(complaint("0 0 1 1 1\n"),
            "maze:1: column 10: the line ends before its six numbers x y north east south west");
  EXPECT_EQ(complaint("0 0 1 1 1 1 1\n"),
            "maze:1: column 13: more than the six numbers x y north east south west");
  EXPECT_EQ(complaint("0 0 1 1 1 1\n0 0 1 1 1 1\n"), "maze:2: cell (0, 0) a second time");
  EXPECT_EQ(complaint("1 0 1 1 1 1\n"), "maze: cell (0, 0) of 2 x 1 is missing");
  EXPECT_EQ(complaint("31622 31622 1 1 1 1\n"),
            "maze:1: column 1: '31622' is not a whole number from 0 to 4095");
}

TEST(MazeBinary, ReadsTheSameMaze) {
  const auto maze = parse_maze(std::string("\x0c\x0b\x07\x0f", 4), "maze");
  ASSERT_TRUE(maze.ok()) << to_string(maze.problems());
  EXPECT_EQ(maze->format, MazeFormat::kBinary);
  EXPECT_EQ(maze->world.open({0, 0}), bit(Side::kTop) | bit(Side::kRight));
  EXPECT_EQ(maze->world.open({1, 0}), bit(Side::kLeft));
}

TEST(MazeBinary, SaysWhereItIsWrong) {
  EXPECT_EQ(complaint(std::string("\x0c\x0b\x07", 3)),
            "maze: is binary and 3 bytes long; a binary maze has N x N bytes, N up to 4096");
  EXPECT_THAT(complaint(std::string("\x0c\x0b\x0f\x0f", 4)),
              HasSubstr("byte 3: cell (1, 0) has a wall in the west"));
  EXPECT_THAT(complaint(std::string(256, '\0')),
              HasSubstr("byte 1: cell (0, 0): the outer wall in the west is missing"));
}

TEST(MazeBitmap, TakesWhitePixelsAsCells) {
  const auto maze = parse_maze("P1\n# a corner\n3 2\n0 1 1\n0 0 1\n", "maze");
  ASSERT_TRUE(maze.ok()) << to_string(maze.problems());
  EXPECT_EQ(maze->world.open({0, 0}), bit(Side::kTop) | bit(Side::kRight));
  EXPECT_EQ(maze->world.open({2, 0}), kNoSides);
  EXPECT_EQ(maze->world.start, (Cell{0, 0}));
}

TEST(MazeBitmap, StartsAtTheLowestFreePixel) {
  EXPECT_EQ(parse_maze(std::string("P4\n3 2\n\x60\xa0", 9), "maze")->world.start, (Cell{1, 0}));
}

TEST(MazeBitmap, SaysWhereItIsWrong) {
  EXPECT_EQ(complaint("P1\n1 1\n1\n"), "maze: has no white pixel: there is no cell to be in");
  EXPECT_EQ(complaint("P4\n99999 99999\n"), "maze:2: width: '99999' is not a whole number from 1 to 4096");
  EXPECT_EQ(complaint("P4\n0 0\n"), "maze:2: width: '0' is not a whole number from 1 to 4096");
  EXPECT_EQ(complaint("P4\n16 16\n12"), "maze:2: ends after 2 of 32 bytes of pixels");
  EXPECT_EQ(complaint("P1\n2 1\n0 x\n"), "maze:3: 'x' is not a pixel; pixels are 0 and 1");
}

TEST(MazeFile, RefusesWhatIsNoFile) {
  EXPECT_FALSE(read_maze("/no/such/maze").ok());
  EXPECT_FALSE(read_maze("/tmp").ok());
  EXPECT_EQ(complaint(""), "maze: is empty");
  EXPECT_EQ(complaint("\n\n"), "maze: has blank lines only");
}

}  // namespace
}  // namespace aisle
