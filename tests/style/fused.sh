#!/usr/bin/env bash
# Disassembles the packs' objects: no fused multiply-add but those that double-double means, in whatever form a compiler
# may have put it (g++ 12's vectoriser makes vfmaddsub in spite of -ffp-contract=off). Functions of double-double, and
# those that observe in it (TrajectoriesIn), may hold the plain forms.
#     fused.sh OBJECT…
set -euo pipefail

for object in "$@"; do
  objdump -d --no-show-raw-insn "$object" | c++filt | awk -v object="${object##*/}" '
    /^[0-9a-f]+ <.*>:$/ { name = $0; meant = name ~ /DoubleDouble|TrajectoriesIn/; functions++ }
    /vfm(addsub|subadd)/ || (/\tvfn?m(add|sub)/ && !meant) {
      printf "%s: stray fused multiply-add: %s in %.300s\n", object, $0, name
      strays++
    }
    /\tvfn?m(add|sub)/ && meant { fused++ }
    END {
      printf "%s: %d functions, %d fused operations in double-double, %d strays\n", object, functions, fused, strays
      exit strays > 0 || functions < 20 || (object !~ /sse2/ && fused == 0)
    }'
done
