#pragma once

#include <string>
#include <vector>

namespace aisle {

enum class MachineState {
  kGood,
  kLimited,  ///< some uses will not work, or not well
  kMissing,  ///< nothing will work
};

/// One thing that aisle may need of the machine.
struct MachineCheck {
  std::string name;
  MachineState state = MachineState::kGood;
  std::string found;   ///< as it is, for people
  std::string advice;  ///< what to do about it; empty: nothing
};

MachineCheck check_cores();
MachineCheck check_memory();
MachineCheck check_shipped_files();
MachineCheck check_page();
/// The folder that commands write to unless they are told another.
MachineCheck check_folder();
/// /dev/video*: whether there are any that this user may open.
MachineCheck check_cameras();
/// Whether a ROS 2 network can be taken part in on this machine, in the domain that ROS_DOMAIN_ID names.
MachineCheck check_ros_network();
/// Whether an interface besides the loopback takes multicast, by which robots find others that look for no
/// peers.
MachineCheck check_multicast();
/// Whether the kernel's clock is kept by a time server, and by how much it may be wrong.
MachineCheck check_clock();

}  // namespace aisle
