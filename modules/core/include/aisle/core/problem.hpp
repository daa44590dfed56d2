#pragma once

#include <string>
#include <vector>

namespace aisle {

/// A place in the user's input. Empty parts are not printed.
struct Place {
  std::string file = {};
  long line = 0;  ///< 1-based; 0: the file as a whole
  std::string key = {};
};

/// One thing that is wrong with an input: where, what, and (in the same sentence) what would be right.
struct Problem {
  Place where;
  std::string what;
};

using Problems = std::vector<Problem>;

/// "file:line: key"; empty if the place is not known.
std::string to_string(const Place& place);

/// The same problems, located in a file.
Problems at_file(Problems problems, const std::string& file);

/// "file:line: key: what"
std::string to_string(const Problem& problem);

/// One problem a line, the last without a line end.
std::string to_string(const Problems& problems);

}  // namespace aisle
