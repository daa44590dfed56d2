#include "aisle/commands/list_shipped.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/commands/shipped_files.hpp"

namespace aisle {
namespace {

constexpr const char* kShippedKinds[] = {"worlds", "vehicles", "scenarios"};

std::string lines_of(const std::vector<ShippedFile>& files) {
  std::size_t width = 0;
  for (const ShippedFile& file : files) width = std::max(width, file.name.size());
  std::string lines;
  for (const ShippedFile& file : files)
    lines += fmt::format("  {:{}}  {}\n", file.name, width, file.description);
  return lines;
}

}  // namespace

Result<Outcome> run_list_shipped(const std::string& kind) {
  Outcome outcome{.verb = "list"};
  for (const char* shipped : kShippedKinds) {
    if (!kind.empty() && kind != shipped) continue;
    const std::vector<ShippedFile> files = shipped_files(shipped);
    if (files.empty())
      return Problem{{shipped},
                     "none are found beside the program; it is neither installed nor where it was built"};
    nlohmann::ordered_json& listed = outcome.figures[shipped] = nlohmann::ordered_json::array();
    for (const ShippedFile& file : files)
      listed.push_back({{"name", file.name}, {"description", file.description}});
    outcome.text += fmt::format("{}\n{}", shipped, lines_of(files));
  }
  return outcome;
}

}  // namespace aisle
