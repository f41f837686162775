#!/usr/bin/env bash
# Plants small faults in the numeric rooms, one at a time, and tells which of them no test notices.
set -euo pipefail

usage='usage: tools/mutate.sh [COUNT [SEED]]
Draws COUNT mutants (600) with SEED (1) in a clone of the last commit, build/mutants/tree, builds them
all at once, runs the tests with each, and writes docs/reliability/mutations.json, which
tools/generate_reliability.py makes a section of docs/reliability.md from. About an hour. Needs
python3-clang. Exit codes: 0 at least 95 % are noticed, 1 fewer, 2 bad usage, 3 it cannot be done.'

count=${1-600} seed=${2-1}
if ! [[ $# -le 2 && $count =~ ^[1-9][0-9]*$ && $seed =~ ^[0-9]+$ ]]; then
  printf '%s\n' "$usage" >&2
  [ "${1-}" = --help ] && exit 0
  exit 2
fi
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
if ! /usr/bin/python3 -c 'import clang.cindex' 2>/dev/null; then
  echo 'mutate.sh: python3-clang is missing (apt-get install python3-clang)' >&2
  exit 3
fi
mkdir -p build/mutants
[ -d build/mutants/tree ] || git clone -q . build/mutants/tree
git -C build/mutants/tree fetch -q origin HEAD
# What is planted and built already is kept.
if [ "$(git -C build/mutants/tree rev-parse HEAD)" != "$(git rev-parse HEAD)" ]; then
  git -C build/mutants/tree checkout -q --force --detach FETCH_HEAD
fi
exec /usr/bin/python3 tools/mutation/try_mutants.py build/mutants/tree "$count" "$seed" \
  docs/reliability/mutations.json
