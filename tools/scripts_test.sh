#!/usr/bin/env bash
# Tests the scripts without installing anything: on a machine made up of a folder of commands.
set -uo pipefail
tools=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
machine=$(mktemp -d)
trap 'rm -rf -- "$machine"' EXIT
failures=0

# The commands of a machine without a compiler.
for name in bash env cat dirname; do ln -s "$(command -v $name)" "$machine/$name"; done

fake() { # NAME LINE: a command of the machine
  printf '#!/usr/bin/env bash\n%s\n' "$2" >"$machine/$1"
  chmod +x "$machine/$1"
}

expect() { # EXIT-CODE PART-OF-OUTPUT COMMAND...
  local code=$1 part=$2 output
  shift 2
  output=$("$@" 2>&1 </dev/null)
  local actual=$?
  if [ $actual -ne "$code" ] || [[ $output != *"$part"* ]]; then
    printf 'FAILED: %s\n  expected exit code %s and "%s"\n  got %s: %s\n' \
      "$*" "$code" "$part" "$actual" "$output"
    failures=$((failures + 1))
  fi
}

# shellcheck disable=SC2317 # reached through expect
on_the_machine() { PATH=$machine "$machine/bash" "$@"; }

fake id 'echo 1000'
expect 3 'no apt-get; install what these Debian packages hold: g++ cmake ninja-build' \
  on_the_machine "$tools/install_dependencies.sh" program
expect 3 'no apt-get' on_the_machine "$tools/test.sh"
expect 3 'no apt-get' on_the_machine "$tools/verify.sh"
expect 3 'no apt-get' on_the_machine "$tools/bench.sh" compare HEAD

fake apt-get 'echo "apt-get called: $*"; exit 1'
fake apt-cache 'echo "some version"'
expect 3 'neither root nor sudo; let root run: apt-get install g++' \
  on_the_machine "$tools/install_dependencies.sh" program

fake sudo 'echo "as root: $*"; "$@"'
expect 3 'as root: env DEBIAN_FRONTEND=noninteractive apt-get' \
  on_the_machine "$tools/install_dependencies.sh" program
expect 3 'could not install: g++' on_the_machine "$tools/install_dependencies.sh" tests

fake id 'echo 0'
expect 3 'apt-get called' on_the_machine "$tools/install_dependencies.sh" program

# An apt-get that brings the commands: what it was asked for is there afterwards, and not asked for again.
# shellcheck disable=SC2016 # expanded by the fake command
fake apt-get 'for name in g++ cmake ninja gnuplot; do echo >"${0%/*}/$name"; done; ${0%/*}/chmod +x "${0%/*}"/*'
ln -s "$(command -v chmod)" "$machine/chmod"
expect 0 'apt-get' on_the_machine "$tools/install_dependencies.sh" program
fake apt-get 'echo "called again"; exit 1'
expect 0 'install_dependencies: nothing is missing' \
  on_the_machine "$tools/install_dependencies.sh" program

# A project's copy on a machine that has everything, but whose commands only say that they were called.
project=$machine/project
mkdir -p "$project/tools/browser_tests"
cp "$tools/test.sh" "$tools/install_dependencies.sh" "$project/tools"
echo 'lock' >"$project/tools/browser_tests/package-lock.json"
for name in cmp cp mkdir nproc; do ln -s "$(command -v $name)" "$machine/$name"; done
for name in cmake ctest git ffmpeg codespell parallel rsvg-convert chromium node; do fake $name "echo \"$name called: \$*\""; done
fake npm 'echo "npm called: $*"; exit 1'
expect 3 '--no-browser leaves them out' on_the_machine "$project/tools/test.sh"
expect 0 'ctest called: --preset release -j '"$(nproc)"' --label-exclude browser' \
  on_the_machine "$project/tools/test.sh" --no-browser
fake npm 'echo "npm called: $*"; mkdir node_modules'
expect 0 'npm called: ci' on_the_machine "$project/tools/test.sh"
fake npm 'echo "npm called again"; exit 1'
expect 0 'ctest called: --preset debug' on_the_machine "$project/tools/test.sh" --preset debug

# A peer that cannot be had is left out, and said to be.
sed 's#gsl/gsl_wavelet.h#gsl/of_nowhere.h#' "$tools/install_dependencies.sh" >"$project/tools/install_dependencies.sh"
fake apt-get 'echo "apt-get called: $*"; exit 1'
expect 0 'left out, for nothing but comparisons needs them: libgsl-dev' \
  on_the_machine "$project/tools/install_dependencies.sh" browser
expect 0 'ctest called: --preset debug' on_the_machine "$project/tools/test.sh" --preset debug

# What cannot be built is no regression and no other verdict.
unbuilt=$machine/unbuilt
mkdir -p "$unbuilt/tools"
cp "$tools/bench.sh" "$tools/verify.sh" "$unbuilt/tools"
printf '#!/usr/bin/env bash\n' >"$unbuilt/tools/install_dependencies.sh"
chmod +x "$unbuilt/tools/install_dependencies.sh"
fake cmake 'echo "cmake called: $*"; exit 1'
expect 3 'cmake called: --preset release' on_the_machine "$unbuilt/tools/verify.sh"
expect 3 'cmake called: --preset release' on_the_machine "$unbuilt/tools/bench.sh" compare HEAD
fake cmake 'echo "cmake called: $*"'
echo 'another lock' >"$project/tools/browser_tests/package-lock.json"
expect 3 'npm called again' on_the_machine "$project/tools/test.sh"
rm "$machine/chromium" "$machine/npm"
fake apt-get 'echo "apt-get called: $*"; exit 1'
expect 3 'missing: chromium npm' on_the_machine "$project/tools/test.sh"

# A project of a few files, each of which breaks one rule of the house.
if [ -x /usr/bin/python3 ]; then
  house=$machine/house
  mkdir -p "$house"/lib/wavecurve/{filters,io/files,curves/detail} "$house/verification/suite"
  check=(/usr/bin/python3 "$tools/check_architecture.py")
  one() { # FILE INCLUDE EXIT-CODE PART-OF-OUTPUT: the house with this file more
    printf '#include "%s"\n' "$2" >"$house/$1"
    expect "$3" "$4" "${check[@]}" "$house"
    rm "$house/$1"
  }
  touch "$house"/lib/wavecurve/{filters/filter.hpp,io/files/read_file.hpp,curves/detail/arc.hpp} "$house/verification/suite/claim.hpp"
  expect 0 'goes where it may' "${check[@]}" "$house"
  one lib/wavecurve/io/files/text.cpp wavecurve/filters/filter.hpp 0 'goes where it may'
  one lib/wavecurve/filters/tables.cpp wavecurve/io/files/read_file.hpp 1 'filters may not know io'
  one lib/wavecurve/filters/tables_test.cpp wavecurve/io/files/read_file.hpp 0 'goes where it may'
  one lib/wavecurve/io/files/text.cpp verification/suite/claim.hpp 1 'io may not know verification'
  one verification/suite/run.cpp claim.hpp 1 'no path from the root'
  one lib/wavecurve/curves/path.hpp wavecurve/curves/detail/arc.hpp 1 'detail is not installed'
  one lib/wavecurve/curves/detail/arc.hpp wavecurve/curves/detail/arc.hpp 1 'in a circle'
  for i in {1..26}; do touch "$house/lib/wavecurve/filters/concept_$i.cpp"; done
  expect 1 'holds 27 concepts' "${check[@]}" "$house"
  expect 2 'usage: tools/check_architecture.py' "${check[@]}" --fast
fi

expect 2 "--preset 'fast': release, debug, sanitize, thread or coverage is accepted" \
  "$tools/test.sh" --preset fast
expect 2 'unknown argument --fast' "$tools/test.sh" --fast
expect 2 'usage' "$tools/install_dependencies.sh"
expect 0 'usage: tools/test.sh' "$tools/test.sh" --help
expect 0 'usage: tools/verify.sh' "$tools/verify.sh" --help

expect 2 'usage: tools/bench.sh' "$tools/bench.sh"
expect 2 'usage: tools/bench.sh' "$tools/bench.sh" fast
expect 0 'usage: tools/bench.sh' "$tools/bench.sh" --help

[ $failures -eq 0 ] && echo "all scripts behave as described"
exit $failures
