# Writes OUTPUT (version.cpp) with the present commit, only when it changed. Run at every build.
execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --dirty OUTPUT_VARIABLE commit
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT commit)
  set(commit "release ${RELEASE}")
endif()
string(CONCAT text "#include \"tools/cli/version.hpp\"\n\n"
            "std::string lookout::tools::release() { return \"${RELEASE}\"; }\n"
            "std::string lookout::tools::version() { return \"${commit}\"; }\n")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} before)
endif()
if(NOT "${before}" STREQUAL "${text}")
  file(WRITE ${OUTPUT} "${text}")
endif()
