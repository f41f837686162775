#!/usr/bin/env bash
# Builds a static site of the guide, the reference pages and the C++ reference.
set -euo pipefail

usage='usage: tools/docs.sh [FOLDER]
Writes the site into FOLDER (build/docs) by Doxygen: open FOLDER/html/index.html, no server is needed.
The Python reference is part of it where the package is built (build/release/python).
Exit codes: 0 done, 1 Doxygen has a complaint, each on a line, 2 bad usage, 3 Doxygen is missing.'

case ${1-} in
  --help | -h)
    printf '%s\n' "$usage"
    exit 0
    ;;
  -*)
    printf 'docs.sh: unknown argument %s\n%s\n' "$1" "$usage" >&2
    exit 2
    ;;
esac
if [ $# -gt 1 ]; then
  printf '%s\n' "$usage" >&2
  exit 2
fi
if ! command -v doxygen >/dev/null; then
  echo 'docs.sh: doxygen is missing (apt-get install doxygen)' >&2
  exit 3
fi
folder=$(realpath -m -- "${1-$(dirname -- "${BASH_SOURCE[0]}")/../build/docs}")
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
mkdir -p "$folder"
version=$(sed -n 's/^project(wavecurve VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
python=''
if PYTHONPATH=build/release/python /usr/bin/python3 docs/python_reference.py >"$folder/python-reference.md" 2>/dev/null; then
  python="INPUT += \"$folder/python-reference.md\""
else
  echo 'docs.sh: without the Python reference: the package is not built' >&2
fi
printf '@INCLUDE = docs/Doxyfile\nPROJECT_NUMBER = %s\nOUTPUT_DIRECTORY = "%s"\n%s\n' "$version" "$folder" "$python" |
  doxygen - || exit 1
echo "site: $folder/html/index.html"
