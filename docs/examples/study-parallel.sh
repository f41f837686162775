#!/bin/bash
# A study with GNU parallel, here as four processes of this machine (parallel --sshlogin distributes them):
#   study-parallel.sh --filter db4,coif2 --samples 64,128,256
set -eu
parts=4
seq $parts | parallel --halt now,fail=1 \
  wavecurve compare "${@@Q}" --shard "{}/$parts" -o "study/part-{}"
wavecurve compare --merge study/part-* -o study
