#include <set>
#include <string>

#include "aisle/formats/study_file.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto study = parse_study(std::string(fuzz_text(bytes, size)), "input");
  if (!study.ok()) return 0;
  require(study->variants.size() >= 2);
  std::set<std::string> directories;
  for (const StudyVariant& variant : study->variants) {
    const std::string directory = directory_of(variant);
    require(directories.insert(directory).second);
    require(directory.find('/') == std::string::npos);
  }
  return 0;
}
