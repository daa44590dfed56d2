#include <gmock/gmock.h>

#include "aisle/core/angle.hpp"
#include "aisle/formats/parameter_file.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct Window {
  int tries = 3;
  bool careful = true;
  void describe(FieldList& fields) {
    fields.count("tries", tries, {1, 10}, "how often");
    fields.flag("careful", careful, "slower and surer");
  }
};

struct Matching {
  Window window;
  double opening_rad = 10 * kDegree;
  void describe(FieldList& fields) {
    fields.group("window", window);
    fields.angle("opening_deg", opening_rad, {0, 90}, "how wide");
  }
};

struct Params {
  double reach_m = 2;
  Matching matching;
  void describe(FieldList& fields) {
    fields.real("reach_m", reach_m, {0, 5}, "how far");
    fields.group("matching", matching);
  }
};

/// The problems of a file with this text.
std::string parameter_problems(const std::string& text) {
  Params params;
  FieldList fields = fields_of(params);
  return to_string(parse_parameters(text, "my.yaml", fields));
}

TEST(ParameterFile, NestedMapsAndDottedKeysAreTheSame) {
  Params params;
  FieldList fields = fields_of(params);
  EXPECT_THAT(parse_parameters("reach_m: 4.5\n"
                               "matching:\n"
                               "  window: {tries: 7, careful: no}\n"
                               "matching.opening_deg: 45\n",
                               "my.yaml", fields),
              IsEmpty());
  EXPECT_EQ(params.reach_m, 4.5);
  EXPECT_EQ(params.matching.window.tries, 7);
  EXPECT_FALSE(params.matching.window.careful);
  EXPECT_DOUBLE_EQ(params.matching.opening_rad, kPi / 4);
}

TEST(ParameterFile, AnEmptyFileChangesNothing) {
  EXPECT_EQ(parameter_problems(""), "");
  EXPECT_EQ(parameter_problems("# only a comment\n"), "");
}

TEST(ParameterFile, EveryProblemIsReportedAtOnce) {
  EXPECT_EQ(parameter_problems("reach_m: 9\n"
                               "matching:\n"
                               "  window:\n"
                               "    tries: many\n"
                               "    trys: 3\n"
                               "  opening_deg: [1, 2]\n"
                               "reach_m: 1\n"
                               "matching.window.careful:\n"),
            "my.yaml:1: reach_m: 9 is outside 0 .. 5\n"
            "my.yaml:4: matching.window.tries: 'many' is not a number\n"
            "my.yaml:5: matching.window.trys: unknown key (nearest known key: matching.window.tries)\n"
            "my.yaml:6: matching.opening_deg: a list is not a value\n"
            "my.yaml:7: reach_m: is set twice, first on line 1\n"
            "my.yaml:8: matching.window.careful: has no value");
}

TEST(ParameterFile, MalformedYamlIsOneProblemWithItsLine) {
  Params params;
  FieldList fields = fields_of(params);
  const Problems found = parse_parameters("reach_m: 1\nmatching: {window\n", "my.yaml", fields);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(to_string(found), AllOf(HasSubstr("my.yaml:"), HasSubstr("is not well-formed YAML")));
  EXPECT_GT(found[0].where.line, 1);
  EXPECT_EQ(parameter_problems("just a text"), "my.yaml:1: the file is not a map of keys to values");
}

TEST(ParameterFile, AliasesDoNotMakeASmallFileEndless) {
  EXPECT_THAT(parameter_problems("a: &a\n  b: *a\n"), HasSubstr("nested too deeply"));
}

TEST(ParameterFile, AMissingFileIsAProblem) {
  Params params;
  FieldList fields = fields_of(params);
  EXPECT_THAT(to_string(read_parameters("/nowhere/my.yaml", fields)),
              HasSubstr("/nowhere/my.yaml: no such file"));
}

TEST(ParameterFile, IsWrittenWithMeaningsAndRanges) {
  Params params;
  EXPECT_EQ(parameters_yaml(fields_of(params)),
            "# how far (0 .. 5)\n"
            "reach_m: 2\n"
            "matching:\n"
            "  window:\n"
            "    # how often (1 .. 10)\n"
            "    tries: 3\n"
            "    # slower and surer (true or false)\n"
            "    careful: true\n"
            "  # how wide (0 .. 90)\n"
            "  opening_deg: 10\n");
}

TEST(ParameterFile, ReadingWhatWasWrittenAssignsTheSameValues) {
  Params written;
  written.reach_m = 1.25;
  written.matching.opening_rad = 33 * kDegree;
  written.matching.window = {9, false};
  Params read;
  FieldList fields = fields_of(read);
  EXPECT_THAT(parse_parameters(parameters_yaml(fields_of(written)), "written", fields), IsEmpty());
  EXPECT_EQ(read.reach_m, written.reach_m);
  EXPECT_DOUBLE_EQ(read.matching.opening_rad, written.matching.opening_rad);
  EXPECT_EQ(read.matching.window.tries, 9);
  EXPECT_FALSE(read.matching.window.careful);
}

}  // namespace
}  // namespace aisle
