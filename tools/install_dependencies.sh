#!/usr/bin/env bash
# Installs the Debian packages that are missing. The one list of what the project needs.
set -euo pipefail

usage='usage: tools/install_dependencies.sh program|bench|tests|browser
Installs, through apt, the packages that are missing: those that the program is built and run with,
or also those of tracking performance, or of the tests and benchmarks, or also those of the tests
in a browser. Installs nothing, and asks no server, where all are there.
Exit codes: 0 all there, 2 bad usage, 3 something is missing and cannot be installed.'

# A package, and what shows that it is there, however it came: one of the programs, headers or
# Python modules named. FLINT 3 contains Arb, so there libflint-arb-dev neither exists nor is missed.
program_packages='
g++                   program:g++
cmake                 program:cmake
ninja-build           program:ninja
libeigen3-dev         header:eigen3/Eigen/Core
libspectra-dev        header:Spectra/SymEigsSolver.h
libboost-dev          header:boost/version.hpp
libhwy-dev            header:hwy/highway.h
libflint-dev          header:flint/fmpq_mat.h
libflint-arb-dev      header:flint/arb.h header:arb.h
libsvgpp-dev          header:svgpp/svgpp.hpp
libxml2-dev           header:libxml2/libxml/tree.h
libpng-dev            header:png.h
zlib1g-dev            header:zlib.h
libpolyclipping-dev   header:polyclipping/clipper.hpp
libfmt-dev            header:fmt/format.h
nlohmann-json3-dev    header:nlohmann/json.hpp
libcli11-dev          header:CLI/CLI.hpp
gnuplot-nox           program:gnuplot
'
# For git, see benchmarks/tracking: it builds revisions.
benchmark_packages='
git                   program:git
libbenchmark-dev      header:benchmark/benchmark.h
python3               program:/usr/bin/python3
'
# Measured and tested beside the library, never used by it: what cannot be installed is left out.
peer_packages='
libgsl-dev            header:gsl/gsl_wavelet.h
libsundials-dev       header:cvode/cvode.h
python3-pywt          module:pywt
'
tracking_packages='
valgrind              program:valgrind
python3-mpmath        module:mpmath
'
test_packages='
libgtest-dev          header:gtest/gtest.h
librapidcheck-dev     header:rapidcheck.h
librlottie-dev        header:rlottie.h
ffmpeg                program:ffmpeg
codespell             program:codespell
parallel              program:parallel
'
# The Python package is built and tested with Debian's own interpreter.
python_packages='
pybind11-dev          header:pybind11/pybind11.h
python3-dev           program:/usr/bin/python3-config
python3-numpy         module:numpy
python3-scipy         module:scipy
python3-pandas        module:pandas
python3-matplotlib    module:matplotlib
python3-pytest        module:pytest
python3-hypothesis    module:hypothesis
python3-pip           module:pip
mypy                  module:mypy
'
# Node.js comes with npm inside from some sources, and without it from Debian: the signs decide.
browser_packages='
chromium              program:chromium
nodejs                program:node program:nodejs
npm                   program:npm
librsvg2-bin          program:rsvg-convert
'

say() { printf '%s\n' "install_dependencies: $*"; }

fail() {
  printf '%s\n' "install_dependencies: $*" >&2
  exit 3
}

is_there() {
  local name=${1#*:}
  case $1 in
    program:*) command -v "$name" >/dev/null ;;
    header:*) [ -e "/usr/include/$name" ] || [ -e "/usr/local/include/$name" ] ;;
    # Debian's own interpreter, for its modules are invisible to another one that comes first in PATH.
    module:*) /usr/bin/python3 -c "import $name" 2>/dev/null ;;
  esac
}

# The packages of the list on standard input that nothing shows to be there.
missing_packages() {
  local package signs sign
  while read -r package signs; do
    [ -n "$package" ] || continue
    for sign in $signs; do
      if is_there "$sign"; then continue 2; fi
    done
    printf '%s\n' "$package"
  done
}

apt_get() {
  local command=(env DEBIAN_FRONTEND=noninteractive apt-get -q -y)
  command+=(-o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)
  [ "$(id -u)" -eq 0 ] || command=(sudo "${command[@]}")
  say "${command[*]} $*"
  "${command[@]}" "$@" </dev/null
}

# Whether packages can be installed here at all.
can_install() {
  command -v apt-get >/dev/null && { [ "$(id -u)" -eq 0 ] || command -v sudo >/dev/null; }
}

update_lists() {
  apt_get update || say "apt-get update failed; going on with the package lists at hand"
}

install_packages() {
  local available=() package
  update_lists
  for package in "$@"; do
    if [ "$package" = libflint-arb-dev ] && [ -z "$(apt-cache madison "$package")" ]; then continue; fi
    available+=("$package")
  done
  apt_get install --no-install-recommends "${available[@]}" ||
    fail "apt-get could not install: ${available[*]}"
}

# Installs the peers that are missing, one by one, or says in one line which are left out.
install_peers() {
  local missing package
  mapfile -t missing < <(missing_packages <<<"$1")
  if [ ${#missing[@]} -eq 0 ]; then return; fi
  if can_install; then
    update_lists
    for package in "${missing[@]}"; do apt_get install --no-install-recommends "$package" || true; done
    mapfile -t missing < <(missing_packages <<<"$1")
  fi
  [ ${#missing[@]} -eq 0 ] || say "left out, for nothing but comparisons needs them: ${missing[*]}"
}

list=$program_packages
peers=
case ${1-} in
  program) ;;
  bench) list+=$benchmark_packages$tracking_packages peers=$peer_packages ;;
  tests) list+=$test_packages$benchmark_packages$python_packages peers=$peer_packages ;;
  browser) list+=$test_packages$benchmark_packages$python_packages$browser_packages peers=$peer_packages ;;
  --help | -h)
    printf '%s\n' "$usage"
    exit 0
    ;;
  *)
    printf '%s\n' "$usage" >&2
    exit 2
    ;;
esac

mapfile -t missing < <(missing_packages <<<"$list")
if [ ${#missing[@]} -eq 0 ]; then
  say "nothing is missing"
  install_peers "$peers"
  exit 0
fi
say "missing: ${missing[*]}"
if ! command -v apt-get >/dev/null; then
  fail "this system has no apt-get; install what these Debian packages hold: ${missing[*]}"
fi
can_install || fail "neither root nor sudo; let root run: apt-get install ${missing[*]}"
install_packages "${missing[@]}"
mapfile -t missing < <(missing_packages <<<"$list")
[ ${#missing[@]} -eq 0 ] || fail "still missing after the installation: ${missing[*]}"
install_peers "$peers"
