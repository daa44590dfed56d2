#include "trial_journal.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Key;
using testing::Pair;

/// The locks belong to the open file: two journals in one process are as strange to each other as in two.
class TrialJournalTest : public testing::Test {
 protected:
  TrialJournalTest() {
    std::string pattern = (std::filesystem::temp_directory_path() / "aisle-journal-XXXXXX").string();
    directory_ = ::mkdtemp(pattern.data());
    options_.out = directory_;
    options_.words = {"counting"};
  }
  ~TrialJournalTest() override { std::filesystem::remove_all(directory_); }

  TrialJournal open() const {
    auto journal = TrialJournal::open(options_);
    if (!journal) throw std::runtime_error(to_string(journal.problems()));
    return std::move(journal).value();
  }
  std::string file() const { return directory_ / "missions.jsonl"; }

  std::filesystem::path directory_;
  TrialOptions options_;
};

TEST_F(TrialJournalTest, GivesEachMissionToOneProcess) {
  TrialJournal one = open(), other = open();
  EXPECT_EQ(one.claim("seed 1").value(), MissionClaim::kGranted);
  EXPECT_EQ(other.claim("seed 1").value(), MissionClaim::kRefused);
  EXPECT_EQ(other.claim("seed 2").value(), MissionClaim::kGranted);
  ASSERT_TRUE(one.add("seed 1", {{"ok", true}}).empty());
  EXPECT_EQ(other.claim("seed 1").value(), MissionClaim::kEnded);
  EXPECT_EQ(one.claim("seed 2").value(), MissionClaim::kRefused);
  EXPECT_THAT(other.records(), ElementsAre(Key("seed 1")));
}

TEST_F(TrialJournalTest, TakesBackWhatADeadProcessClaimed) {
  TrialJournal other = open();
  {
    TrialJournal one = open();
    ASSERT_EQ(one.claim("seed 1").value(), MissionClaim::kGranted);
    ASSERT_EQ(other.claim("seed 1").value(), MissionClaim::kRefused);
  }
  EXPECT_EQ(other.claim("seed 1").value(), MissionClaim::kGranted);
}

TEST_F(TrialJournalTest, ADeathIsKnownToAllAndTriedAgainLater) {
  TrialJournal one = open(), other = open();
  ASSERT_EQ(one.claim("seed 1").value(), MissionClaim::kGranted);
  ASSERT_TRUE(one.add_death("seed 1", "signal 9").empty());
  EXPECT_EQ(other.claim("seed 1").value(), MissionClaim::kEnded);
  EXPECT_THAT(other.deaths(), ElementsAre(Pair("seed 1", "signal 9")));
  TrialJournal later = open();
  EXPECT_EQ(later.kept(), 0U);
  EXPECT_EQ(later.claim("seed 1").value(), MissionClaim::kGranted);
}

TEST_F(TrialJournalTest, CutsOffWhatAKilledWriterLeft) {
  TrialJournal one = open(), other = open();
  ASSERT_TRUE(one.add("seed 1", {{"ok", true}}).empty());
  std::ofstream(file(), std::ios::app) << R"({"mission":"seed 2","rec)";
  ASSERT_TRUE(other.add("seed 3", {{"ok", true}}).empty());
  EXPECT_THAT(open().records(), ElementsAre(Key("seed 1"), Key("seed 3")));
}

TEST_F(TrialJournalTest, ForceTakesNothingFromOthers) {
  TrialJournal one = open();
  ASSERT_TRUE(one.add("seed 1", {{"ok", true}}).empty());
  options_.force = true;
  const auto forced = TrialJournal::open(options_);
  ASSERT_FALSE(forced.ok());
  EXPECT_THAT(to_string(forced.problems()), HasSubstr("is being written by another trial"));
  EXPECT_EQ(one.claim("seed 1").value(), MissionClaim::kEnded);
}

TEST_F(TrialJournalTest, IsRemovedByTheLastThatWroteNothing) {
  {
    const TrialJournal one = open();
    { const TrialJournal other = open(); }
    EXPECT_TRUE(std::filesystem::exists(file()));
  }
  EXPECT_FALSE(std::filesystem::exists(file()));
}

}  // namespace
}  // namespace aisle
