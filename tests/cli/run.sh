#!/usr/bin/env bash
# The program as a user meets it: run, run again, change, stop, compare, diff, and the exit codes.
source "$2/tests/cli/begin"

expect() { # what should hold, then the words of a test
  local claim=$1
  shift
  "$@" || fail "$claim"
}
code() { # as in `begin`, but all that is said is in `log`
  local wanted=$1 got=0
  shift
  "$@" >log 2>&1 || got=$?
  [ "$got" = "$wanted" ] || {
    fail "exit code $got, expected $wanted: $*"
    cat log
  }
}

small_dam 4 0.5 0.1 <<'E2'
runs:
  - {name: bem, solver: bem, resolution: 15}
  - {name: sph, solver: sph, resolution: 15}
compare:
  reference: bem
  times: [0.2 sqrt(H/g), 0.5 sqrt(H/g)]
  tolerances:
    - {measure: mean_distance, max: 0.1}
E2

code 0 "$program" check dam.yaml
code 0 "$program" run dam.yaml --out out
for file in bem.h5 bem.xdmf sph.h5 sph.xdmf report.html report.json; do
  expect "a run writes $file" test -s "out/$file"
done

stamp=$(stat -c %y out/bem.h5 out/sph.h5)
code 0 "$program" run dam.yaml --out out
expect "a second run says what is there already" grep -q "sph .*already" log
expect "a second run redoes nothing" test "$stamp" = "$(stat -c %y out/bem.h5 out/sph.h5)"

bem=$(stat -c %y out/bem.h5)
code 0 "$program" run dam.yaml --out out --set runs.sph.alpha=0.02
expect "a changed run is done again" test "$stamp" != "$(stat -c %y out/bem.h5 out/sph.h5)"
expect "an unchanged one is not" test "$bem" = "$(stat -c %y out/bem.h5)"
code 1 "$program" run dam.yaml --out out --set runs.sph.alpha=0.02 --set compare.tolerances[0].max=1e-9

code 0 "$program" run dam.yaml --out one --only sph --threads 1 --set runs.sph.alpha=0.02
code 0 "$program" diff one/sph.h5 out/sph.h5
expect "any number of threads gives the same bits" grep -q "^0 of" log
code 1 "$program" diff out/bem.h5 out/sph.h5
code 0 "$program" compare out/bem.h5 out/sph.h5 --out again
expect "compare writes a report" test -s again/report.html

"$program" run dam.yaml --out stop --only sph --set runs.sph.resolution=60 --set "time.end=4 sqrt(H/g)" \
  --set "compare.times=[0.2 sqrt(H/g)]" >log 2>&1 &
pid=$!
for _ in $(seq 200); do
  "$program" info stop/sph.h5 2>/dev/null | grep -qE 'outputs +([2-9]|[1-9][0-9])' && break
  sleep 0.05
done
kill -INT $pid
wait $pid
expect "a stopped run exits with 3" test $? = 3
code 0 "$program" info stop/sph.h5
expect "a stopped run's file says so" grep -q "stopped before its end" log

code 2 "$program" run dam.yaml --out out --only nobody
code 2 "$program" run dam.yaml --out out --set runs.sph.alpha=-1
code 2 "$program" run dam.yaml --out out --threads 0
code 2 "$program" run dam.yaml --out dam.yaml
expect "a folder that is a file is one complaint" test "$(wc -l <log)" = 1
code 2 "$program" run dam.yaml --out ""
cp dam.yaml dam.v2.yaml
code 0 "$program" run dam.v2.yaml --only bem
expect "only the last suffix is left out of the folder's name" test -s out/dam.v2/bem.h5
code 2 "$program" run missing.yaml
code 2 "$program" no-such-command
code 2 "$program" compare out/bem.h5
if [ -c /dev/full ]; then
  got=0
  "$program" info out/sph.h5 >/dev/full 2>log || got=$?
  expect "output that cannot be written is an error" test $got = 3
  expect "it says so" grep -q "cannot write the output" log
fi
"$program" list 2>log | head -1 >/dev/null
expect "a reader may stop early" test ! -s log
head -c 5000 out/sph.h5 >short.h5
for command in "info short.h5" "diff short.h5 out/sph.h5" "compare out/bem.h5 short.h5"; do
  # shellcheck disable=SC2086
  code 2 "$program" $command
  expect "$command: one sentence" test "$(wc -l <log)" = 1
done
exit $failed
