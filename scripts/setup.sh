# Sourced by scripts/run and scripts/test: installs what is missing, configures and builds.

fail() {
  echo "error: $*" >&2
  exit 1
}

# install_dependencies [LIST...]: the packages of scripts/dependencies.txt and of further lists.
install_dependencies() {
  command -v dpkg-query >/dev/null || fail "this script installs Debian packages, but dpkg is not here; install the packages of scripts/dependencies.txt by hand"
  local missing=() package
  while read -r package _; do
    case "$package" in '' | '#'*) continue ;; esac
    dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' || missing+=("$package")
  done < <(cat scripts/dependencies.txt "$@")
  [ ${#missing[@]} -eq 0 ] && return
  install_packages "${missing[@]}"
}

# install_packages PACKAGE...
install_packages() {
  echo "== installing $# packages: $*"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "packages are missing ($*) and there is neither root nor sudo"
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq || fail "the package lists could not be updated"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" >/dev/null ||
    fail "packages could not be installed: $*"
}

# build_preset PRESET [TARGET...]: with CMake's options in STURM_CMAKE_OPTIONS, if it is set.
build_preset() {
  local preset=$1
  shift
  local log=build/$preset/setup.log
  mkdir -p "build/$preset"
  if [ ! -f "build/$preset/build.ninja" ]; then
    echo "== configuring (preset $preset)"
    cmake --preset "$preset" ${STURM_CMAKE_OPTIONS:-} >"$log" 2>&1 || {
      tail -n 20 "$log" >&2
      fail "configuring failed; the whole log is in $log"
    }
  fi
  echo "== building (preset $preset)"
  cmake --build "build/$preset" ${1:+--target "$@"} >"$log" 2>&1 || {
    tail -n 40 "$log" >&2
    fail "the build failed; the whole log is in $log"
  }
}

# Libraries of the viewer's page, in viewer/node_modules, and the folder build/viewer. Returns 1 where npm could not fetch them.
install_page_libraries() {
  command -v npm >/dev/null || install_packages npm
  local log=build/viewer/setup.log
  mkdir -p build/viewer
  [ ! viewer/node_modules/.package-lock.json -nt viewer/package-lock.json ] || return 0
  (cd viewer && npm ci --no-audit --no-fund) >"$log" 2>&1 || {
    tail -n 20 "$log" >&2
    echo "warning: npm could not fetch the libraries of the viewer's page; the whole log is in $log" >&2
    return 1
  }
}

# The viewer's core as WebAssembly and its page without data, build/viewer/viewer.html. Returns 1 where npm could not fetch the page's libraries.
build_viewer() {
  install_dependencies scripts/dependencies_of_viewer.txt
  build_preset wasm
  install_page_libraries || return 1
  echo "== building the viewer's page"
  node viewer/build.mjs >build/viewer/setup.log 2>&1 || {
    tail -n 40 build/viewer/setup.log >&2
    fail "the viewer's page could not be built; the whole log is in build/viewer/setup.log"
  }
}
