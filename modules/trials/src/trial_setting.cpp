#include "trial_setting.hpp"

#include <fmt/format.h>

namespace aisle {

Result<SimulationSetting> setting_of_seed(const TrialOptions& options, std::uint64_t seed,
                                          const std::string& vehicle, std::span<const BuildingKind> kinds) {
  const bool is_random = options.worlds.empty();
  const std::string named =
      is_random ? "" : options.worlds[(seed - options.first_seed) % options.worlds.size()];
  auto setting = read_setting(named, vehicle, options.scenario, options.plan_pixel_m);
  if (!setting || !is_random) return setting;
  const BuildingKind kind = options.kind.value_or(kinds[seed % kinds.size()]);
  setting->world = random_building({.kind = kind}, Random(seed));
  setting->world.name = fmt::format("{}-{}", name_of(kind), seed);
  setting->world_file = setting->world.name;
  return setting;
}

}  // namespace aisle
