# Compiler settings that every target of the project shares.
find_program(STURM_CCACHE ccache)
if(STURM_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Without these two ccache passes by what is compiled with a precompiled header.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${STURM_CCACHE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fpch-preprocess)
  endif()
endif()
# GCC looks for memory to free less often: a tenth to a fifth of the time of large units, for up to a fifth more memory (app: 0.94 GB in place of 0.79).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(--param=ggc-min-heapsize=700000)
endif()
find_program(STURM_MOLD mold)
if(STURM_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

# Eigen's alignment would depend on the instruction set that a user of the library compiles for.
add_library(sturm_eigen INTERFACE)
target_link_libraries(sturm_eigen INTERFACE Eigen3::Eigen)
target_compile_definitions(sturm_eigen INTERFACE EIGEN_MAX_ALIGN_BYTES=16)

add_library(sturm_options INTERFACE)
# GCC 12 reports -Wrestrict for correct std::string code (GCC bug 105651).
# No fused multiply-adds behind our back: the same bits with and without STURM_NATIVE wherever only our code computes.
target_compile_options(sturm_options INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(sturm_options INTERFACE -Wno-restrict)
endif()
if(STURM_UNITY)
  # A local name may be one that another file of the folder keeps to itself.
  target_compile_options(sturm_options INTERFACE -Wno-shadow)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # What is in a nameless namespace of an included file is no mistake there.
    target_compile_options(sturm_options INTERFACE -Wshadow=local -Wno-subobject-linkage)
  endif()
endif()
target_compile_options(sturm_options INTERFACE -ffp-contract=off)
if(STURM_WARNINGS_AS_ERRORS)
  target_compile_options(sturm_options INTERFACE -Werror)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC 12 sees writes beyond the end in its own std::string (GCC bug 105329), and uninitialised parts of Eigen's decompositions and of its own
    # vector intrinsics. Clang's warnings of this kind stay on.
    target_compile_options(sturm_options INTERFACE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread -Wno-maybe-uninitialized -Wno-uninitialized)
  endif()
endif()
if(STURM_NATIVE)
  target_compile_options(sturm_options INTERFACE -march=native -mprefer-vector-width=512)
endif()
if(STURM_SANITIZE)
  target_compile_options(sturm_options INTERFACE -fsanitize=${STURM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(sturm_options INTERFACE -fsanitize=${STURM_SANITIZE})
endif()

# Most of a compilation is the same few headers and the optimisation of code that runs once. So headers are compiled beforehand, and code that
# moves text and JSON about (KIND text) is optimised lightly; numbers come out the same, as neither level may reorder floating point.
# In code that computes (KIND numeric), nobody reads errno or the floating-point flags; without these the square roots branch and loops with divisions
# stay scalar. No result changes. It does without JSON's header, whose templates every unit compiles again, used or not.
set(sturm_text_options -O1)
set(sturm_numeric_options -fno-math-errno -fno-trapping-math)
set(sturm_numeric_headers <algorithm> <array> <cmath> <filesystem> <functional> <map> <optional> <span> <string> <vector> <Eigen/Core> <Eigen/Geometry>)
set(sturm_text_headers ${sturm_numeric_headers} <nlohmann/json.hpp>)

# sturm_precompiled_headers(TARGET KIND [HEADER...]): the target is compiled as code of its KIND and sees the headers of that kind as precompiled. They
# are compiled once for all targets, and once more, together with its own, for a target that names further headers.
function(sturm_precompiled_headers target kind)
  target_compile_options(${target} PRIVATE ${sturm_${kind}_options})
  if(ARGN)
    target_precompile_headers(${target} PRIVATE ${sturm_${kind}_headers} ${ARGN})
    return()
  endif()
  if(NOT TARGET sturm_precompiled_${kind})
    set(source ${PROJECT_BINARY_DIR}/generated/precompiled_${kind}.cpp)
    file(GENERATE OUTPUT ${source} CONTENT "// Carries the precompiled headers.\n")
    add_library(sturm_precompiled_${kind} OBJECT ${source})
    target_link_libraries(sturm_precompiled_${kind} PRIVATE sturm_options sturm_eigen nlohmann_json::nlohmann_json)
    target_compile_options(sturm_precompiled_${kind} PRIVATE ${sturm_${kind}_options})
    target_precompile_headers(sturm_precompiled_${kind} PRIVATE ${sturm_${kind}_headers})
  endif()
  target_precompile_headers(${target} REUSE_FROM sturm_precompiled_${kind})
endfunction()

# sturm_unity_by_folder(TARGET LEAST MOST SOURCE...): with STURM_UNITY the sources of a folder are compiled as one, MOST at a time; those of a folder that has
# fewer than LEAST, with the sources of the folder above. So what a folder keeps to itself in nameless namespaces has different names in its files, and
# a new file changes no other folder's unit. Code that computes stays with its folder: what is inlined depends on what else is in the unit.
set(sturm_text_least 5)
set(sturm_numeric_least 1)
set(sturm_most 10)
function(sturm_unity_by_folder target least most)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${STURM_UNITY} UNITY_BUILD_MODE GROUP)
  set(folders ${ARGN})
  list(TRANSFORM folders REPLACE "/[^/]*$" "")
  foreach(source folder IN ZIP_LISTS ARGN folders)
    set(elsewhere ${folders})
    list(REMOVE_ITEM elsewhere ${folder})
    list(LENGTH folders here)
    list(LENGTH elsewhere there)
    math(EXPR here "${here} - ${there}")
    if(here LESS least AND NOT folder STREQUAL CMAKE_CURRENT_SOURCE_DIR)
      get_filename_component(folder ${folder} DIRECTORY)
    endif()
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
    string(MAKE_C_IDENTIFIER "${folder}" group)
    if(NOT DEFINED sources_of_${group})
      set(sources_of_${group} 0)
    endif()
    math(EXPR unit "${sources_of_${group}} / ${most}")
    math(EXPR sources_of_${group} "${sources_of_${group}} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group}_${unit})
  endforeach()
endfunction()

# sturm_module(NAME [EXCLUDE pattern] [NUMERIC pattern] [TEXT] [HEADERS header...] [MOST number] DEPENDS target... [PRIVATE target...]): one library per folder,
# made of all its .cpp files but main.cpp and those whose path matches EXCLUDE. Sources are listed by the folder itself: one concept, one .cpp; a new file
# needs no edit here. A module is numeric unless it is TEXT; of a TEXT module the files that match NUMERIC are. HEADERS are precompiled besides the
# common ones. MOST sources of text are compiled as one, in place of ten.
function(sturm_module name)
  cmake_parse_arguments(ARG "TEXT" "EXCLUDE;NUMERIC;MOST" "DEPENDS;PRIVATE;HEADERS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  if(ARG_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX "${ARG_EXCLUDE}")
  endif()
  set(numeric_sources "")
  set(text_sources "")
  string(LENGTH ${CMAKE_CURRENT_SOURCE_DIR} above)  # what the folders above the module are called does not count
  foreach(source ${sources})
    string(SUBSTRING ${source} ${above} -1 below)
    if(ARG_TEXT AND NOT (ARG_NUMERIC AND below MATCHES "${ARG_NUMERIC}"))
      list(APPEND text_sources ${source})
    else()
      list(APPEND numeric_sources ${source})
    endif()
  endforeach()
  add_library(sturm_${name} STATIC)
  add_library(sturm::${name} ALIAS sturm_${name})
  set_target_properties(sturm_${name} PROPERTIES EXPORT_NAME ${name} LINKER_LANGUAGE CXX)
  target_include_directories(sturm_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(sturm_${name} PUBLIC cxx_std_20)
  target_link_libraries(sturm_${name} PUBLIC ${ARG_DEPENDS} PRIVATE $<BUILD_INTERFACE:sturm_options> ${ARG_PRIVATE})
  foreach(kind text numeric)
    if(${kind}_sources)
      add_library(sturm_${name}_${kind} OBJECT ${${kind}_sources})
      target_link_libraries(sturm_${name}_${kind} PRIVATE ${ARG_DEPENDS} sturm_options sturm_eigen nlohmann_json::nlohmann_json ${ARG_PRIVATE})
      target_include_directories(sturm_${name}_${kind} PRIVATE ${PROJECT_SOURCE_DIR})
      sturm_precompiled_headers(sturm_${name}_${kind} ${kind} ${ARG_HEADERS})
      if(ARG_MOST AND kind STREQUAL text)
        set(most ${ARG_MOST})
      else()
        set(most ${sturm_most})
      endif()
      sturm_unity_by_folder(sturm_${name}_${kind} ${sturm_${kind}_least} ${most} ${${kind}_sources})
      target_sources(sturm_${name} PRIVATE $<TARGET_OBJECTS:sturm_${name}_${kind}>)
    endif()
  endforeach()
endfunction()
