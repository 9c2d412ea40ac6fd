# What `cmake --install` and `cpack` put where. The installed tree may be moved as a whole.
include(CMakePackageConfigHelpers)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/FilmstickingPP)
set(components core)
if(TARGET filmsticking_pcl)
  list(APPEND components pcl)
endif()

get_property(pc_lz4 GLOBAL PROPERTY FILMSTICKING_LZ4_FLAGS)
foreach(component ${components})
  install(TARGETS filmsticking_${component} EXPORT FilmstickingPP_${component}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libraries NAMELINK_COMPONENT development
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT FilmstickingPP_${component} DESTINATION ${config_dir} COMPONENT development
    NAMESPACE filmsticking:: FILE FilmstickingPP_${component}.cmake)
  file(RELATIVE_PATH pc_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)  # from the folder of the .pc file
  string(REGEX REPLACE "/$" "" pc_to_prefix ${pc_to_prefix})
  configure_file(cmake/filmsticking_${component}.pc.in filmsticking_${component}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/filmsticking_${component}.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endforeach()

install(DIRECTORY include/filmsticking DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
if(pcl IN_LIST components)
  install(DIRECTORY include/pcl DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
endif()

configure_package_config_file(cmake/FilmstickingPPConfig.cmake.in FilmstickingPPConfig.cmake
  INSTALL_DESTINATION ${config_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(FilmstickingPPConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/FilmstickingPPConfig.cmake ${PROJECT_BINARY_DIR}/FilmstickingPPConfigVersion.cmake
  DESTINATION ${config_dir} COMPONENT development)

# The package of ROS: as roslaunch finds it, and with paths as in the sources.
set(ros_share ${CMAKE_INSTALL_DATADIR}/filmsticking_pp)
if(TARGET filmsticking_node)
  set(ros_lib lib/filmsticking_pp)
  file(RELATIVE_PATH node_to_lib /${ros_lib} /${CMAKE_INSTALL_LIBDIR})
  set_target_properties(filmsticking_node PROPERTIES INSTALL_RPATH "$ORIGIN/${node_to_lib}")
  install(TARGETS filmsticking_node DESTINATION ${ros_lib} COMPONENT ros)
  # Elsewhere than in the folder of package.xml, roslaunch looks in catkin's workspaces only.
  file(RELATIVE_PATH share_to_node /${ros_share} /${ros_lib}/filmsticking_node)
  file(CREATE_LINK ${share_to_node} ${PROJECT_BINARY_DIR}/filmsticking_node SYMBOLIC)
  install(FILES ${PROJECT_BINARY_DIR}/filmsticking_node DESTINATION ${ros_share} COMPONENT ros)
  install(DIRECTORY launch DESTINATION ${ros_share} COMPONENT ros
    PATTERN README.md EXCLUDE PATTERN rviz.png EXCLUDE)
  install(FILES tests/data/spot_10k.pcd DESTINATION ${ros_share}/tests/data COMPONENT ros)
  install(FILES package.xml DESTINATION ${ros_share} COMPONENT ros)
else()
  install(FILES package.xml DESTINATION ${ros_share} COMPONENT development)
endif()

foreach(program pcd_to_mesh capture_to_mesh mesh_snapshot mesh_view mesh_report)
  if(TARGET ${program})
    file(RELATIVE_PATH bin_to_lib /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
    set_target_properties(${program} PROPERTIES INSTALL_RPATH "$ORIGIN/${bin_to_lib}")
    install(TARGETS ${program} DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
  endif()
endforeach()

# The Python package. Python looks in folders that depend on the prefix; elsewhere PYTHONPATH must name it.
if(TARGET filmsticking_python)
  set(FILMSTICKING_PYTHON_DIR "" CACHE STRING "Folder of Python packages below the prefix; empty: Debian's")
  get_property(python_sources GLOBAL PROPERTY FILMSTICKING_PYTHON_SOURCES)
  get_property(python_version GLOBAL PROPERTY FILMSTICKING_PYTHON_VERSION)
  set(python_dir "\${filmsticking_python_dir}/filmsticking")
  install(CODE "
    set(filmsticking_python_dir \"${FILMSTICKING_PYTHON_DIR}\")
    if(NOT filmsticking_python_dir AND CMAKE_INSTALL_PREFIX STREQUAL \"/usr/local\")
      set(filmsticking_python_dir lib/python${python_version}/dist-packages)
    elseif(NOT filmsticking_python_dir)
      set(filmsticking_python_dir lib/python3/dist-packages)
    endif()" COMPONENT python)
  install(TARGETS filmsticking_python LIBRARY DESTINATION ${python_dir} COMPONENT python)
  install(FILES ${python_sources} DESTINATION ${python_dir} COMPONENT python)
endif()

# Debian packages, as Debian splits them: cpack -G DEB
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME filmsticking-pp)
set(CPACK_PACKAGE_CONTACT "FilmstickingPP maintainers <maintainers@filmsticking-pp.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_COMPONENTS_ALL libraries development)
if(TARGET pcd_to_mesh)
  list(APPEND CPACK_COMPONENTS_ALL programs)
endif()
if(TARGET filmsticking_node)
  list(APPEND CPACK_COMPONENTS_ALL ros)
endif()
if(TARGET filmsticking_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_COMPONENT_DEVELOPMENT_DEPENDS libraries)
set(CPACK_COMPONENT_PROGRAMS_DEPENDS libraries)

set(CPACK_DEBIAN_LIBRARIES_PACKAGE_NAME
  libfilmsticking${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SECTION libs)
set(CPACK_COMPONENT_LIBRARIES_DESCRIPTION "The libraries.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libfilmsticking-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Headers, CMake package and pkg-config files.")
if(pcl IN_LIST components)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libpcl-dev (>= 1.12)")
endif()
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME filmsticking-tools)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION science)
set(CPACK_COMPONENT_PROGRAMS_DESCRIPTION "The command-line programs.")
set(CPACK_COMPONENT_ROS_DEPENDS libraries)
set(CPACK_DEBIAN_ROS_PACKAGE_NAME ros-filmsticking-pp)
set(CPACK_DEBIAN_ROS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_ROS_PACKAGE_RECOMMENDS
  "python3-roslaunch, libpcl-ros-dev, pcl-ros-tools, python3-rosbag, rviz")
set(CPACK_COMPONENT_ROS_DESCRIPTION "The node for ROS 1 and its launch files.")
set(CPACK_COMPONENT_PYTHON_DEPENDS libraries)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-filmsticking)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
# The module fits one minor version of Python only.
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "python3 (>= ${python_version}), python3 (<< ${python_version}.99), python3-numpy")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "The Python module.")

foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} upper)
  install(FILES LICENSE DESTINATION share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}
    RENAME copyright COMPONENT ${component})
endforeach()
include(CPack)
