#!/usr/bin/env bash
# Installs what is missing, builds the program and verifies the publication.
set -euo pipefail

usage='usage: tools/verify.sh [arguments of "wavecurve verify"]
Installs what is missing (apt), builds build/release/bin/wavecurve and runs its verify command, which
writes reports/latest/index.html; "tools/verify.sh --list" names the claims. Exit codes: 0 as blessed,
1 a verdict differs or the build failed, 2 bad usage, 3 the environment failed.'

case ${1-} in
  --help | -h)
    printf '%s\n' "$usage"
    exit 0
    ;;
esac

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
cd -- "$root"

step() {
  printf 'verify.sh: %s\n' "$*"
  "$@"
}

tools/install_dependencies.sh program
# A tree that is configured stays as it is (the build itself renews it); a new one needs no packages of
# the tests.
if [ ! -e build/release/build.ninja ]; then
  step cmake --preset release -DWAVECURVE_TESTS=OFF -DWAVECURVE_BENCHMARKS=OFF || exit 1
fi
step cmake --build --preset release --target wavecurve_program -j "$(nproc)" || exit 1
step build/release/bin/wavecurve verify "$@"
