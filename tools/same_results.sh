#!/usr/bin/env bash
# Holds a program's results against those of another build of it, or of another processor, bit for bit.
set -euo pipefail

usage='usage: tools/same_results.sh PROGRAM OTHER
Computes what is blessed, compared or drawn by PROGRAM (a build of wavecurve) and again by OTHER, and
compares every byte but times. OTHER is
  another build of the program, of any compiler and level of optimisation;
  old-processor=LIBRARY   PROGRAM without AVX2 and FMA in the C library, and with Highway restricted to
                          its baseline by librestrict_highway.so;
  valgrind                PROGRAM on the processor that valgrind emulates (slow: without verify).
Exit codes: 0 all is the same, 1 something differs, 2 bad usage, 3 a program failed.'
if [ $# -ne 2 ] || [ "$1" = --help ]; then
  printf '%s\n' "$usage"
  [ "${1-}" = --help ] && exit 0
  exit 2
fi
program=$1 other=$2
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
examples=$root/docs/examples
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

# The times of compare and the date of a report may differ, and nothing else. An interval of growth is
# bootstrapped from counted operations, not from times.
without_times() { grep -vE '"(seconds|generated|revision)"' "$1"; }

results() { # FOLDER COMMAND...: every result as a file
  local folder=$1
  shift
  mkdir -p "$folder"
  "$@" gait fit "$examples/dog-walk.csv" --scale 16 -o "$folder/gait.json" >"$folder/gait.txt"
  for shape in ellipse star dent; do
    "$@" compare --samples 32 --levels 5 --shape $shape --damping 0,0.1 \
      --format json >"$folder/compare.json.$shape"
    without_times "$folder/compare.json.$shape" >"$folder/compare-$shape.json"
    rm "$folder/compare.json.$shape"
  done
  local faces=("$examples/face-cat.svg" "$examples/face-dog.svg")
  "$@" morph "${faces[@]}" --samples 256 -o "$folder/morph.svg" >/dev/null
  "$@" morph "${faces[@]}" --samples 256 --motion physical --rotation --ease in-out \
    -o "$folder/physical.json" >/dev/null
  "$@" describe "$examples/ring.svg" -o "$folder/describe.json" >/dev/null
  "$@" stiffness coif2 --samples 64 >"$folder/stiffness.txt"
  for form in galerkin collocation standard nonstandard; do
    "$@" matrix db4 --samples 64 --form $form --output "$folder/$form.mtx" >"$folder/$form.txt"
  done
  "$@" check "$root/verification/published/table_2.csv" --format json >"$folder/check.json" || [ $? -eq 1 ]
  if [ "$other" != valgrind ]; then
    "$@" verify --output "$folder/report" >"$folder/verify.txt"
    without_times "$folder/report/report.json" >"$folder/verify.json"
    rm -r "$folder/report" "$folder/verify.txt"
  fi
}

case $other in
  old-processor=*)
    shim=${other#*=}
    if [ ! -f "$shim" ]; then
      printf 'same_results.sh: no library %s\n' "$shim" >&2
      exit 2
    fi
    second=(env "LD_PRELOAD=$shim" "RESTRICTED_HIGHWAY=$work/restricted"
      GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX2_Usable,-FMA_Usable,-FMA4_Usable "$program")
    ;;
  valgrind) second=(valgrind -q --error-exitcode=9 "$program") ;;
  *) second=("$other") ;;
esac
set -E
trap 'printf "same_results.sh: a program failed\n" >&2; exit 3' ERR
results "$work/first" "$program"
results "$work/second" "${second[@]}"
trap - ERR
if [[ $other == old-processor=* && ! -s $work/restricted ]]; then
  printf 'same_results.sh: %s did not come into force\n' "$shim" >&2
  exit 3
fi
differ=0
for file in "$work"/first/*; do
  name=$(basename "$file")
  if cmp -s "$file" "$work/second/$name"; then continue; fi
  lines=$(diff "$file" "$work/second/$name" | grep -c '^<' || true)
  printf 'same_results.sh: %s differs in %s lines\n' "$name" "$lines" >&2
  diff "$file" "$work/second/$name" | head -4 >&2 || true
  differ=1
done
[ $differ -eq 0 ] && printf 'same_results.sh: %s files are the same\n' "$(find "$work/first" -type f | wc -l)"
exit $differ
