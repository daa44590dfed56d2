# Which commit this is, and of when: for `aisle --version` and the packages. Sources without git know neither.
set(AISLE_COMMIT "")
set(AISLE_PACKAGE_VERSION "${PROJECT_VERSION}")
find_package(Git QUIET)
# The folder above may be a repository of something else.
if(Git_FOUND AND EXISTS "${PROJECT_SOURCE_DIR}/.git")
  execute_process(COMMAND "${GIT_EXECUTABLE}" log -1 --format=%h --abbrev=10 WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
    OUTPUT_VARIABLE AISLE_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(AISLE_COMMIT)
  execute_process(COMMAND "${GIT_EXECUTABLE}" log -1 --format=%ct WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
    OUTPUT_VARIABLE committed_s OUTPUT_STRIP_TRAILING_WHITESPACE)
  # With the next commit it is configured again: no build carries the name of an earlier one.
  execute_process(COMMAND "${GIT_EXECUTABLE}" rev-parse --git-path logs/HEAD WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
    OUTPUT_VARIABLE commits OUTPUT_STRIP_TRAILING_WHITESPACE)
  get_filename_component(commits "${commits}" ABSOLUTE BASE_DIR "${PROJECT_SOURCE_DIR}")
  if(EXISTS "${commits}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${commits}")
  endif()
  set(ENV{SOURCE_DATE_EPOCH} ${committed_s})
endif()
string(TIMESTAMP AISLE_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
string(TIMESTAMP minute "%Y%m%d%H%M" UTC)
unset(ENV{SOURCE_DATE_EPOCH})
# A package of what is not released yet comes before the release, and after those of earlier commits.
file(STRINGS CHANGELOG.md unreleased REGEX "^## ${PROJECT_VERSION} .*unreleased")
if(unreleased)
  string(APPEND AISLE_PACKAGE_VERSION "~${minute}")
endif()
