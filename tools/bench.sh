#!/usr/bin/env bash
# Tracks performance: installs what is missing, builds, runs `wavecurve bench`.
set -euo pipefail

usage='usage: tools/bench.sh record|backfill|compare|self-test|check|history|peers [arguments of "wavecurve bench"]
  record [REVISION]      measures a revision (the working tree) and adds it to benchmarks/history/
  backfill [--count 20]  instruction counts and accuracy of past revisions, evenly spaced
  compare BEFORE [AFTER] two revisions, records or build folders, AFTER being the working tree
  self-test [--short]    tries whether the tracking is silent and finds what it must
  check [--bless]        instruction counts and accuracy against benchmarks/baseline/, or blesses them
  history, peers         write pages with charts: over the records, and beside other libraries
Exit codes: 0 no regression, 1 a regression, 2 bad usage, 3 the environment or a build failed,
4 inconclusive, 5 records of different machines. docs/how-to-read-benchmarks.md says more.'

case ${1-} in
  --help | -h)
    printf '%s\n' "$usage"
    exit 0
    ;;
  record | backfill | compare | self-test | check | history | peers) ;;
  *)
    printf '%s\n' "$usage" >&2
    exit 2
    ;;
esac

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

step() {
  printf 'bench.sh: %s\n' "$*" >&2
  "$@" >&2
}

build() {
  cd -- "$root" || return 1
  if [ ! -e build/release/build.ninja ]; then
    step cmake --preset release -DWAVECURVE_TESTS=OFF || return 1
  fi
  step cmake --build --preset release --target "$@" -j "$(nproc)" || return 1
}

# Without valgrind the self-test and the check say what they leave out.
case $1 in
  self-test | check)
    "$root/tools/install_dependencies.sh" bench >&2 || step "$root/tools/install_dependencies.sh" tests
    ;;
  *) "$root/tools/install_dependencies.sh" bench >&2 ;;
esac
program=wavecurve_bench
targets=(wavecurve_bench)
case $1 in
  history) program=wavecurve targets=(wavecurve_program) ;;
  peers) program=wavecurve targets=(wavecurve_program benchmarks) ;;
  # What is tried or checked is this build itself.
  self-test) targets+=(kernel_benchmark slowed_5 slowed_20 slowed_100) ;;
  check) targets+=(kernel_benchmark) ;;
esac
(build "${targets[@]}") || exit 3
# From where the user stands, for paths among the arguments.
exec "$root/build/release/bin/$program" bench "$@"
