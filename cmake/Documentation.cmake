# `cmake --build . --target doc`: the reference of everything public, in doc/html.
find_program(DOXYGEN doxygen)
if(DOXYGEN)
  configure_file(cmake/Doxyfile.in Doxyfile @ONLY)
  add_custom_target(doc COMMAND ${DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile VERBATIM)
  if(FILMSTICKING_BUILD_TESTS)
    add_test(NAME doxygen COMMAND ${DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile)
  endif()
endif()
