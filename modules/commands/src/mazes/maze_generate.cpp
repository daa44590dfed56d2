#include "aisle/commands/mazes/maze_generate.hpp"

#include <fmt/format.h>

#include "aisle/formats/mazes/maze_file.hpp"
#include "aisle/formats/whole_file.hpp"

namespace aisle {

Result<Outcome> run_maze_generate(const MazeGenerateOptions& options, Console&) {
  if (Problems problems = options.recipe.problems(); !problems.empty()) return problems;
  if (!options.out.empty() && !options.force && std::filesystem::exists(options.out)) {
    return Problem{{options.out.string()}, "exists already; --force replaces it"};
  }
  const MazeRecipe& recipe = options.recipe;
  const std::string maze = maze_text(generate_maze(recipe, Random(options.seed)));
  Outcome outcome{.verb = "maze generate"};
  outcome.figures = {{"kind", name_of(recipe.kind)},
                     {"width", recipe.width},
                     {"height", recipe.height},
                     {"seed", options.seed}};
  if (options.out.empty()) {
    outcome.figures["maze"] = maze;
    outcome.text = maze;
    return outcome;
  }
  if (Problems problems = write_whole_file(options.out, maze); !problems.empty()) return problems;
  outcome.files["maze"] = options.out.string();
  outcome.text = fmt::format("{}: {} maze of {} x {} cells\n", options.out.string(), name_of(recipe.kind),
                             recipe.width, recipe.height);
  return outcome;
}

}  // namespace aisle
