#include "aisle/guidance/exploration/bumper_contacts.hpp"

#include <utility>

namespace aisle {

bool BumperContacts::touches(bool is_pressed) {
  const bool was_pressed = std::exchange(is_pressed_, is_pressed);
  if (!is_pressed || was_pressed) return false;
  ++count_;
  is_to_note_ = driven_.has_value();
  return true;
}

std::optional<Gear> BumperContacts::stopped_after_contact(bool is_standing) {
  if (!is_to_note_ || !is_standing) return std::nullopt;
  is_to_note_ = false;
  if (driven_ == LegDirection::kForward) return Gear::kForward;
  if (driven_ == LegDirection::kReverse) return Gear::kReverse;
  return std::nullopt;
}

}  // namespace aisle
