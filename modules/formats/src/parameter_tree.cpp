#include "parameter_tree.hpp"

#include <fmt/format.h>

namespace aisle {
namespace {

/// Aliases can make a small file expand into an endless tree; no parameter file is nested this deeply.
constexpr std::size_t kMaxDepth = 16;
constexpr std::size_t kMaxEntries = 10000;

long line_of(const YAML::Node& node) {
  return node.Mark().line + 1;
}

}  // namespace

void ParameterTree::read(const std::string& key, const YAML::Node& root) {
  read_node(key, root, line_of(root), 0);
}

void ParameterTree::read_node(const std::string& key, const YAML::Node& node, long line, std::size_t depth) {
  if (node.IsMap()) return read_map(key, node, line, depth);
  if (node.IsScalar() && !key.empty()) return assign(key, node.Scalar(), line);
  if (key.empty()) return problems_.add(line, "the file is not a map of keys to values");
  problems_.add(line, key, node.IsSequence() ? "a list is not a value" : "has no value");
}

void ParameterTree::read_map(const std::string& key, const YAML::Node& map, long line, std::size_t depth) {
  if (depth == kMaxDepth) return problems_.add(line, key, "is nested too deeply");
  for (const auto& entry : map) {
    const long entry_line = line_of(entry.first);
    if (++entries_ > kMaxEntries) return problems_.add(entry_line, key, "has too many entries");
    if (!entry.first.IsScalar()) {
      problems_.add(entry_line, key, "has a key that is not text");
      continue;
    }
    const std::string inner = key.empty() ? entry.first.Scalar() : key + "." + entry.first.Scalar();
    read_node(inner, entry.second, entry_line, depth + 1);
  }
}

void ParameterTree::assign(const std::string& key, const std::string& value, long line) {
  const auto [first, is_new] = line_of_key_.emplace(key, line);
  if (!is_new) return problems_.add(line, key, fmt::format("is set twice, first on line {}", first->second));
  for (Problem& problem : fields_.assign(key, value, {name_, line, key})) problems_.add(std::move(problem));
}

}  // namespace aisle
