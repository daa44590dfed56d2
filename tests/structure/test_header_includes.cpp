// A public header includes what it names, itself or by way of what it includes, so that it can be included
// first. scripts/lint --deep compiles each header alone; this reads them all in a second.
#include <gtest/gtest.h>

#include <functional>
#include <regex>

#include "module_sources.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;

struct Header {
  std::set<std::string> includes;             ///< as written: "aisle/core/angle.hpp", "vector"
  std::set<std::string> declares;             ///< types, also nested and forward declared ones
  std::set<std::string> defines;              ///< types of a namespace
  std::map<std::string, SourceLine> names;    ///< types that may be another header's
  std::map<std::string, SourceLine> library;  ///< "vector", for std::vector<...>
};

using Headers = std::map<std::string, Header>;

std::string without_strings(const std::string& text) {
  static const std::regex string(R"("([^"\\]|\\.)*")");
  return std::regex_replace(text, string, "");
}

void read_line(const SourceLine& line, Header& header) {
  static const std::regex include(R"(^#include ["<]([^">]+)[">].*)");
  static const std::regex declaration(
      R"(^(\s*)(?:template <.*> )?(?:struct|class|enum class|enum|using) ([A-Z]\w*)\b([^;]*)(;?).*)");
  static const std::regex parameter(R"((?:class|typename) ([A-Z]\w*))");
  static const std::regex word(R"((::|\.)?\b([A-Z]\w*[a-z]\w*)\b)");
  static const std::regex of_library(R"(\bstd::(?:filesystem::)?(\w+))");
  std::smatch match;
  if (std::regex_match(line.text, match, include)) {
    header.includes.insert(match[1]);
    return;
  }
  const std::string text = without_strings(line.text);
  if (std::regex_match(text, match, declaration)) {
    header.declares.insert(match[2]);
    const bool is_forward = match[4].length() > 0 && match[3].length() == 0;
    if (match[1].length() == 0 && !is_forward) header.defines.insert(match[2]);
  }
  for (std::sregex_iterator at(text.begin(), text.end(), parameter), end; at != end; ++at)
    header.declares.insert((*at)[1]);
  for (std::sregex_iterator at(text.begin(), text.end(), word), end; at != end; ++at) {
    if ((*at)[1].length() == 0) header.names.try_emplace((*at)[2], line);
  }
  for (std::sregex_iterator at(text.begin(), text.end(), of_library), end; at != end; ++at)
    header.library.try_emplace((*at)[1], line);
}

Headers read_headers(const fs::path& modules_directory) {
  Headers headers;
  for (const auto& module : fs::directory_iterator(modules_directory)) {
    const fs::path include = module.path() / "include";
    if (!fs::is_directory(include)) continue;
    for (const SourceLine& line : source_lines(include))
      read_line(line, headers[fs::relative(line.file, include)]);
  }
  return headers;
}

/// Everything that is included with a header, itself too.
std::set<std::string> reach_of(const Headers& headers, const std::string& name) {
  std::set<std::string> reach;
  const std::function<void(const std::string&)> visit = [&](const std::string& at) {
    if (!reach.insert(at).second) return;
    if (const auto header = headers.find(at); header != headers.end())
      for (const std::string& included : header->second.includes) visit(included);
  };
  visit(name);
  return reach;
}

/// The headers of the standard library that declare what is not called like its header.
const std::map<std::string, std::set<std::string>> kDeclaredIn = {
    {"unique_ptr", {"memory"}},
    {"shared_ptr", {"memory"}},
    {"function", {"functional"}},
    {"path", {"filesystem"}},
    {"pair", {"utility", "map"}},
    {"string_view", {"string_view", "string"}},
    {"multimap", {"map"}},
    {"string", {"string"}},
    {"vector", {"vector"}},
    {"optional", {"optional"}},
    {"span", {"span"}},
    {"array", {"array"}},
    {"map", {"map"}},
    {"deque", {"deque"}},
    {"variant", {"variant"}},
    {"mutex", {"mutex"}},
    {"unordered_map", {"unordered_map"}},
    {"set", {"set"}},
    {"thread", {"thread"}},
    {"chrono", {"chrono"}},
    {"numeric_limits", {"limits"}},
    {"condition_variable", {"condition_variable"}},
};

std::string missing(const std::string& header, const SourceLine& line, const std::string& what) {
  return header + " does not include " + what + ": " + to_string(line);
}

std::vector<std::string> missing_includes(const Headers& headers) {
  std::map<std::string, std::set<std::string>> defined_in;
  for (const auto& [name, header] : headers) {
    for (const std::string& type : header.defines) defined_in[type].insert(name);
  }
  const auto is_any_in = [](const std::set<std::string>& names, const std::set<std::string>& reach) {
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return reach.contains(name); });
  };
  std::vector<std::string> found;
  for (const auto& [name, header] : headers) {
    const std::set<std::string> reach = reach_of(headers, name);
    for (const auto& [type, line] : header.names) {
      const auto definers = defined_in.find(type);
      if (definers != defined_in.end() && !header.declares.contains(type) &&
          !is_any_in(definers->second, reach))
        found.push_back(missing(name, line, *definers->second.begin()));
    }
    for (const auto& [type, line] : header.library) {
      const auto declarers = kDeclaredIn.find(type);
      if (declarers != kDeclaredIn.end() && !is_any_in(declarers->second, reach))
        found.push_back(missing(name, line, "<" + *declarers->second.begin() + ">"));
    }
  }
  return found;
}

TEST(HeaderIncludes, EveryPublicHeaderIncludesWhatItNames) {
  const Headers headers = read_headers(fs::path(AISLE_SOURCE_DIR) / "modules");
  EXPECT_GT(headers.size(), 300) << "too few headers were seen for this to be all of aisle";
  for (const std::string& problem : missing_includes(headers)) ADD_FAILURE() << problem;
}

TEST(HeaderIncludes, AHeaderThatLeansOnAnotherOnesIncludesIsNamed) {
  const auto header = [](std::initializer_list<const char*> lines) {
    Header read;
    for (const char* line : lines) read_line({"h.hpp", 1, line}, read);
    return read;
  };
  Headers headers;
  headers["aisle/a.hpp"] = header({"#include <vector>", "struct Pose {};"});
  headers["aisle/b.hpp"] =
      header({"#include \"aisle/a.hpp\"", "Pose mean_of(const std::vector<Pose>& poses);"});
  EXPECT_TRUE(missing_includes(headers).empty());
  headers["aisle/c.hpp"] = header({"struct Path {", "  std::vector<Pose> poses;", "};"});
  EXPECT_EQ(missing_includes(headers).size(), 2);
  headers["aisle/c.hpp"] =
      header({"struct Pose;", "double length_m(const Pose& from, const char* Name = \"Pose\");"});
  EXPECT_TRUE(missing_includes(headers).empty());
}

}  // namespace
}  // namespace aisle
