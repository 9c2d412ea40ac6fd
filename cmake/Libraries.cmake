# How the libraries are built: shared unless BUILD_SHARED_LIBS says otherwise, with the exported symbols only.
include(GNUInstallDirs)

function(filmsticking_hide_symbols target)
  set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# filmsticking_library(<target> EXPORT_NAME <name>): a library that is installed as filmsticking::<name>.
function(filmsticking_library target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" EXPORT_NAME "")
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${arg_EXPORT_NAME}
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}  # before 1.0 every minor version may differ
    INSTALL_RPATH "$ORIGIN")
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_options(${target} PRIVATE -Wl,--as-needed)
endfunction()
