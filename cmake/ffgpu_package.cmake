# The Debian package that `cpack` makes (`./dev package`): what `cmake --install` installs, a trace
# to try it with, and the licence. The libraries that it needs are read from its programs.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/ffgpu
  RENAME copyright)
install(FILES ${PROJECT_SOURCE_DIR}/traces/corridor.trace
  DESTINATION ${CMAKE_INSTALL_DATADIR}/ffgpu/traces)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ffgpu)
set(CPACK_PACKAGE_CONTACT "The ffgpu authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "deterministic emulator of a fixed-function GPU")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "Draws OpenGL 1.5 programs and traces on a model of the classic graphics pipeline, and counts
 its cycles, cache misses and bytes.")
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Libraries for programs under ffgpu have the system's names, and are nobody's dependency.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/driver/GL)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS OFF)
set(CPACK_STRIP_FILES ON)
include(CPack)
