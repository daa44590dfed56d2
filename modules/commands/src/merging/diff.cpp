#include "aisle/commands/diff.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/commands/output_directory.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/merging/building_changes.hpp"
#include "aisle/report/changes_picture.hpp"
#include "merging/changes_figures.hpp"
#include "merging/comparable_map.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

Json figures_of(const MapAlignment& alignment, const BuildingChanges& changes) {
  Json figures = {{"alignment", alignment_json(alignment)}};
  figures.update(changes_json(changes));
  return figures;
}

std::string alignment_text(const MapAlignment& alignment) {
  const MapPlacement& best = alignment.best();
  const Pose2& T = best.T_fixed_moved;
  return fmt::format(
      "the new map lies at {:.2f}, {:.2f} m, {:.1f} degrees in the old one, known to {:.1f} cm and {:.2f} "
      "degrees: {}\n",
      T.x, T.y, to_degrees(T.theta), 100 * best.sigma_m(), to_degrees(best.sigma_rad()),
      reason_of(alignment));
}

Outcome refusal(const MapAlignment& alignment) {
  Outcome outcome{.verb = "diff", .ok = false};
  outcome.figures = {{"alignment", alignment_json(alignment)}};
  outcome.text = fmt::format("not compared: {}\n", reason_of(alignment));
  return outcome;
}

}  // namespace

Outcome diff_parameters() {
  MapAlignmentParams params;
  return parameter_listing("diff", fields_of(params));
}

Result<Outcome> run_diff(const DiffOptions& options, Console& console) {
  MapAlignmentParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  const auto old_map = read_comparable_map(options.old_building, console);
  if (!old_map) return old_map.problems();
  const auto new_map = read_comparable_map(options.new_building, console);
  if (!new_map) return new_map.problems();
  const auto directory =
      OutputDirectory::open_if_named(options.out, options.force, {"changes.svg", "changes.png"});
  if (!directory) return directory.problems();

  console.progress.report("laying the maps onto each other", 0, 1);
  const MapAlignment alignment = align_maps(MapPattern(*old_map), MapPattern(*new_map), params);
  if (!alignment.is_found()) return refusal(alignment);
  const BuildingChanges changes = changes_between(*old_map, *new_map, alignment.best().T_fixed_moved);

  Outcome outcome{.verb = "diff"};
  outcome.figures = figures_of(alignment, changes);
  outcome.text = alignment_text(alignment) + changes_text(outcome.figures);
  if (!*directory) return outcome;
  const ChangesPicture picture{changes, fmt::format("{}: what has changed", old_map->name),
                               changes_caption(outcome.figures)};
  auto written = (*directory)
                     ->write({{"picture_svg", "changes.svg", svg(picture)},
                              {"picture_png", "changes.png", png(picture)}});
  if (!written) return written.problems();
  outcome.files = std::move(*written);
  outcome.text += fmt::format("see {}\n", outcome.files["picture_png"]);
  return outcome;
}

}  // namespace aisle
