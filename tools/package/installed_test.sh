#!/usr/bin/env bash
# Installs the program, moves what was installed, and runs it with the source tree out of sight.
# usage: installed_test.sh SOURCE-TREE BUILD-TREE CONFIG
set -uo pipefail
source=$1 build=$2 config=$3
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
failures=0

cmake --install "$build" --component program --prefix "$folder/first" >"$folder/log" || {
  cat "$folder/log"
  exit 1
}
mv "$folder/first" "$folder/moved"
prefix=$folder/moved
mkdir "$folder/here"
cd "$folder/here" || exit 1

fail() {
  printf 'FAILED: %s\n' "$*"
  failures=$((failures + 1))
}

# Where mount namespaces may not be made, that no file names the source tree has to do.
hidden=()
if unshare --mount --map-root-user true 2>/dev/null; then
  # shellcheck disable=SC2016 # expanded by the inner shell
  hidden=(unshare --mount --map-root-user bash -c 'mount -t tmpfs none "$0" && "$@"' "$source")
  "${hidden[@]}" test ! -e "$source/LICENSE" || fail "the source tree is still seen"
fi

expect() { # EXIT-CODE PART-OF-OUTPUT ARGUMENTS-OF-WAVECURVE...
  local code=$1 part=$2 output
  shift 2
  output=$("${hidden[@]}" "$prefix/bin/wavecurve" "$@" 2>&1 </dev/null)
  local actual=$?
  if [ $actual -ne "$code" ] || [[ $output != *"$part"* ]]; then
    fail "wavecurve $*: expected exit code $code and \"$part\", got $actual: $output"
  fi
}

# Debug information and sanitizers name the source files.
if [ "$config" = Release ]; then
  named=$(grep -rlF -- "$source" "$prefix")
  [ -z "$named" ] || fail "these files name the source tree: $named"
fi

data=$prefix/share/wavecurve
expect 0 'report: wavecurve-report/index.html' verify --only table-1 table-2 figure-2 figure-4 figure-8
[ -s wavecurve-report/index.html ] || fail 'no report was written'
expect 2 'the reference of an installed program is fixed' verify --bless --only table-1
expect 0 'blessed: mine.json' verify --bless --only table-1 --reference mine.json
expect 1 '12 of 12 entries from alpha from the taps of Daubechies' check "$data/published/table_2.csv"
expect 0 '24 certified' check "$data/published/table_1.csv"
expect 0 'decoupled: floor' compare --samples 16 --shape star --damping 0,0 --solvers decoupled,coupled
expect 0 '' morph "$data/examples/face-dog.svg" "$data/examples/face-cat.svg" --frames 3 -o morph.json
expect 0 'stride 135.5' gait fit "$data/examples/dog-walk.csv" -o walk.json
expect 0 'standing feet slide' gait synthesize walk.json "$data/examples/dog.svg" --frames 4 -o dog.svg
expect 2 'is no clone whose revisions could be built' bench compare HEAD
expect 0 'revision' --version

for file in share/doc/wavecurve/copyright share/man/man1/wavecurve.1.gz share/man/man1/wavecurve-gait.1.gz \
  share/bash-completion/completions/wavecurve share/zsh/site-functions/_wavecurve \
  share/fish/vendor_completions.d/wavecurve.fish; do
  [ -s "$prefix/$file" ] || fail "$file is not installed"
done

rm -r "$data"
expect 3 "cannot find the program's data in $data" verify --only table-1

[ $failures -eq 0 ] && echo 'the installed program needs nothing of the source tree'
exit $((failures > 0))
