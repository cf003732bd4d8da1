# Compiler settings that every target of the project shares.
find_program(STURM_CCACHE ccache)
if(STURM_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${STURM_CCACHE})
endif()
find_program(STURM_MOLD mold)
if(STURM_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

add_library(sturm_options INTERFACE)
# GCC 12 reports -Wrestrict for correct std::string code (GCC bug 105651).
# No fused multiply-adds behind our back: the same bits with and without STURM_NATIVE wherever only our code computes.
target_compile_options(sturm_options INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wno-restrict -ffp-contract=off)
if(STURM_WARNINGS_AS_ERRORS)
  target_compile_options(sturm_options INTERFACE -Werror)
endif()
if(STURM_NATIVE)
  target_compile_options(sturm_options INTERFACE -march=native -mprefer-vector-width=512)
endif()
if(STURM_SANITIZE)
  target_compile_options(sturm_options INTERFACE -fsanitize=${STURM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(sturm_options INTERFACE -fsanitize=${STURM_SANITIZE})
endif()

# sturm_module(NAME [EXCLUDE pattern] DEPENDS target... [PRIVATE target...]): one library per folder, made of all its .cpp files but main.cpp
# and those whose path matches the pattern.
# Sources are listed by the folder itself: one concept, one .cpp; a new file needs no edit here.
function(sturm_module name)
  cmake_parse_arguments(ARG "" "EXCLUDE" "DEPENDS;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  if(ARG_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX "${ARG_EXCLUDE}")
  endif()
  add_library(sturm_${name} STATIC ${sources})
  add_library(sturm::${name} ALIAS sturm_${name})
  set_target_properties(sturm_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(sturm_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/sturm>)
  target_compile_features(sturm_${name} PUBLIC cxx_std_20)
  target_link_libraries(sturm_${name} PUBLIC ${ARG_DEPENDS} PRIVATE $<BUILD_INTERFACE:sturm_options> ${ARG_PRIVATE})
endfunction()
