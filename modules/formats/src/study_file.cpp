#include "aisle/formats/study_file.hpp"

#include <fmt/format.h>

#include <cctype>
#include <set>
#include <utility>

#include "aisle/formats/whole_file.hpp"
#include "file_limits.hpp"
#include "object_reader.hpp"
#include "yaml_text.hpp"

namespace aisle {
namespace {

constexpr std::size_t kVariantsMax = 200;
constexpr std::size_t kFiguresMax = 20;

/// Something that a sweep changes, with each of its values.
struct SweptOption {
  std::string option;     ///< "--speed"
  std::string parameter;  ///< "landmarks.learner.window_m"; empty: it is an option
  std::vector<std::string> values;

  StudyVariant with(const std::string& value) const {
    if (!parameter.empty()) return {parameter + "=" + value, fmt::format("--set {}={}", parameter, value)};
    return {option.substr(option.find_first_not_of('-')) + "=" + value, fmt::format("{} {}", option, value)};
  }
};

/// Reads one document.
class StudyReader {
 public:
  explicit StudyReader(const std::string& file) : nodes_(file) {}

  Result<Study> read(const YAML::Node& document) {
    const ObjectFields fields = {needed(field::text("trial", study_.trial)),
                                 needed(field::text("seeds", study_.seeds))};
    if (document.IsMap()) {
      nodes_.read_map(document, "", fields,
                      {nodes_.constant("format", "aisle.study"),
                       nodes_.constant("version", "1"),
                       {"figures", [this](const auto& node, const auto& key) { read_figures(node, key); }},
                       {"variants", [this](const auto& node, const auto& key) { read_variants(node, key); }},
                       {"sweep", [this](const auto& node, const auto& key) { read_sweep(node, key); }}});
      check_variants(document);
    } else {
      nodes_.problem(document, "", "is not a study: expected keys, the first 'format: aisle.study'");
    }
    if (nodes_.problem_count() > 0) return nodes_.take_problems();
    return std::move(study_);
  }

 private:
  void read_figures(const YAML::Node& node, const std::string& key) {
    read_texts(node, key, kFiguresMax, study_.figures);
  }

  void read_variants(const YAML::Node& node, const std::string& key) {
    if (!nodes_.is_list(node, key) || !nodes_.is_room_left(node, key, node.size(), kVariantsMax)) return;
    for (std::size_t i = 0; i < node.size(); ++i) {
      StudyVariant variant;
      nodes_.read_map(node[i], fmt::format("{}[{}]", key, i),
                      {needed(field::text("name", variant.name)), field::text("options", variant.words)});
      study_.variants.push_back(std::move(variant));
    }
  }

  /// All combinations, the first option's values changing slowest.
  void read_sweep(const YAML::Node& node, const std::string& key) {
    is_sweep_ = true;
    if (!nodes_.is_list(node, key) || !nodes_.is_room_left(node, key, node.size(), kVariantsMax)) return;
    std::vector<StudyVariant> combinations = {{}};
    for (std::size_t i = 0; i < node.size(); ++i) {
      const std::string at = fmt::format("{}[{}]", key, i);
      const SweptOption swept = read_swept(node[i], at);
      if (nodes_.problem_count() > 0) return;
      if (!nodes_.is_room_left(node[i], at, combinations.size() * swept.values.size(), kVariantsMax)) return;
      combinations = combined(combinations, swept);
    }
    study_.variants.insert(study_.variants.end(), combinations.begin(), combinations.end());
  }

  SweptOption read_swept(const YAML::Node& node, const std::string& key) {
    SweptOption swept;
    nodes_.read_map(node, key,
                    {field::text("option", swept.option), field::text("parameter", swept.parameter)},
                    {{"values",
                      [&](const YAML::Node& values, const std::string& at) {
                        read_texts(values, at, kVariantsMax, swept.values);
                        if (swept.values.empty()) nodes_.problem(values, at, "has no values");
                      },
                      true}});
    if (swept.option.empty() == swept.parameter.empty())
      nodes_.problem(node, key, "needs an option, such as --speed, or a parameter, but not both");
    else if (!swept.option.empty() && !swept.option.starts_with("--"))
      nodes_.problem(node, key + ".option", fmt::format("'{}' does not begin with --", swept.option));
    return swept;
  }

  static std::vector<StudyVariant> combined(const std::vector<StudyVariant>& before,
                                            const SweptOption& swept) {
    std::vector<StudyVariant> combinations;
    for (const StudyVariant& variant : before) {
      for (const std::string& value : swept.values) {
        const StudyVariant more = swept.with(value);
        combinations.push_back(variant.name.empty() ? more
                                                    : StudyVariant{variant.name + ", " + more.name,
                                                                   variant.words + " " + more.words});
      }
    }
    return combinations;
  }

  void read_texts(const YAML::Node& node, const std::string& key, std::size_t most,
                  std::vector<std::string>& texts) {
    if (!nodes_.is_list(node, key) || !nodes_.is_room_left(node, key, node.size(), most)) return;
    for (std::size_t i = 0; i < node.size(); ++i) {
      if (node[i].IsScalar() && !node[i].Scalar().empty() && is_line_of_text(node[i].Scalar()))
        texts.push_back(node[i].Scalar());
      else
        nodes_.problem(node[i], fmt::format("{}[{}]", key, i), "is not a line of text");
    }
  }

  void check_variants(const YAML::Node& document) {
    if (nodes_.problem_count() > 0) return;
    if (is_sweep_ && document["variants"])
      nodes_.problem(document, "", "needs variants or a sweep, but not both");
    if (study_.variants.size() < 2) nodes_.problem(document, "", "needs at least two variants to compare");
    std::set<std::string> directories;
    for (const StudyVariant& variant : study_.variants) {
      if (!directories.insert(directory_of(variant)).second)
        nodes_.problem(document, "", fmt::format("has two variants that are called '{}'", variant.name));
    }
  }

  Study study_;
  bool is_sweep_ = false;
  ObjectReader nodes_;
};

}  // namespace

Result<Study> read_study(const std::filesystem::path& path) {
  const Result<std::string> text = read_whole_file(path, kSettingsBytesMax);
  if (!text) return text.problems();
  return parse_study(*text, path.string());
}

Result<Study> parse_study(const std::string& text, const std::string& name) {
  try {
    return StudyReader(name).read(load_yaml(text));
  } catch (const YAML::Exception& error) {
    return Problem{{name, error.mark.line + 1}, "is not YAML: " + error.msg};
  }
}

std::string directory_of(const StudyVariant& variant) {
  constexpr std::string_view kKept = "=._-";
  std::string directory;
  for (const char c : variant.name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_kept = byte < 128 && (std::isalnum(byte) != 0 || kKept.find(c) != std::string_view::npos);
    directory += is_kept ? static_cast<char>(std::tolower(byte)) : '-';
  }
  return "variant-" + directory;
}

}  // namespace aisle
