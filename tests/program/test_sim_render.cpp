#include <gmock/gmock.h>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

class SimRender : public Workplace {
 protected:
  ProgramRun render(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(),
                     {"sim", "render", AISLE_SOURCE_DIR "/worlds/small-office.yaml", "--json"});
    return run_aisle(arguments);
  }
};

TEST_F(SimRender, TheSamePlaceAndSeedGiveTheSameImage) {
  const auto result = render({"--pose", "2,1,90", "-o", at("a.png")}).json();
  EXPECT_EQ(result["figures"]["simulated"], true);
  EXPECT_EQ(result["figures"]["width_px"], 640);
  EXPECT_EQ(result["figures"]["heading_deg"], 90);
  render({"--pose", "2,1,90", "-o", at("b.png")});
  render({"--pose", "2,1,90", "-o", at("c.png"), "--seed", "2"});
  EXPECT_TRUE(read_bytes(at("a.png")) == read_bytes(at("b.png")));
  EXPECT_FALSE(read_bytes(at("a.png")) == read_bytes(at("c.png")));
}

TEST_F(SimRender, RefusesToReplaceAnImageUnlessForced) {
  render({"-o", at("a.png")});
  const ProgramRun refused = render({"-o", at("a.png")});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--force"));
  EXPECT_EQ(render({"-o", at("a.png"), "--force"}).exit_code, 0);
}

TEST_F(SimRender, SaysWhichCamerasThereAreAndWhatAPlaceLooksLike) {
  const ProgramRun no_camera =
      render({"--vehicle", AISLE_SOURCE_DIR "/vehicles/alv.yaml", "--camera", "rear", "-o", at("a.png")});
  EXPECT_EQ(no_camera.exit_code, 2);
  EXPECT_THAT(no_camera.err, HasSubstr("there is no camera 'rear'; there are: "));
  const ProgramRun no_place = render({"--pose", "1,2", "-o", at("a.png")});
  EXPECT_EQ(no_place.exit_code, 2);
  EXPECT_THAT(no_place.err, HasSubstr("'1,2' is not x,y,degrees"));
  EXPECT_EQ(render({"-o", at("a.txt")}).exit_code, 2);
}

}  // namespace
}  // namespace aisle
