#include "live_learning.hpp"

#include <fmt/format.h>

#include <system_error>

namespace aisle {
namespace fs = std::filesystem;

namespace {

/// A temporary folder beside the building for the files of the verb; only the building is kept.
class Workbench {
 public:
  explicit Workbench(const fs::path& building)
      : building_(building),
        folder_(building.parent_path() / fmt::format(".{}.work", building.stem().string())) {}
  ~Workbench() {
    std::error_code error;
    fs::remove_all(folder_, error);
  }
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;

  const fs::path& folder() const { return folder_; }

  Result<Outcome> keep_building(Result<Outcome> outcome) const {
    if (!outcome) return outcome;
    std::error_code error;
    fs::rename(folder_ / "building.json", building_, error);
    if (error) return Problem{{building_.string()}, "cannot be written: " + error.message()};
    outcome->files = {{"building", building_.string()}};
    outcome->text += fmt::format("kept as {}\n", building_.stem().string());
    return outcome;
  }

 private:
  fs::path building_;
  fs::path folder_;
};

}  // namespace

Result<Outcome> learn_into(const LearnOptions& options, const fs::path& building, Console& console) {
  const Workbench bench(building);
  LearnOptions within = options;
  within.out = bench.folder();
  within.force = true;
  return bench.keep_building(run_learn(within, console));
}

Result<Outcome> explore_into(const ExploreOptions& options, const fs::path& building, Console& console) {
  if (building.empty()) return run_explore(options, console);
  const Workbench bench(building);
  ExploreOptions within = options;
  within.out = bench.folder();
  within.force = true;
  return bench.keep_building(run_explore(within, console));
}

}  // namespace aisle
