#!/usr/bin/env bash
# Installs what is missing, builds everything and runs every test.
set -euo pipefail

usage='usage: tools/test.sh [--preset release|debug|sanitize|coverage]
Installs what is missing (apt), builds everything with the preset (release) in build/PRESET and runs
every test. Exit codes: 0 all tests pass, 1 a build or a test failed, 2 bad usage, 3 a package is
missing and cannot be installed.'

preset=release
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h)
      printf '%s\n' "$usage"
      exit 0
      ;;
    --preset)
      preset=${2-}
      shift
      ;;
    *)
      printf 'test.sh: unknown argument %s\n%s\n' "$1" "$usage" >&2
      exit 2
      ;;
  esac
  [ $# -eq 0 ] || shift
done
case $preset in
  release | debug | sanitize | coverage) ;;
  *)
    printf 'test.sh: --preset %s: release, debug, sanitize or coverage is accepted\n' "'$preset'" >&2
    exit 2
    ;;
esac

cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

step() {
  printf 'test.sh: %s\n' "$*"
  "$@"
}

tools/install_dependencies.sh tests
step cmake --preset "$preset" || exit 1
step cmake --build --preset "$preset" -j "$(nproc)" || exit 1
step ctest --preset "$preset" -j "$(nproc)" || exit 1
