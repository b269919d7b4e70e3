#!/usr/bin/env bash
# Signals end the program at once wherever it is, and a folder belongs to one process at a time.
source "$2/tests/cli/begin"

cat >slow.yaml <<'E2'
scales: {H: 0.6}
tank:
  walls: [[[0, 2 H], [0, 0], [4 H, 0], [4 H, 2 H]]]
water:
  regions: [[[0, 0], [1 H, 0], [1 H, 1 H], [0, 1 H]]]
  pressure: released
time: {end: 5 sqrt(H/g), every: 0.001 sqrt(H/g)}
runs:
  - {name: sph, solver: sph, resolution: 700}
E2
sed 's/resolution: 700/resolution: 20/' slow.yaml >quick.yaml

# Sends a signal to $pid; it must be gone within ten seconds (sanitizers are slow), with exit code 3.
end_with() {
  local signal=$1 got=0
  kill "-$signal" $pid
  for _ in $(seq 100); do
    kill -0 $pid 2>/dev/null || break
    sleep 0.1
  done
  kill -0 $pid 2>/dev/null && {
    fail "$signal is not heard"
    kill -KILL $pid
  }
  wait $pid 2>/dev/null || got=$?
  [ $got = 3 ] || fail "$signal: exit code $got: $(cat log)"
}

# ---- during the set-up of half a million particles, which is not asked whether to stop ----
for signal in TERM INT HUP; do
  rm -rf slow
  "$program" run slow.yaml --out slow --threads 1 >log 2>&1 &
  pid=$!
  wait_for slow/sph.h5
  end_with $signal
  grep -q "plunge: stopped" log || fail "$signal: no word: $(cat log)"
done

# ---- during a run, which writes its last output ----
"$program" run quick.yaml --out run --threads 1 >log 2>&1 &
pid=$!
for _ in $(seq 400); do
  "$program" info run/sph.h5 2>/dev/null | grep -qE '^outputs +[0-9]{2}' && break
  sleep 0.05
done

# ---- meanwhile the folder is taken ----
got=0
"$program" run quick.yaml --out run >second 2>&1 || got=$?
[ $got = 3 ] && grep -q "another plunge" second && grep -q "process $pid)" second ||
  fail "a second run in the same folder: exit code $got, $(cat second)"
[ -e run/report.html ] && fail "a report about half a run"
"$program" run quick.yaml --out run --wait -q --set "time.end=0.01 sqrt(H/g)" >third 2>&1 &
waiting=$!
end_with HUP
wait $waiting || fail "the one that waited fails: $(cat third)"
"$program" info run/sph.h5 | grep -q complete || fail "the one that waited did not run"

# ---- while comparing; an old log would say too early that it is ----
rm log
"$program" compare run/sph.h5 run/sph.h5 --out compared >log 2>&1 &
pid=$!
wait_for log
end_with TERM
[ -e compared/report.html ] && fail "a stopped comparison leaves a report"
exit $failed
