# `cmake --install` and find_package(lookout).
include(CMakePackageConfigHelpers)
# What a plug-in of the program builds against: headers alone, as the program holds the libraries.
add_library(lookout_plugin INTERFACE)
add_library(lookout::plugin ALIAS lookout_plugin)
set_target_properties(lookout_plugin PROPERTIES EXPORT_NAME plugin)
target_compile_features(lookout_plugin INTERFACE cxx_std_20)
target_include_directories(lookout_plugin INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/lookout>)
target_link_libraries(lookout_plugin INTERFACE Eigen3::Eigen)
set_property(GLOBAL APPEND PROPERTY LOOKOUT_LIBRARIES lookout_plugin)
get_property(libraries GLOBAL PROPERTY LOOKOUT_LIBRARIES)
install(TARGETS ${libraries} EXPORT lookout_targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(folder core lcmtypes sonar_sim csht tracking fusion)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lookout
    FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(EXPORT lookout_targets NAMESPACE lookout:: FILE lookout_targets.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/lookout)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/lookout_config.cmake.in
  ${PROJECT_BINARY_DIR}/lookout-config.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/lookout)
# The build folder is found as well (HINTS build), with lookout::plugin alone: a plug-in needs no installation.
export(TARGETS lookout_plugin NAMESPACE lookout:: FILE ${PROJECT_BINARY_DIR}/lookout_targets.cmake)
configure_file(${CMAKE_CURRENT_LIST_DIR}/FindLCM.cmake ${PROJECT_BINARY_DIR}/FindLCM.cmake COPYONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lookout-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/lookout-config.cmake ${PROJECT_BINARY_DIR}/lookout-config-version.cmake
  ${PROJECT_SOURCE_DIR}/cmake/FindLCM.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/lookout)
