#!/usr/bin/env bash
# A result that has particles and no surface is compared by the surface that is found of them: the same as that of
# a run that found it itself; walls are those of the other file where it has none.
source "$2/tests/cli/begin"
/usr/bin/python3 -c 'import h5py' 2>/dev/null || { echo "skipped: no h5py"; exit 77; }
pretend_gnuplot

cat >dam.yaml <<'E2'
scales: {H: 0.6}
tank: {walls: [[[0, 4 H], [0, 0], [5.366 H, 0], [5.366 H, 4 H]]]}
water: {regions: [[[0, 0], [2 H, 0], [2 H, H], [0, H]]]}
time: {end: 1 sqrt(H/g), every: 0.5 sqrt(H/g)}
runs: [{name: dam, solver: sph, resolution: 12}]
E2
"$program" run dam.yaml --out out -q >log 2>&1 || fail "no run: $(cat log)"
cat >strip.py <<'E2'
import sys, h5py
name, *drop = sys.argv[1:]
with h5py.File("out/dam.h5") as a, h5py.File(name + ".h5", "w") as b:
    for key in ("H", "g", "density", "spacing"): b.attrs[key] = a.attrs[key]
    for key in ("walls", "VTKHDF"):
        if key not in drop: a.copy(key, b)
    for field in drop:
        if field in b["VTKHDF/PointData"]: del b["VTKHDF/PointData"][field]
E2
cat >settings.yaml <<'E2'
compare:
  times: [0.5 sqrt(H/g), 1 sqrt(H/g)]
  tolerances: [{measure: largest_distance, max: 1e-9}]
E2
try() { # name, what is left out: the particles of a run have equal areas, so their surface needs none
  /usr/bin/python3 strip.py "$@" || fail "no $1"
  "$program" compare out/dam.h5 "$1.h5" -s settings.yaml -o report >log 2>&1 || fail "$1: $(cat log)"
  grep -q "the surface of $1 is found from its particles" log || fail "$1: not told: $(cat log)"
  grep -q "2 of 2 checks passed" log || fail "$1: $(cat log)"
  grep -q '"surface": "found from the particles"' report/report.json || fail "$1: not in report.json"
}
try bare pressure density mass volume velocity
try no-walls walls pressure density mass volume velocity
# with areas of their own the surface differs by what compression makes of it, a small part of a spacing
sed -i 's/1e-9/0.002/' settings.yaml
try areas pressure
/usr/bin/python3 strip.py reference walls volume mass density
"$program" compare reference.h5 out/dam.h5 -o report >log 2>&1 || fail "as the reference: $(cat log)"

# particles that have escaped, or are nowhere, are as if they were not there
/usr/bin/python3 - <<'E2'
import h5py, shutil
shutil.copy("bare.h5", "fewer.h5")
with h5py.File("bare.h5", "a") as f:
    p = f["VTKHDF/Points"]
    q = p[:]; q[-1] = [1e5, 0, 0]; q[-2] = [float("nan"), 0, 0]
    p[:] = q
with h5py.File("fewer.h5", "a") as f:
    n = f["VTKHDF/NumberOfPoints"]
    n[-1] = n[-1] - 2
E2
sed -i 's/0.002/1e-9/' settings.yaml
"$program" compare fewer.h5 bare.h5 -s settings.yaml -o report >log 2>&1 || fail "escaped particles: $(cat log)"
grep -q "2 of 2 checks passed" log || fail "escaped particles: $(cat log)"
! "$program" compare out/dam.h5 bare.h5 -s settings.yaml -o report >log 2>&1 || fail "the two particles are not missed"
# without walls anywhere nothing can be compared
/usr/bin/python3 strip.py lone walls
! "$program" compare lone.h5 reference.h5 -o report >log 2>&1 || fail "no walls anywhere"
grep -q "neither lone.h5 nor any other file has /walls" log || fail "no walls anywhere: $(cat log)"

# a diff finds the surfaces of particles, too, and draws them
/usr/bin/python3 strip.py left pressure
/usr/bin/python3 strip.py right pressure
/usr/bin/python3 - <<'E2'
import h5py
with h5py.File("right.h5", "a") as f:
    p = f["VTKHDF/Points"]
    p[:] = p[:] * [1, 0.99, 1]
E2
"$program" diff left.h5 right.h5 --out apart >log 2>&1
[ $? = 1 ] || fail "particles that differ: $(cat log)"
ls apart/figures/overlay*.gp >/dev/null 2>&1 || fail "a diff of particles draws no surface: $(ls apart apart/figures)"

# periodic sides, which the case in the file tells of: water goes on beyond them
cat >round.yaml <<'E2'
scales: {H: 0.6}
tank: {walls: [[[0, 2 H], [0, 0], [3 H, 0], [3 H, 2 H]]], sides: periodic}
water: {regions: [[[0, 0], [1 H, 0], [1 H, H], [0, H]]]}
time: {end: 0.5 sqrt(H/g), every: 0.5 sqrt(H/g)}
runs: [{name: round, solver: sph, resolution: 12}]
E2
"$program" run round.yaml --out out -q >log 2>&1 || fail "no run: $(cat log)"
cat >round-settings.yaml <<'E2'
compare:
  times: [0.5 sqrt(H/g)]
  tolerances: [{measure: largest_distance, max: 1e-9}]
E2
/usr/bin/python3 - <<'E2'
import h5py, shutil
fields = ["surface"] + ["VTKHDF/PointData/" + s for s in ("volume", "mass", "density")]
for name, drop in ("told", fields), ("untold", fields + ["case"]):
    shutil.copy("out/round.h5", name + ".h5")
    with h5py.File(name + ".h5", "a") as f:
        f.attrs["run"] = name
        for key in drop: del f[key]
E2
"$program" compare out/round.h5 told.h5 -s round-settings.yaml -o report >log 2>&1 || fail "periodic sides: $(cat log)"
grep -q "1 of 1 checks passed" log || fail "periodic sides: $(cat log)"
"$program" compare out/round.h5 untold.h5 -s round-settings.yaml -o report >log 2>&1
grep -q "0 of 1 checks passed" log || fail "nothing tells of periodic sides, and the surface is the same: $(cat log)"

# a film, too: a frame for each output
"$program" movie left.h5 right.h5 --out film >log 2>&1 || fail "a film of particles: $(cat log)"
grep -q "the surface of left is found from its particles" log || fail "a film of particles: not told: $(cat log)"
[ "$(ls film)" = "frame-00001.png
frame-00002.png
frame-00003.png" ] || fail "a film of particles: $(ls film)"
/usr/bin/python3 strip.py unwalled walls
! "$program" movie unwalled.h5 --out nothing >log 2>&1 || fail "a film without walls"
grep -q "and no file has /walls, without which its particles show none" log || fail "a film without walls: $(cat log)"

# names and types that other programs may leave
named() { # name of the run, what is wanted of it in the report
  /usr/bin/python3 - "$1" <<'E2'
import h5py, sys
with h5py.File("left.h5", "a") as f: f.attrs["run"] = sys.argv[1]
E2
  "$program" compare out/dam.h5 left.h5 -o report >log 2>&1 || fail "a run named '$1': $(cat log)"
  grep -qF -- "$2" report/report.json || fail "a run named '$1' is not $2"
}
named "" '"label": "left"'
named "  " '"label": "left"'
named "$(printf 'x%.0s' $(seq 80))" "$(printf 'x%.0s' $(seq 57))…"
named "$(printf 'ä%.0s' $(seq 40))" "$(printf 'ä%.0s' $(seq 28))…"
named "=1+cmd|' /C calc'!A0" '=1+cmd'
grep -hF '=1+cmd' report/figures/*.csv >cells || fail "the name is in no table"
grep -qE "(^|,)\"?[=]" cells && fail "a cell is a formula: $(head -2 cells)"
/usr/bin/python3 - <<'E2'
import h5py, numpy
with h5py.File("left.h5", "a") as f:
    n = len(f["VTKHDF/Points"])
    del f["VTKHDF/Points"]
    f["VTKHDF/Points"] = numpy.full((n, 3), b"1")
E2
! "$program" compare out/dam.h5 left.h5 -o report >log 2>&1 || fail "texts for places"
grep -q "VTKHDF/Points has values of another type: numbers are needed" log || fail "texts for places: $(cat log)"
exit $failed
