#include "aisle/commands/learn.hpp"

#include "aisle/commands/method.hpp"
#include "aisle/commands/parameter_listing.hpp"

namespace aisle {

Outcome learn_parameters() {
  LearnParams params;
  return parameter_listing("learn", fields_of(params));
}

Result<Outcome> run_learn(const LearnOptions& options, Console& console) {
  const auto method = method_named(options.method, console);
  if (!method) return method.problems();
  LearnParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  if (options.sessions.size() > 1 && !(*method)->learns_from_several)
    return Problem{{options.sessions[1].string()},
                   "is one session too many: only --method sections learns from several"};
  return (*method)->learn(options, params, console);
}

}  // namespace aisle
