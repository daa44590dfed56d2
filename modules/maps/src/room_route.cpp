#include "aisle/maps/room_route.hpp"

#include <algorithm>
#include <stdexcept>

namespace aisle {

TurningClass class_of_turning(int number) {
  switch (number) {
    case 1:
    case 7:
    case 8:
    case 10:
    case 13:
      return TurningClass::kLeft;
    case 3:
    case 5:
    case 6:
    case 11:
    case 12:
      return TurningClass::kRight;
    case 2:
    case 4:
    case 9:
      return TurningClass::kStraightOn;
    default:
      throw std::invalid_argument("turnings are numbered 1 to 13");
  }
}

MaskOut mask_out(const RoomTurning& turning, double along_m) {
  constexpr double kRapidShare = 0.75, kHalf = 0.5, kQuarter = 0.25;
  constexpr int kLeftBranch = 2, kRightBranch = 4;
  const bool is_rapid = along_m - turning.start_m < kRapidShare * (turning.end_m - turning.start_m);
  const double turned_from = is_rapid ? kHalf : kQuarter;
  switch (class_of_turning(turning.number)) {
    case TurningClass::kLeft:
      return {.right = turned_from};
    case TurningClass::kRight:
      return {.left = turned_from};
    case TurningClass::kStraightOn:
      break;
  }
  return {.left = turning.number == kRightBranch ? 0 : kQuarter,
          .right = turning.number == kLeftBranch ? 0 : kQuarter};
}

const RoomTurning* turning_at(const std::vector<RoomTurning>& turnings, double along_m) {
  const RoomTurning* latest = nullptr;
  for (const RoomTurning& turning : turnings) {
    if (along_m >= turning.start_m && along_m < turning.end_m) latest = &turning;
  }
  return latest;
}

std::optional<ParkingStrategy> parking_of(std::string_view word) {
  const auto found = std::find(kParkingWords.begin(), kParkingWords.end(), word);
  if (found == kParkingWords.end()) return std::nullopt;
  return static_cast<ParkingStrategy>(found - kParkingWords.begin());
}

}  // namespace aisle
