#!/usr/bin/env bash
# Installs what is missing, builds everything and runs every test.
set -euo pipefail

usage='usage: tools/test.sh [--preset release|debug|sanitize|thread|coverage] [--no-browser]
Installs what is missing (apt; npm, for the browser tests), builds everything with the preset
(release) in build/PRESET and runs every test, or those that need no browser. Exit codes: 0 all tests
pass, 1 a build or a test failed, 2 bad usage, 3 a package is missing and cannot be installed.'

preset=release
browser=yes
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
    --no-browser) browser=no ;;
    *)
      printf 'test.sh: unknown argument %s\n%s\n' "$1" "$usage" >&2
      exit 2
      ;;
  esac
  [ $# -eq 0 ] || shift
done
case $preset in
  release | debug | sanitize | thread | coverage) ;;
  *)
    printf 'test.sh: --preset %s: release, debug, sanitize, thread or coverage is accepted\n' "'$preset'" >&2
    exit 2
    ;;
esac

cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

step() {
  printf 'test.sh: %s\n' "$*"
  "$@"
}

# The packages of the browser tests. What was installed from this lockfile is not fetched again.
install_node_packages() {
  local lockfile=package-lock.json installed=node_modules/installed-package-lock.json
  cd tools/browser_tests
  if cmp -s "$lockfile" "$installed"; then return; fi
  step npm ci --ignore-scripts --no-audit --no-fund --no-update-notifier || return
  cp "$lockfile" "$installed"
}

selection=()
if [ $browser = yes ]; then
  tools/install_dependencies.sh browser
  if ! (install_node_packages); then
    printf 'test.sh: npm cannot install what the browser tests need; --no-browser leaves them out\n' >&2
    exit 3
  fi
else
  tools/install_dependencies.sh tests
  selection=(--label-exclude browser)
fi
step cmake --preset "$preset" || exit 1
step cmake --build --preset "$preset" -j "$(nproc)" || exit 1
step ctest --preset "$preset" -j "$(nproc)" "${selection[@]}" || exit 1
