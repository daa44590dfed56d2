#include "mission_runs.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
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
    for (const auto& [mission, record] : ran.records) squares.push_back(record["square"]);
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
  for (const auto& [mission, record] : ran->records) EXPECT_NE(record["worker"], ::getpid());
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

TEST_F(MissionRunsTest, OfWhichNoneEndedLeaveNoJournal) {
  options_.out = directory_;
  const auto refused = run(per_seed(options_, [](std::uint64_t, Console&) -> Result<Json> {
    return Problem{{"world.yaml"}, "is none"};
  }));
  ASSERT_FALSE(refused.ok());
  EXPECT_FALSE(std::filesystem::exists(journal()));
  options_.words = {"counting", "--world", "other.yaml"};
  EXPECT_TRUE(run(squares()).ok());
}

TEST_F(MissionRunsTest, RefuseAJournalThatIsNone) {
  options_.out = directory_;
  for (const char* text : {"nonsense\n", "[]\n", "{\"format\":1}\n", "{\"format\":\"aisle.world\"}\n"}) {
    std::ofstream(journal()) << text;
    const auto ran = run(squares());
    ASSERT_FALSE(ran.ok()) << text;
    EXPECT_THAT(to_string(ran.problems()), HasSubstr("missions.jsonl:1: is no journal of a trial")) << text;
    EXPECT_TRUE(std::filesystem::exists(journal())) << text;
  }
  for (const char* text : {"nonsense", "\x01\x02"}) {
    std::ofstream(journal()) << text;
    const auto ran = run(squares());
    ASSERT_FALSE(ran.ok()) << text;
    EXPECT_THAT(to_string(ran.problems()), HasSubstr("missions.jsonl: is no journal of a trial")) << text;
    EXPECT_EQ(std::filesystem::file_size(journal()), std::string(text).size()) << text;
  }
}

/// Runs the missions in a process of its own. @return its id
pid_t run_beside(const TrialOptions& options, const TrialMissions& missions) {
  const pid_t process = ::fork();
  if (process != 0) return process;
  SilentProgress progress;
  Console console{progress, [](const std::string&) {}};
  const auto ran = run_missions(options, missions, console);
  ::_exit(ran.ok() && ran->records.size() == options.seeds() ? EXIT_SUCCESS : EXIT_FAILURE);
}

std::size_t lines_in(const std::string& path) {
  std::ifstream file(path);
  return static_cast<std::size_t>(
      std::count(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>(), '\n'));
}

TEST_F(MissionRunsTest, AreSharedByProcesses) {
  options_.out = directory_ / "shared";
  options_.last_seed = 40;
  options_.jobs = 2;
  const pid_t other = run_beside(options_, squares());
  const auto ran = run(squares());
  int status = 0;
  ::waitpid(other, &status, 0);
  EXPECT_EQ(status, 0);
  ASSERT_TRUE(ran.ok()) << to_string(ran.problems());
  for (std::size_t i = 0; i < 40; ++i) EXPECT_EQ(squares_in(*ran).at(i), (i + 1) * (i + 1));
  EXPECT_EQ(lines_in(journal()), 41U) << "each mission once, behind the header";
}

TEST_F(MissionRunsTest, OfAKilledProcessAreRunByTheOthers) {
  options_.out = directory_ / "shared";
  options_.jobs = 1;
  std::array<int, 2> begun{};
  ASSERT_EQ(::pipe(begun.data()), 0);
  const pid_t other = run_beside(options_, squares(1, [&] {
                                   if (::write(begun[1], "1", 1) != 1) return;
                                   ::pause();
                                 }));
  char one = 0;
  ASSERT_EQ(::read(begun[0], &one, 1), 1);
  const auto ran = run(squares(8, [&] { ::kill(other, SIGKILL); }));
  ::waitpid(other, nullptr, 0);
  ASSERT_TRUE(ran.ok()) << to_string(ran.problems());
  EXPECT_THAT(squares_in(*ran), ElementsAre(1, 4, 9, 16, 25, 36, 49, 64));
  for (const int end : begun) ::close(end);
}

TEST_F(MissionRunsTest, OneAloneIsTheSameAsAmongAll) {
  options_.only = "seed 5";
  const auto ran = run(squares());
  ASSERT_TRUE(ran.ok());
  EXPECT_THAT(squares_in(*ran), ElementsAre(25));
  Outcome outcome;
  ran->report(options_, outcome);
  EXPECT_THAT(outcome.text, HasSubstr("aisle trial counting --seeds 1..8 --only 'seed 5'"));
  options_.only = "seed 9";
  EXPECT_THAT(to_string(run(squares()).problems()), HasSubstr("--only: is none of this trial's missions"));
}

TEST_F(MissionRunsTest, OfSeveralProcessesNeedOneDirectory) {
  options_.process = {.rank = 1, .count = 2};
  EXPECT_THAT(to_string(run(squares()).problems()), HasSubstr("--out: is missing: the 2 processes"));
  options_.out = directory_;
  options_.force = true;
  EXPECT_THAT(to_string(run(squares()).problems()), HasSubstr("--force: would let each"));
}

}  // namespace
}  // namespace aisle
