#include <gmock/gmock.h>

#include <cstdlib>
#include <sstream>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using testing::StartsWith;

/// What the shells are offered, without the meanings.
std::vector<std::string> completed(Arguments words) {
  words.insert(words.begin(), "complete");
  const ProgramRun run = run_aisle(words);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  std::istringstream lines(run.out);
  std::vector<std::string> offered;
  for (std::string line; std::getline(lines, line);) offered.push_back(line.substr(0, line.find('\t')));
  return offered;
}

class Completion : public Workplace {};

TEST_F(Completion, OffersVerbsAndTheVerbsBelow) {
  EXPECT_THAT(completed({"expl"}), ElementsAre("explore"));
  EXPECT_THAT(completed({""}), IsSupersetOf({"doctor", "explore", "live", "map"}));
  EXPECT_THAT(completed({""}), Not(Contains("complete"))) << "it is no verb of people";
  EXPECT_THAT(completed({"sim", ""}), ElementsAre("log", "render", "show"));
  EXPECT_THAT(completed({"juggle", "b"}), IsEmpty());
}

TEST_F(Completion, OffersTheOptionsOfAVerbAndOfThoseAbove) {
  EXPECT_THAT(completed({"map", "--rel"}), ElementsAre("--relations"));
  EXPECT_THAT(completed({"sim", "log", "--"}), IsSupersetOf({"--json", "--out", "--seed"}));
  EXPECT_THAT(completed({"map", "--live"}), IsEmpty()) << "another verb has it";
}

TEST_F(Completion, OffersTheChoicesOfAnOption) {
  EXPECT_THAT(completed({"map", "--units", ""}), ElementsAre("cm", "m", "mm"));
  EXPECT_THAT(completed({"map", "--units", "=", "c"}), ElementsAre("cm")) << "as bash splits --units=c";
  EXPECT_THAT(completed({"list", ""}), ElementsAre("scenarios", "vehicles", "worlds"));
  EXPECT_THAT(completed({"map", "--quiet", "--force", "--ou"}), ElementsAre("--out"))
      << "flags take no value";
}

TEST_F(Completion, OffersTheNamesOfShippedFilesWhereOneIsTaken) {
  EXPECT_THAT(completed({"explore", "cross"}), ElementsAre("crossings"));
  EXPECT_THAT(completed({"explore", "--seed", "2", "cross"}), ElementsAre("crossings"));
  EXPECT_THAT(completed({"explore", "--vehicle", "al"}), IsSupersetOf({"alv", "alv-scanner"}));
  EXPECT_THAT(completed({"explore", "--out", "cross"}), IsEmpty()) << "a folder of the user's own";
}

TEST_F(Completion, OfBashIsThatOfTheProgram) {
  const std::string script = file("try.bash",
                                  "set -eu\n"
                                  "source " AISLE_SOURCE_DIR
                                  "/packaging/completion.bash\n"
                                  "COMP_WORDS=(aisle sim '') COMP_CWORD=2\n_aisle\necho \"${COMPREPLY[*]}\"\n"
                                  "COMP_WORDS=(aisle expl) COMP_CWORD=1\n_aisle\necho \"${COMPREPLY[*]}\"\n");
  const std::string folder = std::filesystem::path(AISLE_PROGRAM).parent_path();
  const std::string command = "PATH=" + folder + ":$PATH bash " + script + " >" + at("said");
  ASSERT_EQ(std::system(command.c_str()), 0);  // NOLINT(concurrency-mt-unsafe): no threads here
  EXPECT_EQ(read_bytes(at("said")), "log render show\nexplore\n");
}

class Manual : public Workplace {};

TEST_F(Manual, HasAPageForEveryVerbWithAllItsOptions) {
  ASSERT_EQ(run_aisle({"manual", at("man1")}).exit_code, 0);
  const std::vector<std::string> verbs = completed({""});
  EXPECT_EQ(names_in(at("man1")).size(), verbs.size() + 1);
  const std::string program = read_bytes(at("man1/aisle.1"));
  EXPECT_THAT(program, HasSubstr(".SH EXIT STATUS\n"));
  for (const std::string& verb : verbs) {
    EXPECT_THAT(program, HasSubstr("\\fBaisle\\-" + verb + "\\fR")) << verb;
    EXPECT_THAT(read_bytes(at("man1/aisle-" + verb + ".1")), StartsWith(".TH aisle-" + verb + " 1 ")) << verb;
  }
  const std::string map = read_bytes(at("man1/aisle-map.1"));
  EXPECT_THAT(map, HasSubstr("\\fB\\-\\-units\\fR \\fIm|cm|mm\\fR\n"));
  EXPECT_THAT(map, HasSubstr("[\\fILOG\\fR]"));
  EXPECT_THAT(read_bytes(at("man1/aisle-sim.1")), HasSubstr(".SH aisle sim log\n"));
}

TEST_F(Manual, RefusesAFolderThatCannotBeMade) {
  file("taken", "");
  EXPECT_EQ(run_aisle({"manual", at("taken/man1")}).exit_code, 3);
}

}  // namespace
}  // namespace aisle
