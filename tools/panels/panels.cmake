# lookout_spy.jar, the panels that lcm-spy opens on our channels; built wherever the jar of our types is.
if(TARGET lookout_java_types)
  file(GLOB panel_files CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.java)
  set(panel_classes ${CMAKE_CURRENT_BINARY_DIR}/panels)
  add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/lookout_spy.jar
    COMMAND ${CMAKE_COMMAND} -E make_directory ${panel_classes}
    COMMAND ${LOOKOUT_JAVAC} --release 17 -cp ${LCM_JAR}:${PROJECT_BINARY_DIR}/lookout_types.jar
            -d ${panel_classes} ${panel_files}
    COMMAND ${LOOKOUT_JAR} cf ${PROJECT_BINARY_DIR}/lookout_spy.jar -C ${panel_classes} .
    DEPENDS ${panel_files} ${PROJECT_BINARY_DIR}/lookout_types.jar VERBATIM)
  add_custom_target(lookout_panels ALL DEPENDS ${PROJECT_BINARY_DIR}/lookout_spy.jar)
  add_dependencies(lookout_panels lookout_java_types)
endif()
