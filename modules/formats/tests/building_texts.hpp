#pragma once

#include <gtest/gtest.h>

#include <string>

#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/whole_file.hpp"
#include "golden_files.hpp"

namespace aisle {

/// The problems of a building's text; empty if there are none.
inline std::string building_problems(const std::string& text) {
  const auto building = parse_building(text, "b.json");
  return building.ok() ? "" : to_string(building.problems());
}

/// A golden building with one passage replaced by another.
inline std::string golden_building(const char* name, const std::string& passage = "",
                                   const std::string& other = "") {
  std::string text = *read_whole_file(kGolden / name);
  const std::size_t at = text.find(passage);
  EXPECT_NE(at, std::string::npos) << passage;
  return text.replace(at, passage.size(), other);
}

}  // namespace aisle
