# What is installed, by the Debian package that it belongs to: aisle, libaisle-dev (find_package(aisle) for other
# projects), python3-aisle and aisle-doc.
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME aisle)
install(TARGETS aisle)
install(DIRECTORY worlds vehicles scenarios DESTINATION ${CMAKE_INSTALL_DATADIR}/aisle)
# The live page, if scripts/web has built it.
install(DIRECTORY web/dist/ DESTINATION ${CMAKE_INSTALL_DATADIR}/aisle/web OPTIONAL)
install(DIRECTORY ${PROJECT_BINARY_DIR}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} OPTIONAL)
install(FILES packaging/aisle.service DESTINATION lib/systemd/system)
install(FILES packaging/completion.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME aisle)
install(FILES packaging/completion.zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions RENAME _aisle)
install(FILES packaging/completion.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d RENAME aisle.fish)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME libaisle-dev)
get_property(modules GLOBAL PROPERTY AISLE_MODULES)
foreach(module IN LISTS modules)
  install(TARGETS aisle_${module} EXPORT aisle FILE_SET HEADERS)
endforeach()
set(config ${CMAKE_INSTALL_LIBDIR}/cmake/aisle)
install(EXPORT aisle NAMESPACE aisle:: DESTINATION ${config} FILE aisleTargets.cmake)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/aisleConfig.cmake.in ${PROJECT_BINARY_DIR}/aisleConfig.cmake
  INSTALL_DESTINATION ${config})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/aisleConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/FindOpenCV.cmake ${PROJECT_BINARY_DIR}/aisleConfig.cmake ${PROJECT_BINARY_DIR}/aisleConfigVersion.cmake
  DESTINATION ${config})

if(AISLE_PYTHON)
  set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME python3-aisle)
  install(DIRECTORY python/aisle DESTINATION lib/python3/dist-packages
    FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN py.typed PATTERN __pycache__ EXCLUDE)
  install(TARGETS aisle_python DESTINATION lib/python3/dist-packages/aisle)
endif()

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME aisle-doc)
# As in the sources, so that the links from page to page lead somewhere.
set(pages ${CMAKE_INSTALL_DATADIR}/doc/aisle-doc)
install(FILES README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md DESTINATION ${pages})
install(DIRECTORY docs DESTINATION ${pages} PATTERN site EXCLUDE)
install(DIRECTORY benchmarks/reports DESTINATION ${pages}/benchmarks)
install(DIRECTORY examples DESTINATION ${pages})
