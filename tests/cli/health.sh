#!/usr/bin/env bash
# A run that ends well and is nonsense is a failure: exit code 3 and the reason, now and when it is
# found there again; `info` and the file say so too. A sound run says what it is judged by.
source "$2/tests/cli/begin"
pretend_gnuplot

cat >case.yaml <<'END'
scales: {H: 1}
tank: {walls: [[[0, 2], [0, 0], [3, 0], [3, 2]]]}
water: {regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]], pressure: released}
time: {end: 1.5 sqrt(H/g), every: 0.25 sqrt(H/g)}
runs:
  - {name: slow, solver: sph, resolution: 10, c0: 5} # falling water is nearly as fast as its sound
  - {name: usual, solver: sph, resolution: 10}
compare: {reference: usual}
END

"$program" run --quiet --out out case.yaml 2>err >said
[ $? = 3 ] || fail "exit code of a run that is not to be believed"
grep -q "run slow: its result is not to be believed: speeds reach .*volume changes by" err || fail "no reason: $(cat err)"
grep -q usual err && fail "the sound run is blamed: $(cat err)"

"$program" run --out out case.yaml 2>err >said
[ $? = 3 ] || fail "exit code when it is there already"
"$program" run --out out --only usual --force case.yaml 2>err >said
grep -q "^usual *sound: .*budget" err || fail "no facts of the sound run: $(cat err)"

"$program" info out/slow.h5 | grep -A2 "^health *failed: .*volume" | grep -q "speeds reach" || fail "info of slow"
"$program" info out/usual.h5 | grep -q "^health *sound: " || fail "info of usual"
exit $failed
