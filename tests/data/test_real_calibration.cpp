#include <gmock/gmock.h>

#include "real_data.hpp"
#include "run_aisle.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;

TEST(RealCalibration, ThirteenViewsOfARealBoardGiveItsKnownLens) {
  const fs::path directory = real_data() / "images/chessboard_opencv";
  AISLE_NEEDS(directory);
  Arguments arguments = {"calibrate", "camera", "--json"};
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (entry.path().extension() == ".jpg") arguments.push_back(entry.path().string());
  }
  const ProgramRun run = run_aisle(arguments);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["views"].size(), 13U);
  EXPECT_NEAR(figures["fx_px"], 532.8, 0.01 * 532.8);
  EXPECT_NEAR(figures["fy_px"], 532.8, 0.01 * 532.8);
  EXPECT_LE(figures["rms_px"], 0.25);
}

}  // namespace
}  // namespace aisle
