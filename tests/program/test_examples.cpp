#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>

#include "workplace.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// The lines of a help below a heading, up to the next empty one, without their indent.
std::vector<std::string> lines_below(const std::string& help, const std::string& heading) {
  std::vector<std::string> lines;
  bool is_below = false;
  for (const std::string& line : lines_of(help)) {
    if (is_below && line.empty()) break;
    if (is_below && line.starts_with("  ") && line[2] != ' ') lines.push_back(line.substr(2));
    is_below = is_below || line == heading;
  }
  return lines;
}

/// The words of a command as a shell would split them.
Arguments words_of(const std::string& command) {
  Arguments words(1);
  bool is_quoted = false;
  for (const char c : command) {
    if (c == '"') {
      is_quoted = !is_quoted;
    } else if (c == ' ' && !is_quoted) {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

struct VerbHelp {
  std::string verb;  ///< "", "map", "sim render"
  std::string text;
};

/// The help of the program, of every verb, and of the verbs below it.
std::vector<VerbHelp> all_helps() {
  std::vector<VerbHelp> helps = {{"", run_aisle({"--help"}).out}};
  for (std::size_t i = 0; i < helps.size(); ++i) {
    for (const std::string& line : lines_below(helps[i].text, "Subcommands:")) {
      const std::string word = line.substr(0, line.find(' '));
      const std::string verb = helps[i].verb.empty() ? word : helps[i].verb + " " + word;
      Arguments words = words_of(verb);
      words.emplace_back("--help");
      helps.push_back({verb, run_aisle(words).out});
    }
  }
  return helps;
}

/// The help of the verb that a command names.
std::string help_of(const std::string& command, const std::vector<VerbHelp>& helps) {
  std::string help;
  for (const VerbHelp& one : helps) {
    if (command.starts_with("aisle " + one.verb + " ")) help = one.text;
  }
  return help;
}

/// The example as the test runs it: what would take long, or go on for ever, is refused after its options
/// have been read.
Arguments harmless(Arguments words, const std::string& help) {
  const auto has_option = [&](const char* option) { return help.find(option) != std::string::npos; };
  if (has_option("  --set ")) words.insert(words.end(), {"--set", "no_such_key=1"});
  if (words.at(0) == "live") words.insert(words.end(), {"--cert", "none.pem", "--key", "none.pem"});
  if (has_option("  --seconds ") && std::find(words.begin(), words.end(), "--seconds") == words.end())
    words.insert(words.end(), {"--seconds", "0.5"});
  return words;
}

/// Tests in an empty folder, so that every input is missing.
class Examples : public Workplace {
 protected:
  void SetUp() override { fs::current_path(at(".")); }
  void TearDown() override { fs::current_path("/"); }
};

TEST_F(Examples, OfEveryHelpAreAccepted) {
  const std::vector<VerbHelp> helps = all_helps();
  ASSERT_GT(helps.size(), 40U);
  for (const auto& [verb, help] : helps) {
    const std::vector<std::string> examples = lines_below(help, "Examples:");
    EXPECT_THAT(examples, AnyOf(SizeIs(1), SizeIs(2), SizeIs(3))) << verb;
    for (const std::string& example : examples) {
      ASSERT_THAT(example, StartsWith("aisle " + verb));
      const ProgramRun run = run_aisle(harmless(words_of(example.substr(6)), help_of(example, helps)));
      EXPECT_THAT(run.exit_code, AnyOf(0, 1, 2)) << example << run.err;
      EXPECT_THAT(run.err, Not(HasSubstr("--help)"))) << example;
      EXPECT_THAT(run.err, Not(HasSubstr("is now"))) << example;
    }
  }
}

TEST_F(Examples, ResultsGoToTheSameOptionOfEveryVerb) {
  for (const auto& [verb, help] : all_helps()) EXPECT_THAT(help, Not(HasSubstr("\n  --out "))) << verb;
}

/// The rows of a table of the documentation, each a list of its cells without their quotes.
std::vector<std::vector<std::string>> documented_rows(const std::string& heading) {
  const std::vector<std::string> lines =
      lines_of(read_bytes(AISLE_SOURCE_DIR "/docs/reference/command-line.md"));
  auto line = std::find(lines.begin(), lines.end(), heading);
  std::vector<std::vector<std::string>> rows;
  for (; line != lines.end(); ++line) {
    if (!line->starts_with("| `")) continue;
    std::vector<std::string> cells;
    for (std::size_t at = 0; (at = line->find('`', at)) != std::string::npos;) {
      const std::size_t end = line->find('`', at + 1);
      cells.push_back(line->substr(at + 1, end - at - 1));
      at = end + 1;
    }
    rows.push_back(std::move(cells));
  }
  return rows;
}

TEST_F(Examples, RenamedOptionsAreReadAndWarnedOf) {
  const auto rows = documented_rows("## Options with a new name");
  ASSERT_THAT(rows, Not(IsEmpty()));
  for (const std::vector<std::string>& row : rows) {
    ASSERT_THAT(row, SizeIs(3));
    const auto& [verb, former, present] = std::tie(row[0], row[1], row[2]);
    for (const std::string& given : {former, former + "=none"}) {
      Arguments words = words_of(verb);
      words.push_back(given);
      const std::string warning = "warning: " + former + " of aisle " + verb + " is now " + present + "\n";
      EXPECT_THAT(run_aisle(words).err, StartsWith(warning));
      words.emplace_back("--quiet");
      EXPECT_THAT(run_aisle(words).err, Not(HasSubstr("warning"))) << verb;
    }
  }
}

TEST_F(Examples, ARenamedOptionDoesWhatItDid) {
  const ProgramRun run = run_aisle({"drive", "l-corridor", "--no-pictures", "--scenario", "none.yaml"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("none.yaml: no such file"));
  EXPECT_EQ(run_aisle({"sim", "render", "l-corridor", "--at=1,0,0", "--output", "view.png"}).exit_code, 0);
  EXPECT_TRUE(fs::exists("view.png"));
}

TEST_F(Examples, TheMethodOfRoomsIsReadByItsFormerName) {
  const ProgramRun learning = run_aisle({"learn", "none", "--method", "route"});
  EXPECT_THAT(learning.err, HasSubstr("warning: the method 'route' is now 'rooms'"));
  EXPECT_THAT(learning.err, HasSubstr("none: no such session"));
  const ProgramRun trial = run_aisle({"trial", "route", "--set", "route.navigator.speed_mps=-1"});
  EXPECT_THAT(trial.err, HasSubstr("warning: the method 'route' is now 'rooms'"));
  EXPECT_THAT(trial.err, HasSubstr("route.navigator.speed_mps"));
  EXPECT_THAT(trial.err, Not(HasSubstr("unknown key")));
}

}  // namespace
}  // namespace aisle
