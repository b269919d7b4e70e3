#!/usr/bin/env bash
# Results that another program wrote: what they have is compared, what they lack is named.
source "$2/tests/cli/begin"
/usr/bin/python3 -c 'import h5py' 2>/dev/null || exit 77
pretend_gnuplot

cat >wave.yaml <<'E2'
title: A small standing wave
scales: {H: 2}
tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]}
water: {wave: {amplitude: 0.04, wavelength: 8, depth: 2}}
time: {end: 2, every: 0.1}
gauges: [{name: middle, x: 1}]
runs: [{name: theory, solver: exact, resolution: 40, order: 1}]
E2
"$program" run wave.yaml --out out -q >log 2>&1 || fail "no result: $(cat log)"
/usr/bin/python3 "$2/docs/examples/write_result.py" || fail "the example does not run"

# both are the same linear theory: only sampling keeps them apart
cat >settings.yaml <<'E2'
compare:
  times: [0.5, 1.5]
  tolerances:
    - {measure: mean_distance, max: 1e-5}
    - {measure: kinetic, max: 0.01}
    - {measure: gauge_rms, max: 1e-4}
E2
"$program" compare out/theory.h5 airy.h5 -s settings.yaml -o report >log 2>&1 || fail "theory and example: $(cat log)"
grep -q "5 of 5 checks passed" log || fail "not five checks: $(cat log)"
/usr/bin/python3 -c 'import json; run, = json.load(open("report/report.json"))["runs"]; assert run["absent"] == ["volumes"]' ||
  fail "volumes are missed"

# the least that a file must have
cat >least.py <<'E2'
import sys, h5py
with h5py.File("airy.h5") as whole, h5py.File("least.h5", "w") as f:
    for name in ("H", "g", "density", "spacing"):
        if name not in sys.argv[1:]: f.attrs[name] = whole.attrs[name]
    for name in ("surface/time", "surface/first_point", "surface/points"):
        if name not in sys.argv[1:]: f[name] = whole[name][...]
E2
/usr/bin/python3 least.py
"$program" compare out/theory.h5 least.h5 -o least >log 2>&1 || fail "the least: $(cat log)"
/usr/bin/python3 - <<'E2' || fail "the report of the least"
import json
run, = json.load(open("least/report.json"))["runs"]
assert run["absent"] == ["walls", "energies", "volumes", "gauges"], run["absent"]
assert run["health"]["verdict"] == "not known"
assert max(run["against_time"]["mean_distance"]) < 1e-5
E2
"$program" compare least.h5 out/theory.h5 -o turned >log 2>&1 || fail "as the reference: $(cat log)"
"$program" info least.h5 >log 2>&1 || fail "info: $(cat log)"
"$program" diff least.h5 least.h5 >log 2>&1 || fail "diff: $(cat log)"

refused() { # the message for a file without what is named
  local says=$1
  shift
  /usr/bin/python3 least.py "$@"
  "$program" compare out/theory.h5 least.h5 -o least >log 2>&1 && fail "$* is not missed"
  grep -qF "plunge: least.h5 $says" log || fail "without $*: $(cat log)"
}
refused 'is an HDF5 file, but no result: it has no attribute H, one of the scales H, g, density and spacing' H
refused 'is not a usable result: it has no numeric attribute "spacing"' spacing
refused 'is not a usable result: it has no dataset /surface/points' surface/points
refused 'is not a usable result: it has no group /surface' surface/time surface/first_point surface/points
/usr/bin/python3 least.py
! "$program" compare least.h5 least.h5 -o two >log 2>&1 || fail "two without walls"
grep -q "neither least.h5 nor any other file has /walls" log || fail "no walls at all: $(cat log)"

# water on the wrong side of a surface, a tank on the wrong side of its wall; particles without a field
turned() { # lines of Python that change file f, and the message, or none
  /usr/bin/python3 - "$1" <<'E2'
import sys, shutil, h5py, numpy as np
shutil.copy("airy.h5", "turned.h5")
with h5py.File("turned.h5", "r+") as f: exec(sys.argv[1])
E2
  "$program" compare out/theory.h5 turned.h5 -o turned >log 2>&1 && [ "$2" ] && fail "$1: no message"
  grep -qF "plunge: ${2:+turned.h5 }$2" log || [ -z "$2" ] || fail "$1: $(cat log)"
}
turned 'p, n = f["surface/points"], f["surface/first_point"][:]; q = p[:]
for a, b in zip(n[:-1], n[1:]): q[a:b] = q[a:b][::-1]
p[:] = q' 'is not a usable result: its surface 0 goes from the right to the left: a surface has its water on its right'
turned 'p = f["walls/points"]; p[:] = p[:][::-1]' 'is not a usable result: its wall 0 of /walls has the tank on its right: a wall goes down the left side, along the bed, and up the right side'
/usr/bin/python3 - <<'E2'
import h5py, numpy as np
with h5py.File("airy.h5") as whole, h5py.File("alone.h5", "w") as f:
    for name in ("H", "g", "density"): f.attrs[name] = whole.attrs[name]
    f.attrs["spacing"] = 0.1
    whole.copy("walls", f)
    x, y = np.meshgrid(np.arange(0.05, 4, 0.1), np.arange(0.05, 2, 0.1))
    v = f.create_group("VTKHDF")
    v["Points"] = np.stack([x.ravel(), y.ravel(), 0 * x.ravel()], 1)
    v["NumberOfPoints"] = [x.size]
    v["Steps/Values"], v["Steps/PointOffsets"] = [0.0], [0]
E2
"$program" compare out/theory.h5 alone.h5 -o alone >log 2>&1 || fail "positions alone: $(cat log)"

exit $failed
