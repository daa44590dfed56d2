#include <gmock/gmock.h>

#include "aisle/vehicle/same_camera.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

CameraDescription corridor_camera() {
  CameraDescription camera;
  camera.name = "corridor";
  camera.intrinsics = {.fx_px = 460, .fy_px = 460, .cx_px = 319.5, .cy_px = 239.5, .k1 = -0.18, .k2 = 0.03};
  camera.mount = {.p_vehicle_camera = {0.85, 0, 1}, .tilt_rad = 14 * kDegree};
  return camera;
}

TEST(SameCamera, TheSameOneIsTheSame) {
  EXPECT_THAT(check_same_camera(corridor_camera(), corridor_camera()), IsEmpty());
}

TEST(SameCamera, ANewCalibrationOfItIsTheSame) {
  CameraDescription again = corridor_camera();
  again.intrinsics.fx_px *= 1.004;
  again.intrinsics.cy_px += 0.4;
  again.intrinsics.k1 += 0.0005;
  again.mount.p_vehicle_camera.z() += 0.005;
  again.mount.tilt_rad += 0.19 * kDegree;
  again.mount.pan_rad -= 0.2 * kDegree;
  again.period_s = 0.2;
  EXPECT_THAT(check_same_camera(corridor_camera(), again), IsEmpty());
}

TEST(SameCamera, EverythingThatDiffersIsSaidAtOnce) {
  CameraDescription other = corridor_camera();
  other.name = "front";
  other.width_px = 1280;
  other.intrinsics.fx_px *= 1.01;
  other.intrinsics.cx_px += 0.6;
  other.intrinsics.k2 += 0.1;
  other.mount.p_vehicle_camera.x() += 0.006;
  other.mount.tilt_rad += 0.3 * kDegree;
  const Problems problems = check_same_camera(corridor_camera(), other);
  EXPECT_THAT(problems, SizeIs(7));
  EXPECT_THAT(to_string(problems),
              AllOf(HasSubstr("cameras.front: is not 'corridor', which the landmarks were seen with"),
                    HasSubstr("cameras.front.width_px: is 1280, but the landmarks were seen with 640"),
                    HasSubstr("cameras.front.fx_px: is 464.6, but the landmarks were seen with 460"),
                    HasSubstr("cameras.front.cx_px: is 320.1"),
                    HasSubstr("cameras.front.k1: and the further"), HasSubstr("cameras.front.x_m: is 0.856"),
                    HasSubstr("cameras.front.tilt_deg: is 14.3, but the landmarks were seen with 14")));
}

TEST(SameCamera, AFullTurnIsNoDifference) {
  CameraDescription behind = corridor_camera(), again = corridor_camera();
  behind.mount.pan_rad = 180 * kDegree;
  again.mount.pan_rad = -180 * kDegree;
  EXPECT_THAT(check_same_camera(behind, again), IsEmpty());
}

TEST(SameCamera, ALensThatSeesLessOfTheImageDiffers) {
  CameraDescription folded = corridor_camera();
  folded.intrinsics.k1 = -5;
  EXPECT_THAT(to_string(check_same_camera(corridor_camera(), folded)), HasSubstr("cameras.corridor.k1"));
  EXPECT_THAT(to_string(check_same_camera(folded, corridor_camera())), HasSubstr("cameras.corridor.k1"));
}

}  // namespace
}  // namespace aisle
