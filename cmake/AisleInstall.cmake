# find_package(aisle) for other projects: libraries, public headers, the program.
include(CMakePackageConfigHelpers)
get_property(modules GLOBAL PROPERTY AISLE_MODULES)
foreach(module IN LISTS modules)
  install(TARGETS aisle_${module} EXPORT aisle FILE_SET HEADERS)
endforeach()
install(TARGETS aisle)
install(DIRECTORY worlds vehicles scenarios DESTINATION ${CMAKE_INSTALL_DATADIR}/aisle)
# The live page, if scripts/web has built it.
install(DIRECTORY web/dist/ DESTINATION ${CMAKE_INSTALL_DATADIR}/aisle/web OPTIONAL)
install(EXPORT aisle NAMESPACE aisle:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/aisle FILE aisleTargets.cmake)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/aisleConfig.cmake.in ${PROJECT_BINARY_DIR}/aisleConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/aisle)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/aisleConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/FindOpenCV.cmake ${PROJECT_BINARY_DIR}/aisleConfig.cmake ${PROJECT_BINARY_DIR}/aisleConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/aisle)
