# Builds the libraries that need nothing but a compiler (and Eigen) by CMake, for programs that build them with their own sources:
# add_subdirectory(orbicube/libs/trust_region), or FetchContent with SOURCE_SUBDIR libs. Each becomes a target orbicube::NAME, static or,
# with BUILD_SHARED_LIBS, shared. Meson builds, tests and installs everything else; sources are listed in its files, which are read here.
include_guard(GLOBAL)
# CMAKE_UNITY_BUILD is for the sources around: files of most libraries have local names in common.
option(ORBICUBE_UNITY_BUILD "compile each library as one file: trust_region and quaternion only" OFF)
get_filename_component(ORBICUBE_TREE "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)
set(ORBICUBE_TREE "${ORBICUBE_TREE}" CACHE INTERNAL "the tree of Orbicube")

# Sets `out` to the sources that libs/NAME/meson.build lists.
function(orbicube_sources name out)
  set(list "${ORBICUBE_TREE}/libs/${name}/meson.build")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${list}")
  file(READ "${list}" text)
  string(REGEX MATCHALL "\nlibrary_(sources|inner_loops) = files\\([^)]*\\)" calls "\n${text}")
  string(REGEX MATCHALL "'[^']+\\.cpp'" files "${calls}")
  if(NOT files)
    message(FATAL_ERROR "${list} lists no sources")
  endif()
  string(REPLACE "'" "" files "${files}")
  list(TRANSFORM files PREPEND "${ORBICUBE_TREE}/libs/${name}/")
  set(${out} ${files} PARENT_SCOPE)
endfunction()

# Declares compiled objects with the settings of all libraries.
function(orbicube_objects target)
  add_library(${target} OBJECT ${ARGN})
  target_compile_features(${target} PRIVATE cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
                        POSITION_INDEPENDENT_CODE ON UNITY_BUILD "${ORBICUBE_UNITY_BUILD}")
  target_include_directories(${target} PRIVATE "${ORBICUBE_TREE}" "${ORBICUBE_TREE}/libs" "${ORBICUBE_TREE}/capi/include")
  # Results must not depend on whether a compiler fuses a*b+c.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off>
                         $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi>)
endfunction()

# orbicube_library(NAME [USES A B ...] [EIGEN]): the target orbicube::NAME. Libraries that it uses are added where they are missing.
function(orbicube_library name)
  cmake_parse_arguments(PARSE_ARGV 1 of "EIGEN" "" "USES")
  if(TARGET orbicube_${name})
    return()
  endif()
  foreach(used IN LISTS of_USES)
    if(NOT TARGET orbicube_${used})
      add_subdirectory("${ORBICUBE_TREE}/libs/${used}" "${CMAKE_BINARY_DIR}/orbicube/${used}" EXCLUDE_FROM_ALL)
    endif()
  endforeach()
  find_package(Threads REQUIRED) # its target is not visible in other folders, so that the name of the library is taken
  orbicube_sources(${name} sources)
  orbicube_objects(orbicube_${name}_core ${sources})
  orbicube_objects(orbicube_${name}_entries "${ORBICUBE_TREE}/capi/src/${name}.cpp")
  if(of_EIGEN)
    find_package(Eigen3 3.4 REQUIRED NO_MODULE)
    foreach(part core entries)
      target_link_libraries(orbicube_${name}_${part} PRIVATE Eigen3::Eigen)
    endforeach()
  endif()
  set(objects $<TARGET_OBJECTS:orbicube_${name}_entries> $<TARGET_OBJECTS:orbicube_${name}_core>)
  if(BUILD_SHARED_LIBS) # with the C++ parts that it uses inside, and nothing but its C functions visible
    foreach(used IN LISTS of_USES)
      list(APPEND objects $<TARGET_OBJECTS:orbicube_${used}_core>)
    endforeach()
  endif()
  add_library(orbicube_${name} ${objects})
  add_library(orbicube::${name} ALIAS orbicube_${name})
  string(REPLACE "_" "-" dashed ${name})
  set_target_properties(orbicube_${name} PROPERTIES OUTPUT_NAME orbicube-${dashed} SOVERSION 0 LINKER_LANGUAGE CXX)
  target_include_directories(orbicube_${name} INTERFACE "${ORBICUBE_TREE}/capi/include" "${ORBICUBE_TREE}/bindings/cpp")
  list(TRANSFORM of_USES PREPEND orbicube_)
  target_link_libraries(orbicube_${name} PUBLIC ${of_USES} PRIVATE ${CMAKE_THREAD_LIBS_INIT})
  if(BUILD_SHARED_LIBS AND UNIX AND NOT APPLE)
    target_link_options(orbicube_${name} PRIVATE "-Wl,--version-script=${ORBICUBE_TREE}/capi/abi/${name}.map")
  endif()
endfunction()
