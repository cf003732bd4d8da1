# What the WebAssembly build takes from Debian's packages: headers only, through a folder of links that holds nothing else. /usr/include itself would
# put the C library of this machine before that of the toolchain.
# Debian's emscripten looks for its JavaScript libraries by this, whichever node runs it.
set(CMAKE_CXX_LINKER_LAUNCHER ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs)

set(wasm_headers ${PROJECT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${wasm_headers})
find_path(eigen_headers Eigen/Core PATHS /usr/include/eigen3 NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
find_path(json_headers nlohmann/json.hpp PATHS /usr/include NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
file(CREATE_LINK ${eigen_headers}/Eigen ${wasm_headers}/Eigen SYMBOLIC)
file(CREATE_LINK ${json_headers}/nlohmann ${wasm_headers}/nlohmann SYMBOLIC)
file(CREATE_LINK ${json_headers}/valijson ${wasm_headers}/valijson SYMBOLIC)

add_library(sturm_wasm_options INTERFACE)
target_include_directories(sturm_wasm_options INTERFACE ${PROJECT_SOURCE_DIR})
target_include_directories(sturm_wasm_options SYSTEM INTERFACE ${wasm_headers})
target_compile_definitions(sturm_wasm_options INTERFACE STURM_SERIAL EIGEN_MAX_ALIGN_BYTES=16)
# As cmake/options.cmake: no fused multiply-adds, so that numbers come out as in the program.
target_compile_options(sturm_wasm_options INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -O3 -ffp-contract=off -msimd128 -fexceptions)
target_link_options(sturm_wasm_options INTERFACE -fexceptions)
