#include <gtest/gtest.h>

#include "aisle/trials/trial.hpp"

namespace aisle {
namespace {

/// Is asked to stop at its tenth report.
class Impatient final : public Progress {
 public:
  void report(std::string_view task, std::size_t done, std::size_t total) override {
    EXPECT_EQ(task, "missions");
    EXPECT_EQ(done, 0);
    EXPECT_EQ(total, 3);
    if (++reports_ == 3) throw Interrupted();
  }

 private:
  int reports_ = 0;
};

TEST(Trial, IsInterruptedInTheMiddleOfAMission) {
  for (const char* method : {"explore", "landmarks", "sections", "rooms"}) {
    TrialOptions options;
    options.method = method;
    options.last_seed = 3;
    Impatient progress;
    Console console{progress, [](const std::string&) {}};
    const auto outcome = run_trial(options, console);
    ASSERT_TRUE(outcome.ok()) << method;
    EXPECT_FALSE(outcome->ok) << method;
    EXPECT_EQ(outcome->figures["interrupted"], true) << method;
    EXPECT_EQ(outcome->figures["runs"].size(), 0U) << method;
  }
}

}  // namespace
}  // namespace aisle
