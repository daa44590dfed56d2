#pragma once

#include <string>

/// "0.2.0": what clients and files are told.
std::string release();

/// "0.2.0 (commit e202d15373, Release, x86-64-v2)": what a report of a fault should say. The commit is the
/// one that the build was configured at, "unknown" where the sources came without git.
std::string version();
