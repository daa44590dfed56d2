#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>

#include "aisle/core/problem.hpp"

namespace aisle {

/// The arguments of a service, read key by key; problems() reports all errors at once.
class LiveArguments {
 public:
  /// @param json  an object
  explicit LiveArguments(const nlohmann::json& json) : json_(json), known_{"lease", "mission"} {}

  /// Empty if it is missing.
  std::string text(const char* key);
  std::string needed_text(const char* key);
  /// File name without folder and extension; empty if it is missing.
  std::string name(const char* key);
  std::string needed_name(const char* key);
  std::optional<double> number(const char* key);
  /// A whole number, 0 .. `max`.
  std::optional<std::uint64_t> count(const char* key, std::uint64_t max);
  bool flag(const char* key);
  /// Of any kind, for the caller to check; null if it is missing.
  const nlohmann::json* value(const char* key) { return find(key); }

  /// All problems so far, and one for each key that was never read.
  Problems problems() const;

 private:
  const nlohmann::json* find(const char* key);
  void wrong(const char* key, const std::string& what) { problems_.push_back({{"", 0, key}, what}); }

  const nlohmann::json& json_;
  std::set<std::string> known_;
  Problems problems_;
};

}  // namespace aisle
