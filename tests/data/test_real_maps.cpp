#include <gmock/gmock.h>

#include "real_data.hpp"
#include "workplace.hpp"

namespace aisle {
namespace {

class RealMaps : public Workplace {};

TEST_F(RealMaps, Fr079IsMappedAsExactlyAsPromised) {
  const auto folder = real_data() / "laser/fr079";
  AISLE_NEEDS(folder);
  const ProgramRun run = run_aisle({"map", folder / "fr079.clf.gz", "--laser-offset", "-0.04", "--relations",
                                    folder / "fr079.relations.gz", "--out", at("out"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["scans"], 4934);
  EXPECT_EQ(figures["relations"]["count"], 1685);
  EXPECT_LE(figures["translation_m"]["mean"], 0.033);
  EXPECT_LE(figures["rotation_deg"]["mean"], 0.47);
  EXPECT_LE(figures["online"]["translation_m"]["mean"], 0.06);
  EXPECT_LE(figures["peak_rss_mb"], 200);
  EXPECT_EQ(figures["no_dominant_direction"], false);
  EXPECT_LE(std::filesystem::file_size(at("out/building.json")), 200'000);
}

TEST_F(RealMaps, AcesClosesItsLoops) {
  const auto log = real_data() / "laser/aces/aces.clf.gz";
  AISLE_NEEDS(log);
  const ProgramRun run = run_aisle({"map", log, "--out", at("out"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto result = run.json();
  EXPECT_EQ(result["figures"]["scans"], 7374);
  EXPECT_GE(result["figures"]["loop_closures"], 10);
  EXPECT_EQ(result["figures"]["no_dominant_direction"], false);
  EXPECT_TRUE(read_bytes(result["files"]["picture_png"].get<std::string>()).starts_with("\x89PNG"));
}

}  // namespace
}  // namespace aisle
