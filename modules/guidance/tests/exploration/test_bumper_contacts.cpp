#include "aisle/guidance/exploration/bumper_contacts.hpp"

#include <gtest/gtest.h>

namespace aisle {
namespace {

TEST(BumperContacts, AContactThatLastsIsOne) {
  BumperContacts contacts;
  EXPECT_FALSE(contacts.touches(false));
  EXPECT_TRUE(contacts.touches(true));
  EXPECT_FALSE(contacts.touches(true));
  EXPECT_FALSE(contacts.touches(false));
  EXPECT_TRUE(contacts.touches(true));
  EXPECT_EQ(contacts.count(), 2);
}

TEST(BumperContacts, AreTooManyAfterTheFifth) {
  BumperContacts contacts;
  for (int i = 1; i <= 6; ++i) {
    contacts.touches(true);
    contacts.touches(false);
    EXPECT_EQ(contacts.are_too_many(), i == 6);
  }
}

TEST(BumperContacts, SayOnceInWhichGearItTouchedSomethingWhenItStands) {
  BumperContacts contacts;
  contacts.note_driving(LegDirection::kForward);
  contacts.note_driving(LegDirection::kReverse);
  contacts.touches(true);
  EXPECT_EQ(contacts.stopped_after_contact(false), std::nullopt);
  EXPECT_EQ(contacts.stopped_after_contact(true), Gear::kReverse);
  EXPECT_EQ(contacts.stopped_after_contact(true), std::nullopt);
}

TEST(BumperContacts, WhileItTurnsOnTheSpotNeitherEndLeads) {
  BumperContacts contacts;
  contacts.note_driving(LegDirection::kForward);
  contacts.note_driving(LegDirection::kRight);
  contacts.touches(true);
  EXPECT_EQ(contacts.stopped_after_contact(true), std::nullopt);
  EXPECT_EQ(contacts.driven_direction(), LegDirection::kRight);
}

TEST(BumperContacts, BeforeItFirstDroveNothingIsKnownOfWhereItWasTouched) {
  BumperContacts contacts;
  EXPECT_TRUE(contacts.touches(true));
  EXPECT_EQ(contacts.driven_direction(), std::nullopt);
  EXPECT_EQ(contacts.stopped_after_contact(true), std::nullopt);
}

}  // namespace
}  // namespace aisle
