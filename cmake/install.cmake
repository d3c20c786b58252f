# SPDX-License-Identifier: GPL-3.0-or-later
# `cmake --install` puts the kernel where find_package(rhexis) finds it as rhexis::kernel, and the command line with the
# scripts it needs.
include(CMakePackageConfigHelpers)

get_property(kernel_targets GLOBAL PROPERTY RHEXIS_KERNEL_TARGETS)
add_library(rhexis_kernel INTERFACE)
set_target_properties(rhexis_kernel PROPERTIES EXPORT_NAME kernel)
target_compile_features(rhexis_kernel INTERFACE cxx_std_20)
target_link_libraries(rhexis_kernel INTERFACE ${kernel_targets})
add_library(rhexis::kernel ALIAS rhexis_kernel)

install(TARGETS rhexis_kernel rhexis_cholmod rhexis_igtl ${kernel_targets} EXPORT rhexis-targets)
install(EXPORT rhexis-targets NAMESPACE rhexis:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rhexis)
install(DIRECTORY kernel/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/rhexis FILES_MATCHING PATTERN "*.hpp" PATTERN tracking EXCLUDE)
install(FILES cmake/rhexis-config.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rhexis)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/rhexis-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/rhexis-config-version.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rhexis)

install(DIRECTORY scripts curricula courses rubrics assets DESTINATION ${CMAKE_INSTALL_DATADIR}/rhexis)
if(TARGET rhexis)
  install(TARGETS rhexis RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  get_property(loaded GLOBAL PROPERTY RHEXIS_LOADED)
  install(TARGETS ${loaded} LIBRARY DESTINATION lib/rhexis)
endif()
