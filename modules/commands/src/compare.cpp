#include "aisle/commands/compare.hpp"

#include <fmt/format.h>

#include "aisle/commands/output_directory.hpp"
#include "aisle/core/angle.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/evaluation/trajectory_error.hpp"
#include "aisle/formats/logs/read_poses.hpp"
#include "aisle/report/trajectory_picture.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

Json spread_json(const ErrorSpread& spread, double unit) {
  return {{"mean", rounded(spread.mean / unit, 5)},
          {"rms", rounded(spread.rms / unit, 5)},
          {"max", rounded(spread.max / unit, 5)}};
}

Json comparison_figures(const TrajectoryError& error) {
  return {{"compared", error.compared},
          {"without_truth", error.without_truth},
          {"position_m", spread_json(error.position_m, 1)},
          {"heading_deg", spread_json(error.heading_rad, kDegree)},
          {"step_m", error.step_m},
          {"relative_position_m", spread_json(error.relative_position_m, 1)},
          {"relative_heading_deg", spread_json(error.relative_heading_rad, kDegree)},
          {"heading_offset_deg", rounded(error.heading_offset_rad / kDegree, 3)}};
}

std::string spread_text(const ErrorSpread& m, const ErrorSpread& rad) {
  return fmt::format("{:.4f} m rms, {:.4f} m at worst; {:.3f} deg rms, {:.3f} deg at worst", m.rms, m.max,
                     rad.rms / kDegree, rad.max / kDegree);
}

}  // namespace

Result<Outcome> run_compare(const CompareOptions& options, Console& console) {
  const auto trajectory = read_poses(options.trajectory);
  if (!trajectory) return trajectory.problems();
  const auto truth = read_poses(options.truth, options.topic);
  if (!truth) return truth.problems();
  const auto error = trajectory_error(*trajectory, *truth, options.step_m);
  if (!error) return Problem{{options.truth.string()}, error.problems().front().what};
  const auto directory =
      OutputDirectory::open_if_named(options.out, options.force, {"compared.svg", "compared.png"});
  if (!directory) return directory.problems();

  Problems warnings;
  if (error->without_truth > 0)
    warnings.push_back({{options.truth.string()},
                        fmt::format("has no true pose near {} of {} poses, which are not compared",
                                    error->without_truth, error->without_truth + error->compared)});
  warn_of(warnings, console);
  Outcome outcome{.verb = "compare", .figures = comparison_figures(*error)};
  outcome.figures["warnings"] = warnings_json(warnings);
  const std::string absolute = spread_text(error->position_m, error->heading_rad);
  outcome.text = fmt::format("{} poses against the truth, aligned: {}\nover {:g} m of path: {}\n",
                             error->compared, absolute, options.step_m,
                             spread_text(error->relative_position_m, error->relative_heading_rad));
  if (*directory) {
    const TrajectoryPicture picture{error->T_truth_vehicle, error->T_truth_true,
                                    options.trajectory.filename().string(), absolute};
    auto written = (*directory)
                       ->write({{"picture_svg", "compared.svg", svg(picture)},
                                {"picture_png", "compared.png", png(picture)}});
    if (!written) return written.problems();
    outcome.files = std::move(*written);
    outcome.text += fmt::format("see {}\n", outcome.files["picture_png"]);
  }
  return outcome;
}

}  // namespace aisle
