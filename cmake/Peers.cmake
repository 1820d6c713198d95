# Collision libraries of others, as rows of `carom tunnel`: FCL and libccd, each where it is found. Their adapters are the
# library carom_peers, which the command line links and the core never sees; without a library a file that says so is
# compiled in its place.

set(carom_peer_sources)
set(carom_peer_libraries)
foreach(peer IN ITEMS fcl ccd)
  string(REPLACE "ccd" "libccd" name ${peer})
  if(CAROM_PEERS)
    find_package(${peer} QUIET)
  endif()
  if(CAROM_PEERS AND TARGET ${peer})
    message(STATUS "Peers: ${name} ${${peer}_VERSION}")
    list(APPEND carom_peer_sources ${PROJECT_SOURCE_DIR}/tools/peers/${name}.cpp)
    list(APPEND carom_peer_libraries ${peer})
  else()
    message(STATUS "Peers: no ${name} (its rows of carom tunnel are absent)")
    list(APPEND carom_peer_sources ${PROJECT_SOURCE_DIR}/tools/peers/${name}_absent.cpp)
  endif()
endforeach()

# FCL was built with Eigen's alignment of 16 bytes; the core's flags would turn it off, and types with matrices in them
# would have another layout. The core has no such types, so that nothing of carom's changes.
set_source_files_properties(${PROJECT_SOURCE_DIR}/tools/peers/fcl.cpp PROPERTIES COMPILE_DEFINITIONS EIGEN_MAX_STATIC_ALIGN_BYTES=16)
add_library(carom_peers STATIC ${carom_peer_sources})
carom_options(carom_peers)
target_include_directories(carom_peers PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(carom_peers PUBLIC carom_tunnel PRIVATE ${carom_peer_libraries})
