#include "aisle/commands/parameter_sources.hpp"

#include "aisle/formats/parameter_file.hpp"

namespace aisle {

Problems ParameterSources::apply_to(FieldList& fields) const {
  Problems problems;
  const auto add = [&](const Problems& more) { problems.insert(problems.end(), more.begin(), more.end()); };
  for (const std::filesystem::path& file : files) add(read_parameters(file, fields));
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) {
      add({{{"--set"}, "'" + setting + "' is not of the form key=value"}});
    } else {
      add(fields.assign(setting.substr(0, equals), setting.substr(equals + 1), {"--set"}));
    }
  }
  return problems;
}

}  // namespace aisle
