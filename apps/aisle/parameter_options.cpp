#include <memory>

#include "verb.hpp"

void add_parameter_options(CLI::App& verb, aisle::ParameterSources& sources, aisle::Outcome (*list)(),
                           Work& work, const std::function<void()>& chosen) {
  verb.add_option("--params", sources.files, "parameter file (YAML); overrides the defaults");
  verb.add_option("--set", sources.settings,
                  "set one parameter, as key=value; overrides the parameter files");
  auto printed = std::make_shared<bool>(false);
  verb.add_flag("--print-params", *printed,
                "print all parameters with meaning, range and default, then exit");
  verb.callback([=, &work] {
    if (!*printed) return chosen();
    work = [list](aisle::Console&) -> aisle::Result<aisle::Outcome> { return list(); };
  });
}
