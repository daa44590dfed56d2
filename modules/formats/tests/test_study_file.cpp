#include "aisle/formats/study_file.hpp"

#include <gmock/gmock.h>

namespace aisle {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;

constexpr const char* kHead =
    "format: aisle.study\nversion: 1\ntrial: landmarks --world l-corridor\nseeds: 1..20\n";

auto is_variant(const std::string& name, const std::string& words) {
  return AllOf(Field(&StudyVariant::name, name), Field(&StudyVariant::words, words));
}

std::string study_problems(const std::string& body) {
  const auto study = parse_study(kHead + body, "study.yaml");
  return study ? "" : to_string(study.problems());
}

TEST(StudyFile, NamesVariants) {
  const auto study = parse_study(std::string(kHead) +
                                     "figures: [lateral_m]\n"
                                     "variants:\n  - {name: as shipped}\n"
                                     "  - {name: slow, options: --speed 0.3}\n",
                                 "study.yaml");
  ASSERT_TRUE(study.ok()) << to_string(study.problems());
  EXPECT_EQ(study->trial, "landmarks --world l-corridor");
  EXPECT_EQ(study->seeds, "1..20");
  EXPECT_THAT(study->figures, ElementsAre("lateral_m"));
  EXPECT_THAT(study->variants, ElementsAre(is_variant("as shipped", ""), is_variant("slow", "--speed 0.3")));
  EXPECT_EQ(directory_of(study->variants[0]), "variant-as-shipped");
}

TEST(StudyFile, SweepsOverAllCombinations) {
  const auto study = parse_study(std::string(kHead) +
                                     "sweep:\n  - {option: --speed, values: [0.3, 0.6]}\n"
                                     "  - {parameter: learner.window_m, values: [1, 2]}\n",
                                 "study.yaml");
  ASSERT_TRUE(study.ok()) << to_string(study.problems());
  EXPECT_THAT(
      study->variants,
      ElementsAre(is_variant("speed=0.3, learner.window_m=1", "--speed 0.3 --set learner.window_m=1"),
                  is_variant("speed=0.3, learner.window_m=2", "--speed 0.3 --set learner.window_m=2"),
                  is_variant("speed=0.6, learner.window_m=1", "--speed 0.6 --set learner.window_m=1"),
                  is_variant("speed=0.6, learner.window_m=2", "--speed 0.6 --set learner.window_m=2")));
}

TEST(StudyFile, SaysWhatIsWrong) {
  EXPECT_THAT(study_problems("variants:\n  - {name: alone}\n"), HasSubstr("at least two variants"));
  EXPECT_THAT(study_problems("variants:\n  - {name: A b}\n  - {name: a-b}\n"),
              HasSubstr("two variants that are called"));
  EXPECT_THAT(study_problems("variants: []\nsweep:\n  - {option: --speed, values: [1, 2]}\n"),
              HasSubstr("not both"));
  EXPECT_THAT(study_problems("sweep:\n  - {option: --speed, parameter: a, values: [1, 2]}\n"),
              HasSubstr("study.yaml:6: sweep[0]: needs an option"));
  EXPECT_THAT(study_problems("sweep:\n  - {option: speed, values: [1, 2]}\n"),
              HasSubstr("does not begin with --"));
  EXPECT_THAT(study_problems("sweep:\n  - {option: --speed, values: []}\n"), HasSubstr("has no values"));
  std::string values;
  for (int i = 0; i < 15; ++i) values += std::to_string(i) + ",";
  EXPECT_THAT(study_problems("sweep:\n  - {option: --a, values: [" + values +
                             "]}\n  - {option: --b, values: [" + values + "]}\n"),
              HasSubstr("sweep[1]"));
  EXPECT_THAT(to_string(parse_study("[1, 2]", "study.yaml").problems()), HasSubstr("is not a study"));
  EXPECT_THAT(to_string(parse_study("a: [", "study.yaml").problems()), HasSubstr("is not YAML"));
}

}  // namespace
}  // namespace aisle
