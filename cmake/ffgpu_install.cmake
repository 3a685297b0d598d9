# What `cmake --install` puts where. The drop-in libraries have the names of the system's, so that
# they go to a folder of their own, which only `ffgpu run` and the packages below know.
include(CMakePackageConfigHelpers)

set(FFGPU_PRIVATE_DIR ${CMAKE_INSTALL_LIBDIR}/ffgpu)
set(FFGPU_LIBRARY_DIR ${FFGPU_PRIVATE_DIR})
set(FFGPU_INCLUDE_DIR ${CMAKE_INSTALL_INCLUDEDIR})

install(TARGETS drop_in_GL drop_in_OSMesa LIBRARY DESTINATION ${FFGPU_PRIVATE_DIR})
foreach(alias libEGL.so.1 libGLX.so.0 libOpenGL.so.0)
  install(FILES ${PROJECT_BINARY_DIR}/driver/GL/${alias} DESTINATION ${FFGPU_PRIVATE_DIR})
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/driver/window_system/offscreen/osmesa.h
  ${PROJECT_SOURCE_DIR}/driver/ffgpu_texture_filter.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ffgpu)
# The library of texture techniques, for any OpenGL program.
install(TARGETS techniques ARCHIVE DESTINATION ${FFGPU_PRIVATE_DIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/techniques DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ffgpu
  FILES_MATCHING PATTERN "*.h")

configure_package_config_file(cmake/ffgpu-config.cmake.in ${PROJECT_BINARY_DIR}/ffgpu-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ffgpu
  PATH_VARS FFGPU_LIBRARY_DIR FFGPU_INCLUDE_DIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ffgpu-config-version.cmake
  COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ffgpu-config.cmake
  ${PROJECT_BINARY_DIR}/ffgpu-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ffgpu)

# pkg-config's file finds the rest from where it lies, so that an installation can be moved.
file(RELATIVE_PATH FFGPU_PC_TO_PREFIX
  ${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/ffgpu.pc.in ${PROJECT_BINARY_DIR}/ffgpu.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/ffgpu.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
