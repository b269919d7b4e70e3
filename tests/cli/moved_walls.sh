#!/usr/bin/env bash
# Walls that have moved are drawn at their place, by `plunge run` and by `plunge compare` alike.
source "$2/tests/cli/begin"
pretend_gnuplot

cat >piston.yaml <<'E2'
title: A piston beside a beach
scales: {H: 2}
tank:
  walls: [[[0, 4], [0, 0], [8, 0], [12, 2], [12, 4]]]
  motions: [{kind: piston, side: left, amplitude: 0.5, period: 2, ramp: 0.5}]
water: {wave: {kind: still, depth: 2}}
time: {end: 0.5, every: 0.25}
runs:
  - {name: a, solver: sph, resolution: 6}
  - {name: b, solver: sph, resolution: 5}
compare: {times: [0.25, 0.5]}
E2
"$program" run piston.yaml --out out -q >log 2>&1 || fail "run: $(cat log)"
"$program" compare out/a.h5 out/b.h5 -o again >log 2>&1 || fail "compare: $(cat log)"
drawn() { grep '"tank"' "$1/figures/overlay-t1.107-surfaces.csv" | head -2 | cut -d, -f4 | sort -u; }
[ "$(drawn out)" = 0.25 ] || fail "0.5 m at t = 0.5 s, the end of the ramp: drawn at $(drawn out) H"
for file in out/figures/*.csv; do
  cmp "$file" "again/figures/${file##*/}" || fail "compare draws ${file##*/} otherwise"
done

# also by settings of their own, which say nothing of walls
printf 'compare: {times: [0.25, 0.5]}\n' >settings.yaml
"$program" compare out/a.h5 out/b.h5 -s settings.yaml -o told >log 2>&1 || fail "compare -s: $(cat log)"
[ "$(drawn told)" = 0.25 ] || fail "compare -s draws the piston at $(drawn told) H"

exit $failed
