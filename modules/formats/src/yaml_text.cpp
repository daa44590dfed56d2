#include "yaml_text.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>

namespace aisle {

std::string yaml_quoted(const std::string& text) {
  YAML::Emitter out;
  out << YAML::DoubleQuoted << text;
  return out.c_str();
}

bool is_line_of_text(const std::string& text) {
  const auto is_control = [](unsigned char c) { return c < ' ' || c == 127; };
  return std::none_of(text.begin(), text.end(), is_control) && YAML::Load(yaml_quoted(text)).Scalar() == text;
}

}  // namespace aisle
