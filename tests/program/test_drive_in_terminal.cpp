#include <gmock/gmock.h>

#include <functional>
#include <memory>
#include <regex>

#include "aisle_in_terminal.hpp"
#include "workplace.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kUp = "\x1b[A";
constexpr const char* kLeft = "\x1b[D";
constexpr const char* kCtrlC = "\x03";

/// A person at the terminal's keys who watches the status line.
class DriveInTerminal : public Workplace {
 protected:
  void SetUp() override {
    person_at_ = std::make_unique<AisleInTerminal>(
        Arguments{"drive", "mini-corridor", "--vehicle", "mini", "--no-images", "--out", at("drive")});
    before_ = person_at_->settings();
    until([](double) { return true; });
  }

  /// Presses `keys` repeatedly until the status line shows a speed that `is_enough`.
  void until(const std::function<bool(double speed_mps)>& is_enough, std::string_view keys = "") {
    static const std::regex status(R"((\d+\.\d) s +(-?\d+\.\d\d) m/s)");
    while (true) {
      const std::string words = person_at_->next_words();
      ASSERT_FALSE(words.empty()) << "the drive has ended by itself";
      screen_ += words;
      std::smatch match;
      if (std::regex_search(words, match, status) && is_enough(std::stod(match[2]))) return;
      if (!keys.empty()) person_at_->type(keys);
    }
  }

  /// Waits for the program's end, including its last output.
  int wait() {
    for (std::string words; !(words = person_at_->next_words()).empty();) screen_ += words;
    return person_at_->wait();
  }

  void expect_restored_terminal() const {
    const termios after = person_at_->settings();
    EXPECT_EQ(after.c_lflag, before_.c_lflag);
    EXPECT_EQ(after.c_iflag, before_.c_iflag);
    EXPECT_EQ(after.c_oflag, before_.c_oflag);
    EXPECT_EQ(after.c_cc[VMIN], before_.c_cc[VMIN]);
    EXPECT_EQ(after.c_cc[VTIME], before_.c_cc[VTIME]);
  }

  void type(std::string_view keys) { person_at_->type(keys); }

  bool shows_what_is_typed() const { return (person_at_->settings().c_lflag & ECHO) != 0; }

  const std::string& screen() const { return screen_; }

 private:
  std::unique_ptr<AisleInTerminal> person_at_;
  termios before_{};
  std::string screen_;
};

bool moves(double speed_mps) {
  return speed_mps > 0.05;
}
bool stands(double speed_mps) {
  return speed_mps == 0;
}

TEST_F(DriveInTerminal, ArrowsDriveAndSpaceEnds) {
  EXPECT_FALSE(shows_what_is_typed());
  until(moves, kUp);
  until(moves, kLeft);
  type(" ");
  EXPECT_EQ(wait(), 0);
  EXPECT_THAT(screen(), AllOf(HasSubstr("arrows drive"), HasSubstr("simulated drive through")));
  expect_restored_terminal();
  const ProgramRun replay = run_aisle({"replay", at("drive"), "--json"});
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
}

TEST_F(DriveInTerminal, StopsWhenTheKeysStop) {
  until(moves, kUp);
  until(stands);
  type(" ");
  EXPECT_EQ(wait(), 0);
}

TEST_F(DriveInTerminal, QStopsAtOnceAndMarksAreShown) {
  until(moves, kUp);
  until(stands, "q");
  type("plobby\r");
  until([&](double) { return screen().find("mark at") != std::string::npos; });
  type(" ");
  EXPECT_EQ(wait(), 0);
  EXPECT_THAT(screen(), HasSubstr("lobby"));
}

TEST_F(DriveInTerminal, AnInterruptLeavesTheTerminalAsItWasAndTheSession) {
  until(moves, kUp);
  type(kCtrlC);
  EXPECT_EQ(wait(), 130);
  expect_restored_terminal();
  const ProgramRun info = run_aisle({"info", at("drive"), "--json"});
  ASSERT_EQ(info.exit_code, 0) << info.err;
  EXPECT_GT(info.json()["figures"]["messages"], 10);
}

}  // namespace
}  // namespace aisle
