#include <fmt/format.h>
#include <gmock/gmock.h>

#include "aisle/formats/whole_file.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"
#include "worlds/world_fields.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

std::string document() {
  const Result<std::string> text = read_whole_file(AISLE_SOURCE_DIR "/docs/formats/world.md");
  return text ? *text : to_string(text.problems());
}

/// From the heading to the next one.
std::string chapter(const std::string& heading) {
  const std::string text = document();
  const std::size_t start = text.find("\n" + heading + "\n");
  if (start == std::string::npos) return {};
  return text.substr(start, text.find("\n#", start + 2) - start);
}

/// The start of the key's row in its table: key, default, range.
std::string row_of(const ObjectField& field) {
  std::string standard, range = fmt::format("{:g} .. {:g}", field.range.min, field.range.max);
  if (const auto* real = std::get_if<double*>(&field.target)) {
    standard = fmt::format("{:g}", **real / field.inner_unit);
  } else if (const auto* count = std::get_if<int*>(&field.target)) {
    standard = fmt::format("{}", **count);
  } else if (const auto* whole = std::get_if<std::uint64_t*>(&field.target)) {
    standard = fmt::format("{}", **whole);
    range = "";
  } else if (const auto* word = std::get_if<WordTarget>(&field.target)) {
    standard = word->words[word->index()];
    range = fmt::format("{}", fmt::join(word->words, ", "));
  } else if (std::holds_alternative<std::string*>(field.target)) {
    range = "";
  }
  if (field.is_needed) standard = "needed";
  const auto cell = [](const std::string& text) { return text.empty() ? " " : " " + text + " "; };
  return fmt::format("| `{}` |{}|{}|", field.key, cell(standard), cell(range));
}

template <class Object>
void expect_described(const std::string& heading) {
  const std::string text = chapter(heading);
  Object object;
  for (const ObjectField& field : fields_of(object)) EXPECT_THAT(text, HasSubstr(row_of(field))) << heading;
}

TEST(WorldDocument, DescribesEveryKeyWithItsDefaultAndRange) {
  expect_described<World>("## The world as a whole");
  expect_described<Pose2>("### `start`");
  expect_described<FloorCovering>("### `floor`");
  World world;
  for_each_list(world, [](const std::string& key, auto& objects, std::size_t) {
    expect_described<typename std::decay_t<decltype(objects)>::value_type>("### `" + key + "`");
  });
}

TEST(WorldDocument, DescribesTheKeysOfWalls) {
  const std::string text = chapter("### `walls`");
  EXPECT_THAT(text, HasSubstr("| `line` | needed | -10000 .. 10000 |"));
  EXPECT_THAT(text, HasSubstr("| `height_m` | | 0.01 .. 100 |")) << "up to the ceiling";
  EXPECT_THAT(text, HasSubstr("| `brightness` | 0.75 | 0 .. 1 |"));
}

TEST(WorldDocument, ItsExampleIsAWorld) {
  const std::string text = document(), fence = "```yaml\n";
  const std::size_t start = text.find(fence) + fence.size();
  const Result<World> world = parse_world(text.substr(start, text.find("```", start) - start), "world.md");
  ASSERT_TRUE(world.ok()) << to_string(world.problems());
  EXPECT_THAT(world->walls, SizeIs(5 + 2 + 2 + 1));
  EXPECT_EQ(world->walls.back().height_m, 1.2);
  EXPECT_EQ(world->walls.front().height_m, 2.6);
  EXPECT_THAT(world->doors, SizeIs(1));
  EXPECT_THAT(world->posters, SizeIs(2));
  EXPECT_THAT(world->furniture, SizeIs(3));
  EXPECT_THAT(world->tour, SizeIs(3));
}

}  // namespace
}  // namespace aisle
