#!/usr/bin/env bash
# plunge import: each wrong sidecar of tests/cli/bad_sidecars gets exit code 2, its exact messages, and
# leaves no result. What depends on the list of keys of a case is left out of the comparison.
source "$2/tests/cli/begin"
scratch=$PWD
cd "$2/tests/cli/bad_sidecars" || exit 1
for sidecar in *.yaml; do
  "$program" import "$sidecar" --out "$scratch/x.h5" >"$scratch/out" 2>"$scratch/one"
  code=$?
  [ $code = 2 ] || fail "$sidecar: exit code $code"
  [ -s "$scratch/out" ] && fail "$sidecar: something on stdout"
  grep -q "$sidecar:" "$scratch/one" || fail "$sidecar gets no message"
  [ -e "$scratch/x.h5" ] && fail "$sidecar leaves a result"
  cat "$scratch/one" >>"$scratch/found"
done
unstable='case-no-case'
diff <(grep -vE "$unstable" messages.txt) <(grep -vE "$unstable" "$scratch/found") || fail "other messages than expected"
[ "$(ls ./*.yaml | wc -l)" -ge 60 ] || fail "only $(ls ./*.yaml | wc -l) sidecars"
exit $failed
