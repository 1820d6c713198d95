# cmake --install, and find_package(carom) for those who build on it.
#
# carom::carom is the core and needs Eigen alone. The components are there if they were built (CAROM_TOOLS):
# reference and study (which need mpfr and gmp), io (which needs fmt, SQLite and zlib, too).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(carom_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/carom)
set(carom_components)

# carom_install(TARGET NAME): TARGET of this build is carom::NAME for others, with its headers from include/carom.
function(carom_install target name)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(${target} PUBLIC cxx_std_20)
  install(TARGETS ${target} EXPORT carom_${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT carom_${name} NAMESPACE carom:: FILE carom_${name}.cmake DESTINATION ${carom_package_dir} COMPONENT development)
  foreach(header IN LISTS ARGN)
    install(FILES ${PROJECT_SOURCE_DIR}/include/carom/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/carom COMPONENT development)
  endforeach()
  if(NOT name STREQUAL "carom")
    set(carom_components ${carom_components} ${name} PARENT_SCOPE)
  endif()
endfunction()

# Whatever is no header of a component belongs to the core.
set(carom_study_headers metrics.hpp study.hpp)
set(carom_io_headers io.hpp)
file(GLOB carom_core_headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include/carom ${PROJECT_SOURCE_DIR}/include/carom/*.hpp)
list(REMOVE_ITEM carom_core_headers ${carom_study_headers} ${carom_io_headers})

carom_install(carom carom ${carom_core_headers})
if(CAROM_TOOLS)
  carom_install(carom_reference reference)
  carom_install(carom_study study ${carom_study_headers})
  carom_install(carom_tunnel tunnel)
  carom_install(carom_io io ${carom_io_headers})
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/caromConfig.cmake.in ${PROJECT_BINARY_DIR}/caromConfig.cmake
  INSTALL_DESTINATION ${carom_package_dir})
# Below 1.0 every minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/caromConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/caromConfig.cmake ${PROJECT_BINARY_DIR}/caromConfigVersion.cmake
  DESTINATION ${carom_package_dir} COMPONENT development)
