#include "aisle/trials/trial_process.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace aisle {
namespace {

class TrialProcessTest : public testing::Test {
 protected:
  TrialProcessTest() {
    for (const char* variable : kVariables) ::unsetenv(variable);
  }
  ~TrialProcessTest() override {
    for (const char* variable : kVariables) ::unsetenv(variable);
  }

  static constexpr const char* kVariables[] = {
      "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMI_SIZE",
      "SLURM_PROCID",         "SLURM_STEP_NUM_TASKS"};
};

TEST_F(TrialProcessTest, IsAloneUnlessTheStarterSaysOtherwise) {
  EXPECT_EQ(trial_process_from_environment().count, 1U);
  for (const int starter : {0, 2, 4}) {
    ::setenv(kVariables[starter], "3", 1);
    ::setenv(kVariables[starter + 1], "8", 1);
    EXPECT_EQ(trial_process_from_environment().rank, 3U);
    EXPECT_EQ(trial_process_from_environment().count, 8U);
    ::unsetenv(kVariables[starter]);
  }
}

TEST_F(TrialProcessTest, BelievesNoNonsense) {
  for (const auto& [rank, count] : {std::pair{"8", "8"}, {"-1", "2"}, {"1", "2x"}, {"", ""}}) {
    ::setenv("PMI_RANK", rank, 1);
    ::setenv("PMI_SIZE", count, 1);
    EXPECT_EQ(trial_process_from_environment().count, 1U) << rank << " of " << count;
  }
}

TEST_F(TrialProcessTest, HasACore) {
  EXPECT_GE(usable_cores(), 1);
}

}  // namespace
}  // namespace aisle
