# The Python types, and beside them what publishes them, installed as share/lookout/python. They are part of build/python
# as well, see python/CMakeLists.txt.
set(python ${CMAKE_CURRENT_BINARY_DIR}/python)
set(python_files ${python}/lookout/__init__.py)
foreach(lcm_file IN LISTS lcm_files)
  get_filename_component(type ${lcm_file} NAME_WE)
  list(APPEND python_files ${python}/lookout/${type}.py)
endforeach()
add_custom_command(OUTPUT ${python_files} ${python}/lookout_link.py
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${python}/lookout
  COMMAND ${CMAKE_COMMAND} -E make_directory ${python}
  COMMAND ${LCM_GEN_EXECUTABLE} --python --ppath ${python} ${lcm_files}
  COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_CURRENT_SOURCE_DIR}/python/lookout_link.py ${python}
  DEPENDS ${lcm_files} ${CMAKE_CURRENT_SOURCE_DIR}/python/lookout_link.py VERBATIM)
set_property(GLOBAL PROPERTY LOOKOUT_PYTHON_TYPES ${python_files} ${python}/lookout_link.py)
add_custom_target(lookout_python_types ALL DEPENDS ${python_files} ${python}/lookout_link.py)
install(DIRECTORY ${python} DESTINATION ${CMAKE_INSTALL_DATADIR}/lookout FILES_MATCHING PATTERN "*.py")
