#include "aisle/formats/parameter_file.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

namespace {

struct Window {
  int tries = 3;
  bool careful = true;
  void describe(FieldList& fields) {
    fields.count("tries", tries, {1, 10}, "how often");
    fields.flag("careful", careful, "slower and surer");
  }
};

struct Params {
  double reach_m = 2;
  double opening_rad = 0.1;
  Window window;
  void describe(FieldList& fields) {
    fields.real("reach_m", reach_m, {0, 5}, "how far");
    fields.angle("opening_deg", opening_rad, {0, 90}, "how wide");
    fields.group("window", window);
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  Params params;
  FieldList fields = fields_of(params);
  (void)parse_parameters(fuzz_text(bytes, size), "input", fields);
  require(params.reach_m >= 0 && params.reach_m <= 5);
  require(params.window.tries >= 1 && params.window.tries <= 10);
  require(parse_parameters(parameters_yaml(fields), "written", fields).empty());
  return 0;
}
