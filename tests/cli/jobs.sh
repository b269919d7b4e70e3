#!/usr/bin/env bash
# Runs side by side, each in a process of its own: the same results as one by one, and whatever happens to
# one of them leaves the others alone.
source "$2/tests/cli/begin"
pretend_gnuplot

small_dam 4 0.5 0.05 <<'E'
runs:
  - {name: bem, solver: bem, resolution: 15}
  - {name: one, solver: sph, resolution: 15}
  - {name: two, solver: sph, resolution: 20}
compare: {reference: bem}
E
sed 's/end: 0.5/end: 50/; s/every: 0.05/every: 0.01/' dam.yaml >long.yaml

# The processes of $pid that work on runs, when there are as many as $1.
children=()
wait_for_children() {
  for _ in $(seq 400); do
    mapfile -t children < <(pgrep -P $pid)
    [ ${#children[@]} = "$1" ] && return
    sleep 0.05
  done
  fail "no $1 processes"
}
wait_for_outputs() { # of a file
  for _ in $(seq 400); do
    "$program" info "$1" 2>/dev/null | grep -qE '^outputs +([2-9]|[0-9]{2})' && return
    sleep 0.05
  done
  fail "no outputs in $1"
}
gone() { # nothing of $pid's children is left
  for child in "${children[@]}"; do
    for _ in $(seq 100); do
      kill -0 "$child" 2>/dev/null || break
      sleep 0.05
    done
    kill -0 "$child" 2>/dev/null && fail "$1: an orphan"
  done
}

# ---- the same bits; quiet is silent ----
"$program" run dam.yaml --out alone --jobs 1 2>log >/dev/null || fail "one by one: $(cat log)"
grep -q "at a time" log && fail "--jobs 1: $(cat log)"
"$program" run dam.yaml --out beside --jobs 3 2>log >/dev/null || fail "side by side: $(cat log)"
grep -q "^3 runs, 3 at a time" log || fail "no word of three at a time: $(cat log)"
for run in bem one two; do
  "$program" diff alone/$run.h5 beside/$run.h5 >diff || fail "$run is another side by side: $(cat diff)"
  grep -qE "^$run +done" log || fail "no word of $run: $(cat log)"
done
[ -s beside/report.html ] || fail "no report"
"$program" run dam.yaml --out silent --jobs 3 --quiet 2>log >/dev/null || fail "quiet: $(cat log)"
[ -s log ] && fail "--quiet talks: $(cat log)"
"$program" run dam.yaml --jobs 0 >log 2>&1
[ $? = 2 ] || fail "--jobs 0 is taken"

# ---- bound to processors, each to its own ----
if [ "$(nproc)" -gt 1 ]; then
  OMP_NUM_THREADS=2 OMP_PROC_BIND=true "$program" run long.yaml --only one,two --jobs 2 --out bound >log 2>&1 &
  pid=$!
  wait_for_children 2
  wait_for_outputs bound/one.h5
  wait_for_outputs bound/two.h5
  at=$(for child in "${children[@]}"; do grep Cpus_allowed_list: /proc/"$child"/status; done | sort -u | wc -l)
  [ "$at" = 2 ] || fail "bound, both runs are on one processor"
  kill -TERM $pid
  wait $pid 2>/dev/null
  gone TERM
fi

# ---- one that fails, among others: its file cannot be written ----
mkdir -p failing/one.h5
got=0
"$program" run dam.yaml --out failing --jobs 2 >log 2>&1 || got=$?
[ $got = 3 ] || fail "a failing run: exit code $got: $(cat log)"
[ "$(grep -c "^plunge: run one: " log)" = 1 ] || fail "not one word of the failure: $(cat log)"
for run in bem two; do "$program" info failing/$run.h5 | grep -q complete || fail "$run is not finished"; done

# ---- one that crashes, and one that is killed ----
for signal in SEGV KILL; do
  nm "$program" | grep -q __asan_init && [ $signal = SEGV ] && continue # sanitizers catch it
  "$program" run long.yaml --only one,two --jobs 2 --out crash --force >log 2>&1 &
  pid=$!
  wait_for_children 2
  wait_for_outputs crash/one.h5
  wait_for_outputs crash/two.h5
  kill -$signal "${children[0]}"
  for _ in $(seq 100); do
    grep -q "^plunge: run .*: its process" log && break
    sleep 0.05
  done
  kill -0 "${children[1]}" 2>/dev/null || fail "$signal: the other run ended too"
  kill -TERM $pid
  got=0
  wait $pid || got=$?
  [ $got = 3 ] || fail "$signal: exit code $got"
  [ "$(grep -c "^plunge: run .*: its process" log)" = 1 ] || fail "$signal: $(cat log)"
  for run in one two; do # numbers of processes begin again some day: the first may be of either
    "$program" info crash/$run.h5 >/dev/null || fail "$signal: the file of $run cannot be read"
  done
  gone $signal
done

# ---- told to stop: each writes its last output ----
"$program" run long.yaml --only one,two --jobs 2 --out stop --force >log 2>&1 &
pid=$!
wait_for_children 2
wait_for_outputs stop/one.h5
wait_for_outputs stop/two.h5
kill -INT $pid
got=0
wait $pid || got=$?
[ $got = 3 ] || fail "stopped: exit code $got"
for run in one two; do
  grep -qE "^$run +stopped" log || fail "$run: no word that it stopped: $(cat log)"
  "$program" info stop/$run.h5 | grep -q "stopped before its end" || fail "$run did not end as asked"
done
[ "$(grep -c "^plunge: stopped" log)" = 1 ] || fail "stopped, not once: $(cat log)"
gone INT

# ---- the parent killed: no orphans ----
"$program" run long.yaml --only one,two --jobs 2 --out killed --force >log 2>&1 &
pid=$!
wait_for_children 2
kill -KILL $pid
wait $pid 2>/dev/null
gone KILL
exit $failed
