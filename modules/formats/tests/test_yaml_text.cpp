#include <gmock/gmock.h>

#include "aisle/formats/worlds/world_yaml.hpp"
#include "yaml_text.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

TEST(YamlText, LevelsAndValuesHaveLimits) {
  EXPECT_EQ(load_yaml("a: [1, 2]")["a"].size(), 2U);
  EXPECT_THROW(load_yaml(std::string(40, '[') + std::string(40, ']')), YAML::ParserException);
  std::string many = "[0";
  for (int i = 0; i < 2'000'000; ++i) many += ",0";
  EXPECT_THROW(load_yaml(many + "]"), YAML::ParserException);
}

TEST(YamlText, FilesThatNestDeeplyAreRefusedInWords) {
  for (const char* level : {"[", "{a: ", "- ", "? "}) {
    std::string text;
    for (int i = 0; i < 1000; ++i) text += level;
    EXPECT_THAT(to_string(parse_world(text, "w.yaml").problems()), HasSubstr("w.yaml:1: is not YAML: "))
        << level;
  }
}

}  // namespace
}  // namespace aisle
