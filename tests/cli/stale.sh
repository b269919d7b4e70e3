#!/usr/bin/env bash
# A report is made of files that belong to one case as it is now: others are left out and named.
source "$2/tests/cli/begin"
pretend_gnuplot
run() { # wanted exit code, then the arguments; what is said is in `log`
  local wanted=$1 got=0
  shift
  "$program" run wave.yaml --out out -q "$@" >log 2>&1 || got=$?
  [ "$got" = "$wanted" ] || fail "exit code $got, expected $wanted: $*: $(cat log)"
}
said() {
  grep -qF -- "$1" log || fail "expected '$1' in: $(cat log)"
}

cat >wave.yaml <<'E2'
title: Two theories of a wave
scales: {H: 1}
tank:
  walls: [[[0, 1.5], [0, 0], [2, 0], [2, 1.5]]]
water:
  wave: {amplitude: 0.02, wavelength: 2, depth: 1}
time: {end: 0.4, every: 0.2, sample: 0.1}
runs:
  - {name: a, solver: exact, resolution: 8}
  - {name: b, solver: exact, resolution: 8, order: 1}
  - {name: c, solver: exact, resolution: 10}
E2
run 0
grep -q "left out" log && fail "something is left out of the first report: $(cat log)"
[ -s out/report.json ] || fail "no report"

# ---- other water: only b is of it, and there is nothing to compare it with ----
rm out/report.json
run 0 --only b --set water.wave.amplitude=0.03
said "out/a.h5 is of other water, another tank or other scales: left out of the comparison; run a again"
said "out/c.h5 is of other water, another tank or other scales"
[ -e out/report.json ] && fail "new water is compared with old"
said "out/report.html is of an earlier comparison"

# ---- b and its reference of the new water, c of the old ----
run 0 --only a,b --set water.wave.amplitude=0.03
said "out/c.h5 is of other water"
[ -s out/report.json ] || fail "no report of a and b"
grep -q '"run": "c"' out/report.json && fail "c is in the report"

# ---- the same water, other options or times ----
run 0
run 0 --only b --set runs.c.resolution=12
said "out/c.h5 was run with other times, probes, gauges, points or options, or by another version of plunge"
run 0 --only b --set time.every=0.1
said "out/a.h5 was run with other times"

# ---- everything again: nothing is stale ----
run 0
grep -q "left out" log && fail "something is left out of the last report: $(cat log)"
run 2 --only nosuch
said "its runs are a, b, c"
exit $failed
