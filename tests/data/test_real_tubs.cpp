/// Tubs of real Donkeycars, which are not part of the repository.

#include <gmock/gmock.h>

#include "real_data.hpp"
#include "workplace.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

class RealTubs : public Workplace {
 protected:
  nlohmann::json imported(const std::filesystem::path& recording) {
    const ProgramRun run = run_aisle({"import", recording, "--out", at("session"), "--force", "--json"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    warnings = run.err;
    return run.json()["figures"];
  }

  std::string warnings;
};

TEST_F(RealTubs, AHouseIsImportedWhole) {
  const auto tub = real_data() / "recordings/donkey-house";
  AISLE_NEEDS(tub);
  const auto figures = imported(tub);
  EXPECT_EQ(figures["images"], 304);
  EXPECT_EQ(figures["left_out"], 0);
  EXPECT_NEAR(figures["duration_s"], 71.013, 0.001);
  EXPECT_NEAR(figures["rate_hz"], 4.4, 0.1);
}

TEST_F(RealTubs, DamageCostsNoMoreThanTheDamagedRecords) {
  const auto tub = real_data() / "recordings/donkey-damaged";
  AISLE_NEEDS(tub);
  const auto figures = imported(tub);
  EXPECT_EQ(figures["images"], 147);     // 258 files, of which the driver deleted 111
  EXPECT_EQ(figures["left_out"], 1048);  // two lines, and the images that the data folder does not hold
  EXPECT_THAT(warnings, HasSubstr("catalog_0.catalog:745: is a line of NUL bytes; 2 records are left out"));
  EXPECT_THAT(warnings, HasSubstr("1046 missing images are left out"));
}

TEST_F(RealTubs, AnArchiveIsImportedAsItIs) {
  const auto archive = real_data() / "recordings/donkey-official-tub/tub.tar.gz";
  AISLE_NEEDS(archive);
  const auto figures = imported(archive);
  EXPECT_EQ(figures["images"], 1000);
  EXPECT_EQ(figures["left_out"], 0);
  // The recording was converted: its stamps are 3 ms apart, which is a guess at the rate and so a warning.
  EXPECT_THAT(warnings, HasSubstr("--rate HZ gives the images' rate"));
}

}  // namespace
}  // namespace aisle
