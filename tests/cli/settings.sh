#!/usr/bin/env bash
# plunge compare --settings: times, window, tolerances, averages, filters and spectra of one's own, checked with line
# numbers against the results; and what `plunge list` says of variants.
source "$2/tests/cli/begin"
pretend_gnuplot
compare() { # wanted exit code
  local wanted=$1 got=0
  "$program" compare out/a.h5 out/b.h5 --settings settings.yaml --out own >log 2>&1 || got=$?
  [ "$got" = "$wanted" ] || fail "exit code $got, expected $wanted: $(cat log)"
}

cat >wave.yaml <<'E2'
title: Two theories of a wave
scales: {H: 2}
tank:
  walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]
water:
  wave: {amplitude: 0.04, wavelength: 4, depth: 2}
time: {end: 0.4, every: 0.1}
probes: [{name: P, at: [0, 1]}]
runs:
  - {name: a, solver: exact, resolution: 8}
  - {name: b, solver: exact, resolution: 8, order: 1}
E2
"$program" run wave.yaml --out out -q >log 2>&1 || fail "no results: $(cat log)"

printf '\xef\xbb\xbfcompare:\n  times: [0.2 s, 0.4]\n  window: [[0, 0.5 H], [1 H, 2 H]]\n  tolerances:\n    - {measure: mean_distance, max: 0.5, runs: [b]}\n' >settings.yaml
compare 0
grep -q "2 of 2 checks passed" log || fail "not two checks at two times: $(cat log)"
printf 'compare:\n  times: [0.2]\n  tolerances: [{measure: mean_distance, max: 1e-12}]\n' >settings.yaml
compare 1
printf 'compare: {}\n' >settings.yaml
compare 0
! grep -q '"averaged_over": 0.1' own/report.json || fail "a mean nobody asked for"
printf 'compare: {averages: [{probe: P, over: 0.1 sqrt(H/g)}]}\n' >settings.yaml
compare 0
grep -q '"averaged_over": 0.1' own/report.json || fail "the probe is not averaged"
printf 'compare:\n  filters: [{probe: P, kind: low_pass, period: 0.1}, {probe: P, kind: wall, length: 1}]\n  spectra: [{series: P}]\n' >settings.yaml
compare 0
grep -q '"says": "low pass at periods of 0.2215' own/report.json || fail "the probe is not filtered"
grep -q '"mean_square": [0-9]' own/report.json || fail "the probe has no spectrum"
printf 'compare:\n  filters: [{probe: Q, kind: impulse}, {probe: P, kind: low_pass, period: 1}]\n  spectra: [{series: P.p}]\n' >settings.yaml
compare 2
diff - log <<'E2' || fail "other messages"
settings.yaml:2: compare.filters[0].probe: found 'Q'; allowed: one of the probes P
settings.yaml:2: compare.filters[1].period: found 1 s; allowed: at most the reference's last output, 0.4 s; make it smaller
settings.yaml:3: compare.spectra[0].series: found 'P.p'; allowed: one of P
E2

cat >settings.yaml <<'E2'
compare:
  reference: a
  times: [0.15, 0.3, 0.2]
  window: [[9 H, 0], [10 H, 2 H]]
  tolerances:
    - {measure: mean_distanse, max: 1}
    - {measure: mean_distance, max: 1, runs: [c]}
    - {measure: mean_distance, max: 1, at: 0.25}
  averages: [{probe: P, over: 0.5}, {probe: R, over: 0.1}]
  profiles: [{file: nope.txt, time: 0.1, label: none, source: nobody}]
E2
compare 2
sed -i "s/allowed: one of mean_distance[^;]*/allowed: one of WHATEVER/" log
diff - log <<'E2' || fail "other messages"
settings.yaml:2: compare.reference: found a key of a case; allowed: none, the reference is the first file; remove it
settings.yaml:3: compare.times[0]: found 0.15 s; allowed: an output time of the reference; the nearest is 0.1 s
settings.yaml:3: compare.times[2]: found 0.2 s; allowed: times that increase; put them in order
settings.yaml:4: compare.window: found a window without any of the tank in it; allowed: part of the tank; move it
settings.yaml:6: compare.tolerances[0].measure: found 'mean_distanse'; allowed: one of WHATEVER; did you mean 'mean_distance'?
settings.yaml:7: compare.tolerances[1].runs[0]: found 'c'; allowed: one of the runs a, b
settings.yaml:8: compare.tolerances[2].at: found 0.25 s; allowed: one of compare.times; add it there or change it
settings.yaml:9: compare.averages[1].probe: found 'R'; allowed: one of the probes P
settings.yaml:9: compare.averages[0].over: found 0.5 s; allowed: at most the reference's last output, 0.4 s; make it smaller
settings.yaml:10: compare.profiles: found a key of a case; allowed: none, they are in the reference's file; remove it
E2
# times are answered in the unit that they are asked in
printf 'compare:\n  times: [0.5 sqrt(H/g), 150 ms]\n' >settings.yaml
compare 2
sed -i 's/[0-9.]* sqrt(H.g)$/X sqrt(H\/g)/' log
diff - log <<'E2' || fail "other messages"
settings.yaml:2: compare.times[0]: found 0.5 sqrt(H/g); allowed: an output time of the reference; the nearest is X sqrt(H/g)
settings.yaml:2: compare.times[1]: found 150 ms; allowed: an output time of the reference; the nearest is 100 ms
E2
printf 'times: [0.2]\ntolerances: [{measure: mean_distance, max: 1}]\n' >settings.yaml # the section without its name
compare 2
diff - log <<'E2' || fail "no one hint"
settings.yaml:1: times: found a key of the section `compare`, outside of it; allowed: compare; write `compare:` on a line above and indent what follows
E2

# ---- other water is refused, or compared all the same and said first ----
sed 's/amplitude: 0.04/amplitude: 0.05/' wave.yaml >other.yaml
"$program" run other.yaml --out other -q >log 2>&1 || fail "no results: $(cat log)"
"$program" compare out/a.h5 other/b.h5 --out own >log 2>&1 && fail "other water is compared"
grep -q "other/b.h5 has another water at t = 0 than the reference out/a.h5.*--anyway compares them" log || fail "refused: $(cat log)"
"$program" compare out/a.h5 other/b.h5 --anyway --out own >log 2>&1 || fail "--anyway: $(cat log)"
grep -q "^b .* is not of the tank, water and scales of a, and compared all the same" log || fail "--anyway says: $(cat log)"
grep -q "is not of the tank, water and scales of a, and compared" own/report.html || fail "the report does not say that the water is another"

for odd in /dev/zero nowhere.yaml; do
  cp /dev/null settings.yaml
  got=0
  timeout 20 "$program" compare out/a.h5 out/b.h5 --settings $odd >log 2>&1 || got=$?
  [ $got = 2 ] && [ "$(wc -l <log)" = 1 ] || fail "$odd: exit code $got: $(cat log)"
done
cp wave.yaml settings.yaml # a case is not settings
compare 2
grep -q "settings.yaml:1: title: found an unknown key; allowed: compare" log || fail "a case as settings: $(cat log)"
: >settings.yaml
compare 2
grep -q "settings.yaml: found no keys; allowed: a mapping with the section compare" log || fail "empty settings: $(cat log)"

"$program" list >log
for words in "rk4-frozen  *classic Runge-Kutta, diffusion" "antuono  *Antuono et al. 2010" "mirror  *mirror images" \
  "released  *that just after the gate"; do
  grep -qE "^ +$words" log || fail "plunge list does not explain '$words'"
done
got=$("$program" run wave.yaml --set 'gauges[0].x=3' 2>&1)
[ "$got" = "--set gauges[0].x=3: found no list 'gauges' in the case; allowed: items of a list that is there; set the list as a whole" ] ||
  fail "--set of an item without a list: $got"
exit $failed
