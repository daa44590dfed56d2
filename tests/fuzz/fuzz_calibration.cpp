#include "aisle/formats/calibration_file.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

/// What is read can be written in either layout, and reads back the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto read = parse_calibration(fuzz_text(bytes, size), "input");
  if (!read) return 0;
  (void)CameraModel(read->intrinsics);
  for (const auto& write : {opencv_calibration_yaml, camera_info_yaml}) {
    const auto again = parse_calibration(write(*read), "written");
    require(again.ok());
    require(write(*again) == write(*read));
  }
  return 0;
}
