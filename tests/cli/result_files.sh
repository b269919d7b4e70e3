#!/usr/bin/env bash
# Result files as users mishandle them: runs killed and short of room, files damaged or not results.
source "$2/tests/cli/begin"
pretend_gnuplot
# Wanted exit code, words that the one line of talk must have, then the command.
refuse() {
  local wanted=$1 words=$2 got=0
  shift 2
  "$@" >out.log 2>err.log || got=$?
  [ "$got" = "$wanted" ] || fail "exit code $got, expected $wanted: $*"
  grep -qF -- "$words" err.log || fail "$*: expected '$words' in: $(cat err.log)"
  [ "$(wc -l <err.log)" = 1 ] || fail "$*: more than one line: $(cat err.log)"
}

cat >case.yaml <<'E2'
title: A small dam break
scales: {H: 0.6}
tank:
  walls: [[[0, 2 H], [0, 0], [4 H, 0], [4 H, 2 H]]]
water:
  regions: [[[0, 0], [1 H, 0], [1 H, 1 H], [0, 1 H]]]
  pressure: released
time: {end: 20 sqrt(H/g), every: 0.002 sqrt(H/g)}
runs:
  - {name: sph, solver: sph, resolution: 20}
E2

# ---- killed: what had been put out is there, and the next run starts afresh ----
for wait in 0.2 0.35 0.5; do
  "$program" run case.yaml --out killed --force --threads 1 -q &
  pid=$!
  for _ in $(seq 300); do
    "$program" info killed/sph.h5 2>/dev/null | grep -qE '^outputs +[0-9]{2}' && break
    sleep 0.05
  done
  sleep $wait
  before=$("$program" info killed/sph.h5 | awk '/^outputs/ { print $2 }')
  kill -KILL $pid
  wait $pid 2>/dev/null
  "$program" info killed/sph.h5 >log || fail "a killed run cannot be read"
  grep -q "stopped before its end" log || fail "a killed run does not say so"
  after=$(awk '/^outputs/ { print $2 }' log)
  [ "$after" -ge "$before" ] || fail "a killed run lost outputs: $before before, $after after"
done
"$program" run case.yaml --out killed --set "time.end=0.01 sqrt(H/g)" --threads 1 -q || fail "no run after a kill"
"$program" info killed/sph.h5 | grep -q "complete" || fail "the run after a kill is not complete"
[ "$(cd killed && find . -name '*.next*' | wc -l)" = 0 ] || fail "something is left beside the file"

# ---- no room: an error, exit code 3, and the earlier outputs ----
(
  ulimit -f 600 # blocks of 1 kB
  refuse 3 "it needs" "$program" run case.yaml --out limited --threads 1 -q
  exit $failed
) || failed=1
"$program" info limited/sph.h5 | grep -qE '^outputs +[0-9]{2}' || fail "outputs before the limit are lost"
refuse 3 "/proc/nowhere" "$program" run case.yaml --out /proc/nowhere -q

# ---- damaged, and not a result ----
good=killed/sph.h5
size=$(stat -c %s "$good")
mkdir directory
: >empty.h5
echo "title: text" >text.h5
head -c 4000 /dev/urandom >noise.h5
for part in 10 500 5000 $((size / 2)) $((size - 1)); do head -c "$part" "$good" >"short_$part.h5"; done
for at in 20 700 $((size / 3)) $((size - 40)); do
  cp "$good" "flip_$at.h5"
  byte=$(od -An -tu1 -j "$at" -N 1 "$good")
  # shellcheck disable=SC2059
  printf "\\x$(printf %x $((byte ^ 64)))" | dd of="flip_$at.h5" bs=1 seek="$at" conv=notrunc status=none
done
# Without its last byte the file has lost its checksum but no data: it is read like any other.
"$program" info "short_$((size - 1)).h5" >/dev/null || fail "a file without its checksum cannot be read"
rm "short_$((size - 1)).h5"
for bad in missing.h5 directory empty.h5 text.h5 noise.h5 short_*.h5 flip_*.h5; do
  refuse 2 "$bad" "$program" info "$bad"
  refuse 2 "$bad" "$program" diff "$good" "$bad"
  refuse 2 "$bad" "$program" diff "$bad" "$good"
  refuse 2 "$bad" "$program" compare "$good" "$bad" --out report
  refuse 2 "$bad" "$program" compare "$bad" "$good" --out report
done
exit $failed
