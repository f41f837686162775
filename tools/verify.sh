#!/usr/bin/env bash
# Installs what is missing, builds the program and verifies the publication.
set -euo pipefail

usage='usage: tools/verify.sh [arguments of "wavecurve verify"]
Installs what is missing (apt), builds build/release/bin/wavecurve and runs its verify command, which
writes reports/latest/index.html; "tools/verify.sh --list" names the claims. Exit codes: 0 as blessed,
1 a verdict differs, 2 bad usage, 3 the environment or the build failed.'

case ${1-} in
  --help | -h)
    printf '%s\n' "$usage"
    exit 0
    ;;
esac

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

step() {
  printf 'verify.sh: %s\n' "$*"
  "$@"
}

build() {
  cd -- "$root" || return 1
  # A tree that is configured stays as it is (the build itself renews it); a new one needs no packages
  # of the tests.
  if [ ! -e build/release/build.ninja ]; then
    step cmake --preset release -DWAVECURVE_TESTS=OFF -DWAVECURVE_BENCHMARKS=OFF || return 1
  fi
  step cmake --build --preset release --target wavecurve_program -j "$(nproc)" || return 1
}

"$root/tools/install_dependencies.sh" program
(build) || exit 3
# From where the user stands, for paths among the arguments.
step "$root/build/release/bin/wavecurve" verify "$@"
