#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/core/result.hpp"
#include "problem_list.hpp"

namespace aisle {

/// One value of a JSON document with its key path. Reading a value of the wrong kind adds a problem that
/// names the path, and leaves the target unchanged.
class JsonValue {
 public:
  /// `value` and `problems` must outlive this.
  JsonValue(const nlohmann::json& value, std::string path, ProblemList& problems)
      : value_(value), path_(std::move(path)), problems_(problems) {}

  void read(std::string& target) const;
  void read(bool& target) const;
  /// A text of 1 to 200 bytes.
  void read_name(std::string& target) const;
  void read_count(int& target, Range range) const;
  void read_count(std::uint64_t& target) const;
  void read_number(double& target, Range range) const;
  /// A list of as many numbers as there are targets.
  void read_numbers(std::span<double* const> targets, Range range) const;

  bool is(std::string_view text) const { return value_ == text; }
  bool is_text() const;
  bool is_list() const;
  bool is_list_of(std::size_t count) const;
  bool is_list_up_to(std::size_t count_max) const;
  std::size_t size() const { return value_.size(); }
  JsonValue element(std::size_t index) const;
  /// Reads the objects of a list, or of the same list as a table: {"columns": keys, "rows": a list of lists
  /// of values, null where the object lacks the key}.
  void for_each_object(std::size_t count_max, const std::function<void(const JsonValue&)>& read) const;

  /// Whether this is an object; keys other than `known` and their former names (aisle/core/former_keys.hpp)
  /// are problems, and so is a key under both names.
  bool is_object_of(const std::vector<std::string_view>& known) const;
  /// The value of a key, or else of the key's former name.
  std::optional<JsonValue> find(std::string_view key) const;
  /// Like find(), but a missing key is a problem.
  std::optional<JsonValue> require(std::string_view key) const;

  void wrong(std::string what) const { problems_.add(0, path_, std::move(what)); }

 private:
  std::string path_to(std::string_view key) const;

  const nlohmann::json& value_;
  std::string path_;
  ProblemList& problems_;
};

}  // namespace aisle
