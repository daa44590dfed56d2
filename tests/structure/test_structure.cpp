#include <gtest/gtest.h>

#include <regex>

#include "module_sources.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;

class Structure : public testing::Test {
 protected:
  static fs::path directory(const std::string& module) {
    return fs::path(AISLE_SOURCE_DIR) / "modules" / module;
  }

  const Modules modules = read_modules(AISLE_MODULES_FILE);
};

/// The aisle modules that these lines include, each with the line that includes it.
std::vector<std::pair<std::string, SourceLine>> included_modules(const std::vector<SourceLine>& lines) {
  static const std::regex include(R"(^\s*#\s*include\s*["<]aisle/(\w+)/.*)");
  std::vector<std::pair<std::string, SourceLine>> found;
  for (const SourceLine& line : lines) {
    if (std::smatch match; std::regex_match(line.text, match, include)) found.emplace_back(match[1], line);
  }
  return found;
}

/// Checks that the lines include only `module` itself and `allowed`; returns the number of includes.
std::size_t check_includes(const std::vector<SourceLine>& lines, const std::string& module,
                           const std::set<std::string>& allowed) {
  const auto included = included_modules(lines);
  for (const auto& [name, line] : included) {
    EXPECT_TRUE(name == module || allowed.contains(name)) << to_string(line);
  }
  return included.size();
}

TEST_F(Structure, ModulesIncludeOnlyWhatTheyDeclareToUse) {
  std::size_t includes = 0;
  for (const auto& [name, module] : modules) {
    const std::set<std::string> public_reach = in_reach(modules, module.uses);
    std::set<std::string> reach = in_reach(modules, module.uses_privately);
    reach.insert(public_reach.begin(), public_reach.end());
    includes += check_includes(source_lines(directory(name) / "include"), name, public_reach);
    includes += check_includes(source_lines(directory(name) / "src"), name, reach);
  }
  EXPECT_GT(includes, 100) << "too few includes were seen for this to be all of aisle";
}

/// The types that the headers of all modules, private ones too, define in the namespace aisle itself.
std::map<std::string, std::vector<SourceLine>> types_of(const fs::path& modules_directory) {
  static const std::regex definition(R"(^(?:struct|class) ([A-Z]\w*)(?: final)?(?: :.*)? \{.*)");
  std::map<std::string, std::vector<SourceLine>> types;
  bool is_in_aisle = false;
  for (const SourceLine& line : source_lines(modules_directory)) {
    if (line.file.extension() != ".hpp") continue;
    if (line.text.starts_with("namespace ")) is_in_aisle = line.text.starts_with("namespace aisle {");
    if (std::smatch match; is_in_aisle && std::regex_match(line.text, match, definition))
      types[match[1]].push_back(line);
  }
  return types;
}

/// The linker would take one of them for the other without a word.
TEST_F(Structure, NoTwoTypesHaveOneName) {
  const auto types = types_of(fs::path(AISLE_SOURCE_DIR) / "modules");
  EXPECT_GT(types.size(), 500) << "too few types were seen for this to be all of aisle";
  for (const auto& [name, lines] : types) {
    EXPECT_EQ(lines.size(), 1) << to_string(lines.front()) << "\n" << to_string(lines.back());
  }
}

TEST_F(Structure, EveryModuleDirectoryIsPartOfTheBuild) {
  for (const auto& entry : fs::directory_iterator(fs::path(AISLE_SOURCE_DIR) / "modules")) {
    EXPECT_TRUE(modules.contains(entry.path().filename())) << entry.path();
  }
}

TEST_F(Structure, EveryModuleHasAReadme) {
  ASSERT_GT(modules.size(), 5);
  for (const auto& [name, module] : modules) EXPECT_TRUE(fs::exists(directory(name) / "README.md")) << name;
}

bool prints_or_ends_the_program(const std::string& line) {
  static const std::regex forbidden(
      R"((^|[^\w.>])(std::)?(cout|cerr|clog|v?f?printf|f?puts|putchar|putc|fputc|perror)\b)"
      R"(|\bfmt::(print|vprint)\b)"
      R"(|(^|[^\w.>])(std::)?(exit|_exit|_Exit|quick_exit|abort|terminate)\s*\()");
  return std::regex_search(line, forbidden);
}

TEST_F(Structure, PrintingAndEndingTheProgramAreRecognised) {
  for (const char* line :
       {"  std::cout << 1;", "printf(\"\");", "std::fprintf(stderr, \"\");", "fmt::print(text);", "exit(1);",
        "  std::abort();", "if (bad) std::terminate ();", "std::fputs(text, stdout);"}) {
    EXPECT_TRUE(prints_or_ends_the_program(line)) << line;
  }
  for (const char* line : {"std::snprintf(text, 9, \"\");", "node.exit();", "add_inputs();", "on_exit_(1);",
                           "fmt::format(text);", "corridor->exit(2);"}) {
    EXPECT_FALSE(prints_or_ends_the_program(line)) << line;
  }
}

/// A worker of `trials` is a process that the library has started: it ends without the program's exit
/// handlers.
bool ends_a_worker(const std::string& module, const std::string& line) {
  return module == "trials" && line.ends_with("::_exit(EXIT_SUCCESS);");
}

TEST_F(Structure, LibrariesNeverPrintExitOrAbort) {
  std::size_t inspected = 0;
  for (const auto& [name, module] : modules) {
    for (const char* part : {"include", "src"}) {
      for (const SourceLine& line : source_lines(directory(name) / part)) {
        EXPECT_FALSE(prints_or_ends_the_program(line.text) && !ends_a_worker(name, line.text))
            << to_string(line);
        ++inspected;
      }
    }
  }
  EXPECT_GT(inspected, 1000) << "too few lines were seen for this to be all of aisle";
}

}  // namespace
}  // namespace aisle
