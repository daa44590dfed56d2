# Debian packages of what is installed: scripts/package.
set(packages aisle libaisle-dev aisle-doc)
if(AISLE_PYTHON)
  list(APPEND packages python3-aisle)
endif()

# Whoever makes a package answers for it, as Debian's own tools ask.
set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
if(CPACK_PACKAGE_CONTACT MATCHES "^ |<>$")
  set(CPACK_PACKAGE_CONTACT "a local build of aisle <local.build@example.org>")
endif()
file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/packaging")
configure_file(packaging/changelog.in packaging/changelog.Debian @ONLY)
configure_file(CHANGELOG.md packaging/changelog COPYONLY)
foreach(file changelog changelog.Debian)
  execute_process(COMMAND gzip -9n INPUT_FILE "${PROJECT_BINARY_DIR}/packaging/${file}"
    OUTPUT_FILE "${PROJECT_BINARY_DIR}/packaging/${file}.gz" COMMAND_ERROR_IS_FATAL ANY)
endforeach()
foreach(package IN LISTS packages)
  install(FILES packaging/copyright "${PROJECT_BINARY_DIR}/packaging/changelog.gz" "${PROJECT_BINARY_DIR}/packaging/changelog.Debian.gz"
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${package})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL ${packages})
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_SOURCE_DIR}/out/packages")
set(CPACK_PACKAGE_NAME aisle)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "robot that learns the inside of a building and drives there")
set(CPACK_PACKAGE_VERSION "${AISLE_PACKAGE_VERSION}")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_AISLE_PACKAGE_NAME aisle)
set(CPACK_DEBIAN_AISLE_PACKAGE_SECTION science)
set(CPACK_DEBIAN_AISLE_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_AISLE_DESCRIPTION "Put a robot with a camera or a 2-D range scanner in an unknown building: aisle
explores it, comes home, and leaves a map to navigate with. Robots that speak
ROS 2 are driven without ROS installed; a simulator, worlds, vehicles and a
page for the browser come with it.")
# Live cameras are GStreamer's plugins, plans as PDF are read by pdftocairo; nothing else needs them.
set(CPACK_DEBIAN_AISLE_PACKAGE_SUGGESTS
  "aisle-doc, gstreamer1.0-plugins-base, gstreamer1.0-plugins-good, poppler-utils")

# What aisleConfig.cmake looks for: the libraries that building needs.
file(STRINGS scripts/packages.txt lines)
list(FIND lines "# libraries" first)
list(FIND lines "# tests and benchmarks" last)
math(EXPR first "${first} + 1")
math(EXPR count "${last} - ${first}")
list(SUBLIST lines ${first} ${count} libraries)
list(FILTER libraries INCLUDE REGEX "-dev$")
list(JOIN libraries ", " libraries)
set(CPACK_DEBIAN_LIBAISLE-DEV_PACKAGE_NAME libaisle-dev)
set(CPACK_DEBIAN_LIBAISLE-DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBAISLE-DEV_PACKAGE_DEPENDS "pkg-config, ${libraries}")
set(CPACK_COMPONENT_LIBAISLE-DEV_DESCRIPTION "The modules of aisle as static libraries, with their headers and a CMake
configuration: find_package(aisle). They map laser logs, explore, localise,
simulate and drive.")

# Worlds and vehicles come with the program; a compiled module fits one version of Python.
math(EXPR python_after "${Python_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON3-AISLE_PACKAGE_NAME python3-aisle)
set(CPACK_DEBIAN_PYTHON3-AISLE_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON3-AISLE_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON3-AISLE_PACKAGE_DEPENDS "aisle (= ${AISLE_PACKAGE_VERSION}-1), python3-numpy, \
python3 (>= 3.${Python_VERSION_MINOR}~), python3 (<< 3.${python_after})")
set(CPACK_COMPONENT_PYTHON3-AISLE_DESCRIPTION "The package aisle for Python: recordings, buildings and sessions as numpy
arrays; mapping, scan matching and detection; a simulated vehicle step by step;
navigators written in Python.")

set(CPACK_DEBIAN_AISLE-DOC_PACKAGE_NAME aisle-doc)
set(CPACK_DEBIAN_AISLE-DOC_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_AISLE-DOC_PACKAGE_ARCHITECTURE all)
set(CPACK_COMPONENT_AISLE-DOC_DESCRIPTION "Tutorials, how-to guides, reference and explanations of aisle, and the reports
of what was measured, as Markdown.")
include(CPack)
