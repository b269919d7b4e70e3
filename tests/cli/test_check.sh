# plunge check: the shipped cases are fine; each wrong one gets exit code 2, nothing on stdout, and its
# messages: those that test_case_bad expects, except where they depend on what the solvers and the
# comparator offer (there, with stand-ins for them), and those of tests/cli/refused for cases that are
# sound but beyond the solver that they name.
plunge=$1 source=$2 failed=0

if ! "$plunge" check "$source"/cases/*.yaml; then
  echo "FAIL a shipped case is refused"
  failed=1
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# check_folder FOLDER PATTERN: lines that match PATTERN are left out of the comparison of messages
check_folder() {
  cd "$1" || exit 1
  "$plunge" check *.yaml >"$scratch/out" 2>"$scratch/err"
  code=$?
  if [ $code != 2 ] || [ -s "$scratch/out" ]; then
    echo "FAIL $1: exit code $code, expected 2; accepted:"
    cat "$scratch/out"
    failed=1
  fi
  for case in *.yaml; do
    grep -q "^$case:" "$scratch/err" || { echo "FAIL $case gets no message"; failed=1; }
  done
  grep -vE "$2" messages.txt | sort >"$scratch/expected"
  grep -vE "$2" "$scratch/err" | sort >"$scratch/found"
  if ! diff "$scratch/expected" "$scratch/found"; then
    echo "FAIL $1: other messages than expected"
    failed=1
  fi
}
check_folder "$source/tests/common/bad" 'runs\.a|solver-refuses|tolerance|sweep-unknown'
check_folder "$source/tests/cli/refused" 'one of mean_distance' # that list grows with the comparator

# --set is checked like what stands in the case, and estimated
for resolution in 20 40; do
  "$plunge" check "$source/cases/hydrostatic.yaml" --set runs.antuono-fine.resolution=$resolution >"$scratch/$resolution" || failed=1
done
if cmp -s "$scratch/20" "$scratch/40"; then
  echo "FAIL check --set changes nothing"
  failed=1
fi
"$plunge" check "$source/cases/hydrostatic.yaml" --set time.end=-1 >"$scratch/out" 2>"$scratch/err"
if [ $? != 2 ] || ! grep -q "^--set time.end=-1" "$scratch/err"; then
  echo "FAIL check --set of a bad value: $(cat "$scratch/out" "$scratch/err")"
  failed=1
fi

# what a run warns of is said before it
"$plunge" check "$source/cases/hydrostatic.yaml" --set runs.antuono-fine.c0='5 sqrt(gH)' >"$scratch/out" 2>"$scratch/err" || failed=1
if ! grep -q '^  antuono-fine: c0 = .* Mach number of 0.40' "$scratch/err" || [ "$(wc -l <"$scratch/err")" != 1 ]; then
  echo "FAIL check does not warn of slow sound: $(cat "$scratch/err")"
  failed=1
fi

"$plunge" check "$source/cases/dam-break.yaml" --set runs.bem.resolution=10 >"$scratch/out" 2>"$scratch/err" || failed=1
if ! grep -q '^  bem: resolution = 10: 3.7 nodes over the mean depth of the water, where 4 are wanted: .* 11 would do$' "$scratch/err"; then
  echo "FAIL check does not warn of too few nodes in shallow water: $(cat "$scratch/err")"
  failed=1
fi
"$plunge" check "$source/cases/dam-break.yaml" --set runs.bem.resolution=11 >"$scratch/out" 2>"$scratch/err" || failed=1
if grep -q 'mean depth' "$scratch/err"; then
  echo "FAIL check warns of enough nodes in shallow water: $(cat "$scratch/err")"
  failed=1
fi

for odd in /nowhere/case.yaml /dev/null "$source"; do
  "$plunge" check "$odd" >/dev/null 2>&1
  code=$?
  if [ $code != 2 ]; then
    echo "FAIL $odd: exit code $code"
    failed=1
  fi
done
exit $failed
