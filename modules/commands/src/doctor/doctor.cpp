#include "aisle/commands/doctor.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "machine_check.hpp"

namespace aisle {
namespace {

std::string word_of(MachineState state) {
  switch (state) {
    case MachineState::kGood:
      return "good";
    case MachineState::kLimited:
      return "limited";
    case MachineState::kMissing:
      return "missing";
  }
  return {};
}

std::string text_of(const MachineCheck& check) {
  const std::string advice = check.advice.empty() ? "" : fmt::format("{:24}-> {}\n", "", check.advice);
  return fmt::format("{:8}{:16}{}\n{}", word_of(check.state), check.name, check.found, advice);
}

}  // namespace

Result<Outcome> run_doctor() {
  const std::vector<MachineCheck> checks{check_cores(), check_memory(),      check_shipped_files(),
                                         check_page(),  check_folder(),      check_cameras(),
                                         check_clock(), check_ros_network(), check_multicast()};
  Outcome outcome{.verb = "doctor"};
  nlohmann::ordered_json& listed = outcome.figures["checks"] = nlohmann::ordered_json::array();
  for (const MachineCheck& check : checks) {
    if (check.state == MachineState::kMissing) outcome.ok = false;
    listed.push_back({{"name", check.name},
                      {"state", word_of(check.state)},
                      {"found", check.found},
                      {"advice", check.advice}});
    outcome.text += text_of(check);
  }
  return outcome;
}

}  // namespace aisle
