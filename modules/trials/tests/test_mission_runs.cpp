#include "mission_runs.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class MissionRunsTest : public testing::Test {
 protected:
  MissionRunsTest() {
    std::string pattern = (std::filesystem::temp_directory_path() / "aisle-runs-XXXXXX").string();
    directory_ = ::mkdtemp(pattern.data());
    options_.method = "counting";
    options_.words = {"counting"};
    options_.last_seed = 8;
    options_.jobs = 3;
  }
  ~MissionRunsTest() override { std::filesystem::remove_all(directory_); }

  /// Squares its seed, unless something else is to happen to that one.
  TrialMissions squares(std::uint64_t special = 0, const std::function<void()>& happens = {}) const {
    return per_seed(options_, [=](std::uint64_t seed, Console& console) -> Result<Json> {
      if (seed == special) happens();
      if (seed == 3) console.warn("three");
      return Json{{"ok", seed != 5}, {"square", seed * seed}, {"worker", ::getpid()}};
    });
  }

  Result<TrialRecords> run(const TrialMissions& missions) {
    Console console{progress_, [&](const std::string& warning) { warnings_.push_back(warning); }};
    return run_missions(options_, missions, console);
  }

  static std::vector<int> squares_in(const TrialRecords& ran) {
    std::vector<int> squares;
    for (const Json& record : ran.records) squares.push_back(record["square"]);
    return squares;
  }

  std::string journal() const { return options_.out / "missions.jsonl"; }

  std::filesystem::path directory_;
  TrialOptions options_;
  SilentProgress progress_;
  std::vector<std::string> warnings_;
};

TEST_F(MissionRunsTest, RunInOtherProcessesAndComeBackInOrder) {
  const auto ran = run(squares());
  ASSERT_TRUE(ran.ok());
  EXPECT_THAT(squares_in(*ran), ElementsAre(1, 4, 9, 16, 25, 36, 49, 64));
  for (const Json& record : ran->records) EXPECT_NE(record["worker"], ::getpid());
  EXPECT_THAT(warnings_, ElementsAre("three"));
  EXPECT_THAT(ran->failed, ElementsAre("seed 5"));
  EXPECT_THAT(ran->died, IsEmpty());
}

TEST_F(MissionRunsTest, OneThatDiesCostsItselfAlone) {
  const std::vector<std::pair<std::function<void()>, std::string>> deaths = {
      {[] { ::kill(::getpid(), SIGKILL); }, "signal 9"},
      {[] { ::_exit(7); }, "exit code 7"},
      {[] { throw std::runtime_error("a bug"); }, "internal error: a bug"}};
  for (const auto& [dies, cause] : deaths) {
    const auto ran = run(squares(4, dies));
    ASSERT_TRUE(ran.ok());
    EXPECT_THAT(squares_in(*ran), ElementsAre(1, 4, 9, 25, 36, 49, 64)) << cause;
    EXPECT_THAT(ran->died, ElementsAre(HasSubstr("seed 4: " + cause)));
    Outcome outcome;
    ran->report(options_, outcome);
    EXPECT_FALSE(outcome.ok);
    EXPECT_EQ(outcome.figures["died"].size(), 1U);
  }
}

TEST_F(MissionRunsTest, ProblemsOfOneEndTheTrial) {
  const auto ran = run(per_seed(options_, [](std::uint64_t seed, Console&) -> Result<Json> {
    if (seed == 2) return Problem{{"world.yaml", 3, "walls"}, "are none"};
    return Json{{"ok", true}};
  }));
  ASSERT_FALSE(ran.ok());
  EXPECT_EQ(to_string(ran.problems()), "world.yaml:3: walls: are none");
}

TEST_F(MissionRunsTest, GoOnWhereTheyWereInterrupted) {
  options_.out = directory_ / "kept";
  const auto first = run(squares(4, [] { ::kill(::getpid(), SIGKILL); }));
  ASSERT_TRUE(first.ok());
  EXPECT_EQ(first->records.size(), 7U);
  std::ofstream(journal(), std::ios::app) << R"({"mission":"seed 4","rec)";
  const auto only_fourth = [&](std::uint64_t seed, Console&) -> Result<Json> {
    if (seed != 4) throw std::logic_error("was run before");
    return Json{{"ok", true}, {"square", 16}};
  };
  const auto second = run(per_seed(options_, only_fourth));
  ASSERT_TRUE(second.ok()) << to_string(second.problems());
  EXPECT_THAT(squares_in(*second), ElementsAre(1, 4, 9, 16, 25, 36, 49, 64));
  EXPECT_THAT(second->died, IsEmpty());
  EXPECT_THAT(warnings_.back(), HasSubstr("7 missions were run before"));
}

TEST_F(MissionRunsTest, KeepNoOtherTrialsMissions) {
  options_.out = directory_;
  ASSERT_TRUE(run(squares()).ok());
  options_.words = {"counting", "--speed", "1"};
  const auto other = run(squares());
  ASSERT_FALSE(other.ok());
  EXPECT_THAT(to_string(other.problems()),
              HasSubstr("missions.jsonl:1: holds the missions of \"aisle trial counting\""));
  options_.force = true;
  EXPECT_TRUE(run(squares()).ok());
}

TEST_F(MissionRunsTest, RefuseAJournalThatIsNone) {
  options_.out = directory_;
  for (const char* text : {"nonsense\n", "[]\n", "{\"format\":1}\n", "{\"format\":\"aisle.world\"}\n"}) {
    std::ofstream(journal()) << text;
    const auto ran = run(squares());
    ASSERT_FALSE(ran.ok()) << text;
    EXPECT_THAT(to_string(ran.problems()), HasSubstr("missions.jsonl:1: is no journal of a trial")) << text;
  }
}

}  // namespace
}  // namespace aisle
