#include "options.hpp"

#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <sstream>
#include <string_view>
#include <vector>

namespace robots {

const char* const kUsage =
    R"(usage: mujoco_robot --world FILE [options]
  --world FILE        an aisle.world file: walls, doors, furniture, start
  --drive D           differential (default) or front-steered
  --command C         type of /cmd_vel: twist (default), twist_stamped, ackermann (front-steered alone)
  --slip              wheels with little grip
  --start X,Y,DEG     instead of the world's start
  --seed N            of the errors of wheels and ranges (default 1)
  --scan-hz F         scans a second (default 10)
  --scan-beams N      beams of a scan (default 360)
  --range-max M       of the scanner, in metres (default 12)
  --camera WxH        with a camera, 10 images a second
  --domain N          ROS_DOMAIN_ID, 0 (default) to 101
  --namespace /X      before the names of all topics but /clock
  --clock             publish /clock; stamps are simulated time
  --speed F           with --clock: F times real time, if the machine can
  --seconds S         end after S simulated seconds (default 0: at SIGTERM)
  --report FILE       what happened, as JSON, at the end
  --picture FILE      the world from above, at the start, as a PPM image
)";

namespace {

std::vector<double> numbers(std::string_view text, char separator) {
  std::vector<double> found;
  std::istringstream parts{std::string(text)};
  for (std::string part; std::getline(parts, part, separator);) {
    double number = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    const bool is_number = error == std::errc() && end == part.data() + part.size() && std::isfinite(number);
    if (!is_number) return {};
    found.push_back(number);
  }
  return found;
}

[[noreturn]] void refuse(std::string_view option, const std::string& value, const std::string& wanted) {
  throw UsageError(std::string(option) + ": '" + value + "' is not " + wanted);
}

/// Reads one value; throws UsageError with the option's name.
using Reader = std::function<void(Options&, std::string_view option, const std::string& value)>;

template <typename Number>
Reader number(Number Options::*member, double min, double max) {
  return [=](Options& options, std::string_view option, const std::string& value) {
    const std::vector<double> found = numbers(value, ' ');
    const bool is_right = found.size() == 1 && found[0] >= min && found[0] <= max &&
                          static_cast<double>(static_cast<Number>(found[0])) == found[0];
    if (!is_right) {
      std::ostringstream wanted;
      wanted << (std::is_integral_v<Number> ? "a whole number" : "a number") << " from " << min << " to "
             << max;
      refuse(option, value, wanted.str());
    }
    options.*member = static_cast<Number>(found[0]);
  };
}

Reader text(std::string Options::*member) {
  return [=](Options& options, std::string_view, const std::string& value) { options.*member = value; };
}

Reader one_of(std::string Options::*member, std::vector<std::string> words) {
  return [=](Options& options, std::string_view option, const std::string& value) {
    std::string wanted;
    for (const std::string& word : words) {
      if (word == value) options.*member = value;
      wanted += (wanted.empty() ? "" : " or ") + word;
    }
    if (options.*member != value) refuse(option, value, wanted);
  };
}

void read_start(Options& options, std::string_view option, const std::string& value) {
  const std::vector<double> found = numbers(value, ',');
  if (found.size() != 3) refuse(option, value, "X,Y,DEG");
  options.T_world_start = Pose2{found[0], found[1], to_radians(found[2])};
}

void read_camera(Options& options, std::string_view option, const std::string& value) {
  constexpr double kMax_px = 4096;
  const std::vector<double> found = numbers(value, 'x');
  if (found.size() != 2 || std::min(found[0], found[1]) < 16 || std::max(found[0], found[1]) > kMax_px) {
    refuse(option, value, "WxH in pixels");
  }
  options.camera = ImageSize{static_cast<int>(found[0]), static_cast<int>(found[1])};
}

void read_namespace(Options& options, std::string_view option, const std::string& value) {
  if (value.size() < 2 || value.front() != '/' || value.back() == '/')
    refuse(option, value, "of the form /x");
  options.ros_namespace = value;
}

const std::map<std::string_view, Reader>& readers() {
  static const std::map<std::string_view, Reader> kReaders = {
      {"--world", text(&Options::world)},
      {"--drive", one_of(&Options::drive, {"differential", "front-steered"})},
      {"--command", one_of(&Options::command, {"twist", "twist_stamped", "ackermann"})},
      {"--start", read_start},
      {"--seed", number(&Options::seed, 0, 1e9)},
      {"--scan-hz", number(&Options::scan_hz, 0.1, 100)},
      {"--scan-beams", number(&Options::scan_beams, 1, 10000)},
      {"--range-max", number(&Options::range_max_m, 0.1, 1000)},
      {"--camera", read_camera},
      {"--domain", number(&Options::domain, 0, 101)},
      {"--namespace", read_namespace},
      {"--speed", number(&Options::speed, 0.01, 1000)},
      {"--seconds", number(&Options::seconds, 0, 1e6)},
      {"--report", text(&Options::report)},
      {"--picture", text(&Options::picture)}};
  return kReaders;
}

void check(const Options& options) {
  if (options.world.empty()) throw UsageError("--world is needed");
  if (options.speed != 1 && !options.simulated_clock) throw UsageError("--speed needs --clock");
  if (options.command == "ackermann" && options.drive != "front-steered") {
    throw UsageError("--command ackermann needs --drive front-steered");
  }
}

}  // namespace

std::optional<Options> parse_options(int argc, const char* const* argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view option = argv[i];
    if (option == "--help") return std::nullopt;
    if (option == "--slip") {
      options.slip = true;
    } else if (option == "--clock") {
      options.simulated_clock = true;
    } else if (const auto reader = readers().find(option); reader == readers().end()) {
      throw UsageError("unknown option '" + std::string(option) + "'; --help lists them");
    } else if (++i == argc) {
      throw UsageError(std::string(option) + " needs a value");
    } else {
      reader->second(options, option, argv[i]);
    }
  }
  check(options);
  return options;
}

}  // namespace robots
