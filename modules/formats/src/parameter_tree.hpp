#pragma once

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <map>
#include <string>

#include "aisle/core/parameters.hpp"
#include "problem_list.hpp"

namespace aisle {

/// Walks a YAML tree of nested or dotted keys and assigns its leaves to fields.
class ParameterTree {
 public:
  /// @param name  the file name in problems
  ParameterTree(const std::string& name, FieldList& fields) : name_(name), fields_(fields), problems_(name) {}

  /// @param key  of the tree's root; empty: the root is the whole file
  void read(const std::string& key, const YAML::Node& root);

  Problems take_problems() { return problems_.take(); }

 private:
  void read_node(const std::string& key, const YAML::Node& node, long line, std::size_t depth);
  void read_map(const std::string& key, const YAML::Node& map, long line, std::size_t depth);
  void assign(const std::string& key, const std::string& value, long line);

  std::string name_;
  FieldList& fields_;
  ProblemList problems_;
  std::map<std::string, long> line_of_key_;
  std::size_t entries_ = 0;
};

}  // namespace aisle
