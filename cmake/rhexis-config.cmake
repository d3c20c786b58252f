# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(rhexis) gives rhexis::kernel.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
find_dependency(Eigen3)
find_dependency(nlohmann_json)
find_dependency(OpenCV COMPONENTS core imgproc imgcodecs videoio)
find_dependency(PkgConfig)
pkg_check_modules(EGL REQUIRED QUIET IMPORTED_TARGET egl)
pkg_check_modules(EPOXY REQUIRED QUIET IMPORTED_TARGET epoxy)
pkg_check_modules(MD REQUIRED QUIET IMPORTED_TARGET libmd)
include(${CMAKE_CURRENT_LIST_DIR}/rhexis-targets.cmake)
