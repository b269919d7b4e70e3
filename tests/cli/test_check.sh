# plunge check: the shipped cases are fine; each wrong one gets exit code 2, nothing on stdout, and the
# messages that test_case_bad expects, except where those depend on what the solvers and the comparator
# offer (there, with stand-ins for them).
plunge=$1 source=$2 failed=0

if ! "$plunge" check "$source"/cases/*.yaml; then
  echo "FAIL a shipped case is refused"
  failed=1
fi

cd "$source/tests/common/bad" || exit 1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$plunge" check *.yaml >"$scratch/out" 2>"$scratch/err"
code=$?
if [ $code != 2 ] || [ -s "$scratch/out" ]; then
  echo "FAIL exit code $code, expected 2; accepted:"
  cat "$scratch/out"
  failed=1
fi
for case in *.yaml; do
  grep -q "^$case:" "$scratch/err" || { echo "FAIL $case gets no message"; failed=1; }
done
own='runs\.a|solver-refuses|tolerance'
grep -vE "$own" messages.txt | sort >"$scratch/expected"
grep -vE "$own" "$scratch/err" | sort >"$scratch/found"
if ! diff "$scratch/expected" "$scratch/found"; then
  echo "FAIL messages differ from those of the library"
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
