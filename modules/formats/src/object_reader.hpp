#pragma once

#include <yaml-cpp/yaml.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "object_fields.hpp"
#include "problem_list.hpp"

namespace aisle {

/// Reads the nodes of a YAML file into the fields of objects; collects all problems instead of stopping at
/// the first.
class ObjectReader {
 public:
  /// Reads the value of a key that is not a plain field; takes the value's key path too.
  struct Section {
    std::string_view key;
    std::function<void(const YAML::Node&, const std::string&)> read;
    bool is_needed = false;
  };

  explicit ObjectReader(const std::string& file) : problems_(file) {}

  /// A needed key that has one possible value.
  Section constant(std::string_view key, std::string_view value);

  /// Reads a map: duplicate keys, unknown keys and missing needed keys are problems. `key` is the map's key
  /// path; empty: the map is the whole file.
  void read_map(const YAML::Node& map, const std::string& key, const ObjectFields& fields,
                const std::vector<Section>& sections = {});
  /// Reads the points that are readable.
  void read_points(const YAML::Node& node, const std::string& key, Range range, std::vector<Vec2>& target);

  bool is_list(const YAML::Node& node, const std::string& key);
  bool is_room_left(const YAML::Node& node, const std::string& key, std::size_t count, std::size_t most);

  void problem(const YAML::Node& node, const std::string& key, std::string what);
  /// Adds a problem with the value at `key`, found after reading.
  void problem(const std::string& key, std::string what);

  std::size_t problem_count() const { return problems_.count(); }
  /// So many problems that reading on is useless. The number of valid entries is limited, so this bounds the
  /// work that a file can cause.
  bool is_hopeless() const { return problem_count() > 1000; }
  Problems take_problems() { return problems_.take(); }

 private:
  void read_field(const YAML::Node& node, const std::string& key, const ObjectField& field);
  /// @return whether all coordinates are readable; if not, the target is unchanged
  bool read_point(const YAML::Node& node, const std::string& key, Range range, const PointTarget& target);
  void read_text(const YAML::Node& node, const std::string& key, const ObjectField& field,
                 std::string& target);
  void read_word(const YAML::Node& node, const std::string& key, const WordTarget& target);
  void read_whole_number(const YAML::Node& node, const std::string& key, std::uint64_t& target);
  void read_count(const YAML::Node& node, const std::string& key, Range range, int& target);
  void read_flag(const YAML::Node& node, const std::string& key, bool& target);
  std::optional<double> number(const YAML::Node& node, const std::string& key, Range range);
  long line_of(std::string key) const;

  ProblemList problems_;
  std::map<std::string, long> lines_;  ///< of the keys read so far
};

}  // namespace aisle
