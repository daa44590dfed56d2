#pragma once

#include <yaml-cpp/yaml.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problem_list.hpp"
#include "worlds/world_fields.hpp"

namespace aisle {

/// Reads the nodes of a world file into fields; collects problems instead of stopping at the first.
class WorldNodeReader {
 public:
  /// What reads the value of a key that is no plain field.
  struct Section {
    std::string_view key;
    std::function<void(const YAML::Node&)> read;
    bool is_needed = false;
  };

  explicit WorldNodeReader(const std::string& file) : problems_(file) {}

  /// Every key of `map` once, none unknown, none of the needed ones left out. `key` says where in the file
  /// the map stands; empty: it is the file.
  void read_map(const YAML::Node& map, const std::string& key, const WorldFields& fields,
                const std::vector<Section>& sections = {});
  /// Those points that can be read.
  void read_points(const YAML::Node& node, const std::string& key, Range range, std::vector<Vec2>& target);

  bool is_list(const YAML::Node& node, const std::string& key);
  bool is_room_left(const YAML::Node& node, const std::string& key, std::size_t count, std::size_t most);

  void problem(const YAML::Node& node, const std::string& key, std::string what);
  /// A problem with what stands at `key`, found after reading.
  void problem(const std::string& key, std::string what);

  std::size_t problem_count() const { return problems_.count(); }
  /// So many problems that reading on is of no use. What is good is limited in number, so this bounds the
  /// work that a file can ask for.
  bool is_hopeless() const { return problem_count() > 1000; }
  Problems take_problems() { return problems_.take(); }

 private:
  void read_field(const YAML::Node& node, const std::string& key, const WorldField& field);
  /// Whether all coordinates could be read; else the target is as it was.
  bool read_point(const YAML::Node& node, const std::string& key, Range range, const PointTarget& target);
  void read_text(const YAML::Node& node, const std::string& key, const WorldField& field,
                 std::string& target);
  void read_word(const YAML::Node& node, const std::string& key, const WordTarget& target);
  void read_whole_number(const YAML::Node& node, const std::string& key, std::uint64_t& target);
  void read_count(const YAML::Node& node, const std::string& key, Range range, int& target);
  std::optional<double> number(const YAML::Node& node, const std::string& key, Range range);
  long line_of(std::string key) const;

  ProblemList problems_;
  std::map<std::string, long> lines_;  ///< of the keys read so far
};

}  // namespace aisle
