#include "aisle/guidance/key_controls.hpp"

namespace aisle {
namespace {

constexpr double kHeld_s = 0.5;

}  // namespace

void KeySpeeds::describe(FieldList& fields) {
  fields.real("speed_mps", speed_mps, {0.01, 5}, "with the up key");
  fields.real("reverse_speed_mps", reverse_speed_mps, {0.01, 5}, "with the down key");
  fields.angle("steering_deg", steering_rad, {1, 89}, "front-steered: with the left and right keys");
  fields.angle("turn_rate_deg_s", turn_rate_rad_s, {1, 360}, "differential: with the left and right keys");
}

KeyControls::KeyControls(const KeySpeeds& speeds, bool is_differential)
    : speeds_(speeds), is_differential_(is_differential) {}

Command KeyControls::turning(double stamp_s, double side) {
  const bool moves = stamp_s - moved_stamp_s_ <= kHeld_s;
  if (moves) moved_stamp_s_ = stamp_s;
  const double speed_mps = moves ? speed_mps_ : 0;
  if (is_differential_) return {.speed_mps = speed_mps, .turn_rate_rad_s = side * speeds_.turn_rate_rad_s};
  return {.speed_mps = speed_mps, .steering_rad = side * speeds_.steering_rad};
}

OperatorInput KeyControls::press(double stamp_s, const std::vector<Key>& keys) {
  OperatorInput input;
  const auto go = [&](double speed_mps) {
    speed_mps_ = speed_mps;
    moved_stamp_s_ = stamp_s;
    input.requested = Command{.speed_mps = speed_mps};
  };
  for (const Key& key : keys) {
    switch (key.kind) {
      case Key::Kind::kUp:
        go(speeds_.speed_mps);
        break;
      case Key::Kind::kDown:
        go(-speeds_.reverse_speed_mps);
        break;
      case Key::Kind::kLeft:
        input.requested = turning(stamp_s, 1);
        break;
      case Key::Kind::kRight:
        input.requested = turning(stamp_s, -1);
        break;
      case Key::Kind::kStop:
        moved_stamp_s_ = -1e9;
        input.requested = Command{};
        break;
      case Key::Kind::kQuit:
        input.quit = true;
        break;
      case Key::Kind::kMark:
        input.marks.push_back(key.mark);
        break;
    }
  }
  return input;
}

}  // namespace aisle
