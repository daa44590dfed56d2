#include "yaml_text.hpp"

#include <yaml-cpp/yaml.h>

namespace aisle {

std::string yaml_quoted(const std::string& text) {
  YAML::Emitter out;
  out << YAML::DoubleQuoted << text;
  return out.c_str();
}

}  // namespace aisle
