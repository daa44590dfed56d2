#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "aisle/commands/shipped_files.hpp"
#include "machine_check.hpp"

namespace aisle {

MachineCheck check_shipped_files() {
  MachineCheck check{.name = "shipped files"};
  std::string separator;
  for (const std::string kind : {"worlds", "vehicles", "scenarios"}) {
    const std::size_t count = shipped_files(kind).size();
    check.found += fmt::format("{}{} {}", separator, count, kind);
    separator = ", ";
    if (count == 0) check.state = MachineState::kMissing;
  }
  if (check.state != MachineState::kGood)
    check.advice =
        "keep the program where it was built, or install the package 'aisle': it looks for its files beside "
        "itself";
  return check;
}

MachineCheck check_page() {
  const std::filesystem::path page = shipped_page();
  if (!page.empty()) return {.name = "live page", .found = page.string()};
  return {.name = "live page",
          .state = MachineState::kLimited,
          .found = "not beside the program: '--live' and 'aisle live' have no page to serve",
          .advice = "build it by scripts/web, which needs npm, or install the package 'aisle'"};
}

MachineCheck check_folder() {
  MachineCheck check{.name = "current folder"};
  std::error_code error;
  const std::filesystem::path here = std::filesystem::current_path(error);
  const int refused = error ? error.value() : access(".", W_OK | X_OK) != 0 ? errno : 0;
  if (refused != 0) {
    check.state = MachineState::kLimited;
    check.found = fmt::format("{} cannot be written to: {}", here.string(), std::strerror(refused));
    check.advice = "go to a folder of your own, or give '--out' the path of one";
    return check;
  }
  const auto space = std::filesystem::space(here, error);
  check.found = fmt::format("{} can be written to", here.string());
  if (!error) check.found += fmt::format(", {:.1f} GB free", static_cast<double>(space.available) / 1e9);
  return check;
}

}  // namespace aisle
