#include "module_sources.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace aisle {
namespace fs = std::filesystem;

Modules read_modules(const fs::path& file) {
  constexpr std::string_view kOwn = "aisle::";
  Modules modules;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    Module& module = modules[word];
    std::set<std::string>* declared = &module.uses;
    while (words >> word) {
      if (word == "USES_PRIVATELY") declared = &module.uses_privately;
      if (word.starts_with(kOwn)) declared->insert(word.substr(kOwn.size()));
    }
  }
  return modules;
}

std::set<std::string> in_reach(const Modules& modules, const std::set<std::string>& direct) {
  std::set<std::string> reached = direct;
  for (const std::string& name : direct) reached.merge(in_reach(modules, modules.at(name).uses));
  return reached;
}

std::string to_string(const SourceLine& line) {
  return line.file.string() + ":" + std::to_string(line.number) + ": " + line.text;
}

std::vector<SourceLine> source_lines(const fs::path& directory) {
  std::vector<SourceLine> lines;
  if (!fs::exists(directory)) return lines;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
    std::ifstream in(entry.path());
    int number = 0;
    for (std::string text; std::getline(in, text);) {
      lines.push_back({entry.path(), ++number, text.substr(0, text.find("//"))});
    }
  }
  return lines;
}

}  // namespace aisle
