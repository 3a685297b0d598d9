# Toolchain: Debian's g++-aarch64-linux-gnu with the libraries of a root of Debian's arm64 packages
# (FFGPU_ARM64_ROOT), whose programs qemu-user runs. tests/determinism/aarch64.sh makes the root.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(FFGPU_ARM64_ROOT "" CACHE PATH "Root of arm64 packages")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES FFGPU_ARM64_ROOT)

set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_SYSROOT ${FFGPU_ARM64_ROOT})
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${FFGPU_ARM64_ROOT})
set(ENV{PKG_CONFIG_LIBDIR}
  ${FFGPU_ARM64_ROOT}/usr/lib/aarch64-linux-gnu/pkgconfig:${FFGPU_ARM64_ROOT}/usr/share/pkgconfig)
