#pragma once

#include <optional>

#include "aisle/control/path.hpp"
#include "aisle/vehicle/gear.hpp"

namespace aisle {

/// Counts bumper contacts, and says when and where what was touched can be entered into the floor: at the end
/// of the vehicle that led when it touched it, once it stands.
class BumperContacts {
 public:
  static constexpr int kMost = 5;  ///< of a mission: with more, something is wrong

  /// To be called in each cycle in which the vehicle drives.
  void note_driving(LegDirection direction) { driven_ = direction; }

  /// Once a cycle.
  /// @return whether the bumper has touched something since the last cycle
  bool touches(bool is_pressed);

  /// Once a cycle without a new contact.
  /// @return once for a contact, when the vehicle has come to a stand: the gear that it drove in; never for
  ///         one before it first drove, or while it turned on the spot
  std::optional<Gear> stopped_after_contact(bool is_standing);

  /// In which it drove last; nullopt: it has not driven yet.
  std::optional<LegDirection> driven_direction() const { return driven_; }
  int count() const { return count_; }
  bool are_too_many() const { return count_ > kMost; }

 private:
  std::optional<LegDirection> driven_;
  bool is_pressed_ = false;
  bool is_to_note_ = false;
  int count_ = 0;
};

}  // namespace aisle
