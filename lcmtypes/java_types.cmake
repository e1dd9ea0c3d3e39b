# lookout_types.jar, by which lcm-spy decodes our channels; built wherever a Java compiler and LCM's jar are found.
find_program(LOOKOUT_JAVAC javac)
find_program(LOOKOUT_JAR jar)
mark_as_advanced(LOOKOUT_JAVAC LOOKOUT_JAR)
if(LOOKOUT_JAVAC AND LOOKOUT_JAR AND LCM_JAR)
  set(java ${CMAKE_CURRENT_BINARY_DIR}/java)
  list(TRANSFORM types PREPEND ${java}/lookout/ OUTPUT_VARIABLE java_files)
  list(TRANSFORM java_files APPEND .java)
  add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/lookout_types.jar
    COMMAND ${CMAKE_COMMAND} -E make_directory ${java}/classes
    COMMAND ${LCM_GEN_EXECUTABLE} --java --jpath ${java} ${lcm_files}
    COMMAND ${LOOKOUT_JAVAC} --release 11 -cp ${LCM_JAR} -d ${java}/classes ${java_files}
    COMMAND ${LOOKOUT_JAR} cf ${PROJECT_BINARY_DIR}/lookout_types.jar -C ${java}/classes .
    DEPENDS ${lcm_files} VERBATIM)
  add_custom_target(lookout_java_types ALL DEPENDS ${PROJECT_BINARY_DIR}/lookout_types.jar)
else()
  message(STATUS "No Java types jar: javac, jar or lcm.jar not found (tools/spy installs them)")
endif()
