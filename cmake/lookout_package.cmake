# `cpack` in the build folder makes the vehicle's .deb: the program, its systemd unit and its documents; no Java, no
# GUI, no development files. Debian's own tool finds the libraries that it depends on. Where the Python package was built
# it is a .deb of its own, which needs no program.
set(documents ${CMAKE_INSTALL_DATADIR}/doc/lookout)
# One unit for a vehicle without a channel prefix, and one for each instance: lookout-track@AUV1 hears AUV1_SONAR_SCAN.
set(LOOKOUT_UNIT_USE "The on-vehicle process. Enable with: systemctl enable --now lookout-track")
set(LOOKOUT_UNIT_SETTINGS "/etc/default/lookout")
set(LOOKOUT_UNIT_OF "")
set(LOOKOUT_UNIT_STATE track)
set(LOOKOUT_UNIT_FILES "EnvironmentFile=-/etc/default/lookout")
set(LOOKOUT_UNIT_ARGUMENTS "")
configure_file(${CMAKE_CURRENT_LIST_DIR}/packaging/lookout-track.service.in
  ${PROJECT_BINARY_DIR}/packaging/lookout-track.service @ONLY)
set(LOOKOUT_UNIT_USE "The on-vehicle process of one instance. Enable with: systemctl enable --now lookout-track@AUV1")
set(LOOKOUT_UNIT_SETTINGS "/etc/default/lookout-INSTANCE")
set(LOOKOUT_UNIT_OF " of %i")
set(LOOKOUT_UNIT_STATE %i)
set(LOOKOUT_UNIT_FILES "EnvironmentFile=-/etc/default/lookout-%i")
set(LOOKOUT_UNIT_ARGUMENTS " --channel-prefix %i_")
configure_file(${CMAKE_CURRENT_LIST_DIR}/packaging/lookout-track.service.in
  ${PROJECT_BINARY_DIR}/packaging/lookout-track@.service @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/packaging/lookout-track.service
  ${PROJECT_BINARY_DIR}/packaging/lookout-track@.service DESTINATION lib/systemd/system COMPONENT vehicle)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/packaging/lookout.default ${CMAKE_CURRENT_LIST_DIR}/packaging/lookout.nft
  ${PROJECT_SOURCE_DIR}/README.md
  DESTINATION ${documents} COMPONENT vehicle)

# Debian's form of the licence: each line indented, empty ones as a dot.
file(STRINGS ${PROJECT_SOURCE_DIR}/LICENSE license_lines)
foreach(line IN LISTS license_lines)
  if(line MATCHES "^Copyright \\(c\\) (.*)$" AND NOT LOOKOUT_COPYRIGHT)
    set(LOOKOUT_COPYRIGHT "${CMAKE_MATCH_1}")
  endif()
  if(line STREQUAL "")
    string(APPEND LOOKOUT_LICENSE_TEXT " .\n")
  else()
    string(APPEND LOOKOUT_LICENSE_TEXT " ${line}\n")
  endif()
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/packaging/copyright.in ${PROJECT_BINARY_DIR}/packaging/copyright @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/packaging/copyright DESTINATION ${documents} COMPONENT vehicle)

get_property(has_python GLOBAL PROPERTY LOOKOUT_HAS_PYTHON)
if(has_python)
  set(python_documents ${CMAKE_INSTALL_DATADIR}/doc/python3-lookout)
  install(FILES ${PROJECT_BINARY_DIR}/packaging/copyright DESTINATION ${python_documents} COMPONENT python)
  install(FILES ${PROJECT_SOURCE_DIR}/docs/python.md DESTINATION ${python_documents} COMPONENT python)
  install(PROGRAMS ${PROJECT_SOURCE_DIR}/examples/figure22.py DESTINATION ${python_documents}/examples COMPONENT python)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL vehicle)
if(has_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-lookout)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION
    "The tracker, its simulator and its metrics as a Python package on numpy arrays,
with readers and writers of recordings and LCM logs and the types of the messages.
This package holds the module `lookout` for Debian's python3.")
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_VEHICLE_PACKAGE_NAME lookout)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The Lookout maintainers <lookout@localhost>")
set(CPACK_COMPONENT_VEHICLE_DESCRIPTION
  "Takes the returns of a multi-beam forward-looking sonar over LCM and publishes,
every scan, how many targets move around the vehicle, where, and how fast.
This package holds the on-vehicle program and its systemd unit.")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
if(CMAKE_CROSSCOMPILING)  # Debian's tool looks among the packages of this machine; tools/package says what it found there.
  set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE arm64)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "${LOOKOUT_PACKAGE_DEPENDS}")
else()
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
endif()
include(CPack)
