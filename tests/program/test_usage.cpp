#include <gmock/gmock.h>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class Usage : public Workplace {};

TEST_F(Usage, HelpNamesTheVerbs) {
  const ProgramRun help = run_aisle({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, HasSubstr("map"));
  EXPECT_THAT(help.out, HasSubstr("sim"));
  EXPECT_THAT(help.err, IsEmpty());
}

TEST_F(Usage, HelpOfAVerbNamesItsOptions) {
  const ProgramRun help = run_aisle({"map", "--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* option : {"--relations", "--rules", "--out", "--force", "--units", "--laser-offset",
                             "--odometry-delay", "--params", "--set"}) {
    EXPECT_THAT(help.out, HasSubstr(option));
  }
}

TEST_F(Usage, VersionSaysReleaseCommitBuildTypeAndInstructionSet) {
  const ProgramRun version = run_aisle({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  std::string release = read_bytes(AISLE_SOURCE_DIR "/VERSION");
  release.pop_back();  // its line end
  EXPECT_THAT(version.out, StartsWith(release + " (commit "));
  EXPECT_THAT(version.out, ContainsRegex("commit ([0-9a-f]{10}|unknown), [A-Za-z]+, [-a-z0-9_]+\\)\n$"));
}

TEST_F(Usage, MistakesAreRefusedInOneLine) {
  EXPECT_THAT(run_aisle({"--json"}), IsRefused("A subcommand is required"));
  EXPECT_THAT(run_aisle({"juggle", "--json"}), IsRefused("juggle"));
  EXPECT_THAT(run_aisle({"map", "--json"}), IsRefused("LOG is required"));
  EXPECT_THAT(run_aisle({"map", "simulated-trip.log", "--juggle", "--json"}), IsRefused("--juggle"));
  EXPECT_THAT(run_aisle({"map", "one.log", "two.log", "--json"}), IsRefused("two.log"));
  EXPECT_THAT(run_aisle({"map", "simulated-trip.log", "--json", "--out"}), IsRefused("--out"));
  EXPECT_THAT(run_aisle({"sim", "log", "world.yaml", "--json"}), IsRefused("--out is required"));
}

TEST_F(Usage, MisspeltWordsGetASuggestion) {
  EXPECT_THAT(run_aisle({"exlore", "--json"}), IsRefused("'exlore'; did you mean explore?"));
  EXPECT_THAT(run_aisle({"map", "a.log", "--relation", "r", "--json"}),
              IsRefused("did you mean --relations?"));
  EXPECT_THAT(run_aisle({"trial", "foo", "--json"}),
              IsRefused("METHOD: 'foo' is none of landmarks, sections"));
  EXPECT_THAT(run_aisle({"sim", "lo", "--json"}),
              IsRefused("unknown verb or option 'lo'; did you mean log?"));
  EXPECT_THAT(run_aisle({"explore", "crossings", "--vehicel", "alv", "--json"}),
              IsRefused("did you mean --vehicle?"));
  EXPECT_THAT(run_aisle({"docter", "--json"}), IsRefused("did you mean doctor?"));
}

TEST_F(Usage, HelpIsAlsoAWord) {
  EXPECT_EQ(run_aisle({"help"}).out, run_aisle({"--help"}).out);
  EXPECT_EQ(run_aisle({"help", "map"}).out, run_aisle({"map", "--help"}).out);
}

TEST_F(Usage, AWordThatIsNoChoiceIsRefusedWithTheChoices) {
  EXPECT_THAT(run_aisle({"map", "simulated-trip.log", "--units", "furlong", "--json"}),
              IsRefused("--units: 'furlong' is none of m, cm"));
  EXPECT_THAT(run_aisle({"map", "simulated-trip.log", "--rules", "foo", "--json"}),
              IsRefused("--rules: 'foo' is none of published, refined"));
}

TEST_F(Usage, HelpShowsTheChoices) {
  const std::string help = run_aisle({"map", "--help"}).out;
  EXPECT_THAT(help, HasSubstr("--units m|cm|mm "));
  EXPECT_THAT(help, HasSubstr("--rules published|refined"));
}

TEST_F(Usage, ATrialRefusesOptionsThatItsMethodDoesNotUse) {
  const auto trial = [](Arguments arguments) {
    arguments.insert(arguments.begin(), "trial");
    arguments.emplace_back("--json");
    return run_aisle(arguments);
  };
  EXPECT_THAT(trial({"park", "--start-anywhere"}),
              IsRefused("--start-anywhere: is not used by park, only by explore"));
  EXPECT_THAT(trial({"explore", "--reverse"}),
              IsRefused("--reverse: is not used by explore, only by landmarks, park"));
  EXPECT_THAT(trial({"turnings", "--world", "laboratory"}), IsRefused("--world: is not used by turnings"));
  EXPECT_THAT(trial({"localise", "--speed", "0.3"}), IsRefused("--speed: is not used by localise"));
  EXPECT_THAT(trial({"route", "--kind", "office"}), IsRefused("--kind: is not used by rooms"));
}

TEST_F(Usage, AStudyRefusesAVariantWithAnOptionThatItsMethodDoesNotUse) {
  const std::string study = file("study.yaml",
                                 "format: aisle.study\nversion: 1\ntrial: explore\nseeds: 1..2\n"
                                 "variants: [{name: plain}, {name: kidnapped, options: --lift 5}]\n");
  EXPECT_THAT(run_aisle({"study", study, "--out", at("out"), "--json"}),
              IsRefused("kidnapped: --lift: is not used by explore, only by landmarks"));
}

/// No mission has that name, so none is run.
TEST_F(Usage, ATrialTakesTheOptionsThatItsMethodUses) {
  const std::vector<Arguments> trials = {
      {"landmarks", "--world", "l-corridor", "--resolution", "0.1", "--kind", "office", "--speed", "1",
       "--refinements", "2", "--lift", "5", "--reverse"},
      {"sections", "--world", "l-corridor", "--resolution", "0.1", "--kind", "ring", "--speed", "0.3",
       "--teachings", "2"},
      {"rooms", "--world", "laboratory", "--speed", "0.3"},
      {"turnings", "--close", "--speed", "0.3"},
      {"park", "--world", "laboratory", "--strategy", "frame", "--speed", "0.3", "--reverse"},
      {"explore", "--world", "l-corridor", "--resolution", "0.1", "--kind", "comb", "--sensor", "markers",
       "--noise-scale", "2", "--start-anywhere"},
      {"localise", "--world", "l-corridor", "--resolution", "0.1", "--kind", "comb", "--outdated-map"}};
  for (Arguments trial : trials) {
    trial.insert(trial.begin(), "trial");
    trial.insert(trial.end(), {"--only", "none", "--json"});
    EXPECT_THAT(run_aisle(trial), IsRefused("--only: is none of this trial's missions")) << trial[1];
  }
}

TEST_F(Usage, HelpOfATrialSaysWhichMethodsUseAnOption) {
  const std::string help = run_aisle({"trial", "--help"}).out;
  EXPECT_THAT(help, HasSubstr("explore: factor on the odometry's errors"));
  EXPECT_THAT(help, HasSubstr("landmarks, park: drive the routes"));
}

TEST_F(Usage, ASeedIsAWholeNumberThatIsNotNegative) {
  for (const char* seed : {"-1", "1.5", "red", "99999999999999999999", ""}) {
    EXPECT_THAT(run_aisle({"sim", "log", "world.yaml", "--out", at("out"), "--json", "--seed", seed}),
                IsRefused(std::string("--seed: '") + seed + "' is not a whole number from 0"));
  }
}

TEST_F(Usage, MistakesWithoutJsonPrintNothingOnStdout) {
  const ProgramRun run = run_aisle({"map", "--juggle"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_THAT(run.err, HasSubstr("--juggle"));
}

TEST_F(Usage, AFailedVerbIsNamedInFull) {
  EXPECT_EQ(run_aisle({"sim", "log", at("none.yaml"), "--out", at("out"), "--json"}).json()["verb"],
            "sim log");
  EXPECT_EQ(run_aisle({"map", at("none.log"), "--json"}).json()["verb"], "map");
}

}  // namespace
}  // namespace aisle
