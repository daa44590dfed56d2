#include "aisle/formats/worlds/scenario_yaml.hpp"

#include <fmt/format.h>

#include <span>
#include <utility>

#include "aisle/formats/whole_file.hpp"
#include "file_limits.hpp"
#include "object_reader.hpp"
#include "worlds/scenario_fields.hpp"
#include "yaml_text.hpp"

namespace aisle {
namespace {

constexpr std::size_t kEventsMax = 1'000;

/// Reads one document.
class ScenarioReader {
 public:
  explicit ScenarioReader(const std::string& file) : nodes_(file) {}

  Result<Scenario> read(const YAML::Node& document) {
    const ObjectFields fields = {field::text("name", scenario_.name), field::text("world", scenario_.world)};
    if (document.IsMap()) {
      nodes_.read_map(
          document, "", fields,
          {nodes_.constant("format", "aisle.scenario"),
           nodes_.constant("version", "1"),
           {"events", [this](const YAML::Node& node, const std::string& key) { read_events(node, key); },
            true}});
    } else {
      nodes_.problem(document, "", "is not a scenario: expected keys, the first 'format: aisle.scenario'");
    }
    if (nodes_.problem_count() > 0) return nodes_.take_problems();
    return std::move(scenario_);
  }

 private:
  void read_events(const YAML::Node& node, const std::string& key) {
    if (!nodes_.is_list(node, key) || !nodes_.is_room_left(node, key, node.size(), kEventsMax)) return;
    for (std::size_t i = 0; i < node.size() && !nodes_.is_hopeless(); ++i) {
      read_event(node[i], fmt::format("{}[{}]", key, i));
    }
  }

  void read_event(const YAML::Node& node, const std::string& key) {
    EventTimes times;
    ScenarioEvent event;
    std::size_t faults = 0;
    std::vector<ObjectReader::Section> sections;
    std::vector<std::string_view> names;
    for_each_fault([&](std::string_view name, const auto& shipped) {
      names.push_back(name);
      sections.push_back({name, [&, shipped](const YAML::Node& inner, const std::string& inner_key) {
                            auto fault = shipped;
                            nodes_.read_map(inner, inner_key, fields_of(fault));
                            event.fault = std::move(fault);
                            ++faults;
                          }});
    });
    nodes_.read_map(node, key, fields_of(times), sections);
    if (!node.IsMap()) return;
    if (faults != 1) {
      const std::span but_last = std::span(names).first(names.size() - 1);
      nodes_.problem(node, key,
                     fmt::format("needs one fault: {} or {}", fmt::join(but_last, ", "), names.back()));
    }
    event.from_s = times.from_s;
    if (times.for_s > 0) event.duration_s = times.for_s;
    if (node["near"]) event.near = times.near;
    event.radius_m = times.radius_m;
    scenario_.events.push_back(std::move(event));
    check_path(node, key);
  }

  void check_path(const YAML::Node& node, const std::string& key) {
    const auto* crossing = std::get_if<CrossingPerson>(&scenario_.events.back().fault);
    if (crossing != nullptr && crossing->person.path.size() < 2 && nodes_.problem_count() == 0) {
      nodes_.problem(node, key + ".person.path", "needs at least two points");
    }
  }

  Scenario scenario_;
  ObjectReader nodes_;
};

}  // namespace

Result<Scenario> read_scenario(const std::filesystem::path& path) {
  const Result<std::string> text = read_whole_file(path, kSettingsBytesMax);
  if (!text) return text.problems();
  return parse_scenario(*text, path.string());
}

Result<Scenario> parse_scenario(const std::string& text, const std::string& name) {
  try {
    return ScenarioReader(name).read(load_yaml(text));
  } catch (const YAML::Exception& error) {
    return Problem{{name, error.mark.line + 1}, "is not YAML: " + error.msg};
  }
}

}  // namespace aisle
