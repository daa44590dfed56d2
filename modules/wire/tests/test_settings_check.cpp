#include <gmock/gmock.h>

#include "aisle/wire/wire.hpp"
#include "settings_check.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

const std::vector<std::string> kOwn{"127.0.0.1", "192.168.1.5"};

TEST(WireSettingsCheck, DefaultsAreRight) {
  EXPECT_TRUE(check_settings({}, kOwn).empty());
  EXPECT_TRUE(check_settings({.domain = 101, .interface_address = "192.168.1.5", .peers = {"10.0.0.9"}}, kOwn)
                  .empty());
  EXPECT_TRUE(check_settings({.peers = {}}, kOwn).empty());
  EXPECT_TRUE(check_settings({.peers = {"192.168.1.5"}}, kOwn).empty());
}

TEST(WireSettingsCheck, EverythingThatIsWrongIsNamedAtOnce) {
  const Problems problems = check_settings(
      {.domain = 102, .interface_address = "192.168.1.6", .peers = {"127.0.0.1", "robot", "239.255.0.1"}},
      kOwn);
  EXPECT_EQ(to_string(problems),
            "domain: 102 is not in 0 to 101\n"
            "interface: '192.168.1.6' is not an address of this machine, which has 127.0.0.1, 192.168.1.5\n"
            "peers: 'robot' is not an IPv4 address of a machine, such as 192.168.1.20\n"
            "peers: '239.255.0.1' is not an IPv4 address of a machine, such as 192.168.1.20");
}

TEST(WireSettingsCheck, WhatIsNoAddressOfAMachineIsNoPeer) {
  for (const char* peer :
       {"", "0.0.0.0", "255.255.255.255", "1.2.3", "1.2.3.4.5", "1.2.3.4 ", "::1", "1.2.3.256"})
    EXPECT_EQ(check_settings({.peers = {peer}}, kOwn).size(), 1U) << peer;
}

TEST(WireSettingsCheck, OtherMachinesAreOutOfReachOfTheLoopback) {
  EXPECT_THAT(to_string(check_settings({.peers = {"192.168.1.7"}}, kOwn)),
              HasSubstr("'192.168.1.7' is another machine, which the interface 127.0.0.1 does not reach"));
}

TEST(WireSettingsCheck, TheLoopbackIsAnAddressOfThisMachine) {
  EXPECT_THAT(own_addresses(), Contains("127.0.0.1"));
}

TEST(WireSettingsCheck, AWireIsNotOpenedWithThem) {
  // An address that is kept for documentation: no machine has it.
  const auto wire = Wire::open({.domain = 233, .interface_address = "192.0.2.1"});
  ASSERT_FALSE(wire);
  EXPECT_THAT(to_string(wire.problems()),
              AllOf(HasSubstr("domain: 233"), HasSubstr("interface: '192.0.2.1'"), HasSubstr("127.0.0.1")));
}

}  // namespace
}  // namespace aisle
