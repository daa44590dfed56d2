#include "aisle/formats/parameter_file.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <map>
#include <vector>

#include "aisle/formats/whole_file.hpp"
#include "problem_list.hpp"

namespace aisle {
namespace {

/// Aliases may make a small file stand for an endless tree; no parameter file is larger than this.
constexpr std::size_t kMaxDepth = 16;
constexpr std::size_t kMaxEntries = 10000;

/// Walks through a YAML tree and assigns its leaves.
class ParameterReader {
 public:
  ParameterReader(const std::string& name, FieldList& fields)
      : name_(name), fields_(fields), problems_(name) {}

  Problems read(const YAML::Node& root) {
    if (!root.IsNull()) read_node("", root, line_of(root), 0);
    return problems_.take();
  }

 private:
  static long line_of(const YAML::Node& node) { return node.Mark().line + 1; }

  void read_node(const std::string& key, const YAML::Node& node, long line, std::size_t depth) {
    if (node.IsMap()) return read_map(key, node, line, depth);
    if (node.IsScalar() && !key.empty()) return assign(key, node.Scalar(), line);
    if (key.empty()) return problems_.add(line, "the file is not a map of keys to values");
    problems_.add(line, key, node.IsSequence() ? "a list is no value" : "has no value");
  }

  void read_map(const std::string& key, const YAML::Node& map, long line, std::size_t depth) {
    if (depth == kMaxDepth) return problems_.add(line, key, "is nested too deeply");
    for (const auto& entry : map) {
      const long entry_line = line_of(entry.first);
      if (++entries_ > kMaxEntries) return problems_.add(entry_line, key, "has too many entries");
      if (!entry.first.IsScalar()) {
        problems_.add(entry_line, key, "has a key that is no text");
        continue;
      }
      const std::string inner = key.empty() ? entry.first.Scalar() : key + "." + entry.first.Scalar();
      read_node(inner, entry.second, entry_line, depth + 1);
    }
  }

  void assign(const std::string& key, const std::string& value, long line) {
    const auto [first, is_new] = line_of_key_.emplace(key, line);
    if (!is_new)
      return problems_.add(line, key, fmt::format("is set twice, first on line {}", first->second));
    for (Problem& problem : fields_.assign(key, value, {name_, line, key})) problems_.add(std::move(problem));
  }

  std::string name_;
  FieldList& fields_;
  ProblemList problems_;
  std::map<std::string, long> line_of_key_;
  std::size_t entries_ = 0;
};

/// A field and what is left of its key below the maps that are open already.
struct NestedField {
  std::string_view key;
  const Field* field;
};

std::string comment_of(const Field& field) {
  if (std::holds_alternative<bool*>(field.target)) return fmt::format("# {} (true or false)", field.doc);
  return fmt::format("# {} ({:g} .. {:g})", field.doc, field.range.min, field.range.max);
}

void write_level(std::string& text, const std::vector<NestedField>& fields, std::size_t indent) {
  const std::string blanks(indent, ' ');
  std::vector<bool> written(fields.size());
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (written[i]) continue;
    const std::size_t dot = fields[i].key.find('.');
    if (dot == std::string_view::npos) {
      const Field& field = *fields[i].field;
      text += fmt::format("{}{}\n{}{}: {}\n", blanks, comment_of(field), blanks, fields[i].key,
                          field.value_text());
      continue;
    }
    const std::string_view prefix = fields[i].key.substr(0, dot + 1);
    std::vector<NestedField> group;
    for (std::size_t j = i; j < fields.size(); ++j) {
      if (!fields[j].key.starts_with(prefix)) continue;
      group.push_back({fields[j].key.substr(prefix.size()), fields[j].field});
      written[j] = true;
    }
    text += fmt::format("{}{}:\n", blanks, prefix.substr(0, dot));
    write_level(text, group, indent + 2);
  }
}

}  // namespace

Problems parse_parameters(std::string_view text, const std::string& name, FieldList& fields) {
  try {
    return ParameterReader(name, fields).read(YAML::Load(std::string(text)));
  } catch (const YAML::Exception& error) {
    return {{{name, error.mark.line + 1}, "is not well-formed YAML: " + error.msg}};
  }
}

Problems read_parameters(const std::filesystem::path& path, FieldList& fields) {
  const Result<std::string> text = read_whole_file(path);
  if (!text) return text.problems();
  return parse_parameters(*text, path.string(), fields);
}

std::string parameters_yaml(const FieldList& fields) {
  std::vector<NestedField> all;
  for (const Field& field : fields.all()) all.push_back({field.key, &field});
  std::string text;
  write_level(text, all, 0);
  return text;
}

}  // namespace aisle
