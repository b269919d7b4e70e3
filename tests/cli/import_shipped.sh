#!/usr/bin/env bash
# The results of other programs that are shipped become results, with surfaces that stand where those programs left
# their water, and go into one report.
source "$2/tests/cli/begin"
pretend_gnuplot
"$program" check "$2/cases/imports/dam-break.yaml" >log 2>&1 || fail "the case: $(cat log)"
for sidecar in "$2"/cases/imports/*.yaml; do
  name=$(basename "$sidecar" .yaml)
  [ "$name" = dam-break ] && continue
  "$program" import "$sidecar" >log 2>&1 || fail "$name: $(cat log)"
  [ -s "$name.h5" ] || fail "$name: no result"
done
"$program" compare dualsphysics-100.h5 dualsphysics-50.h5 -o report >log 2>&1 || fail "no report: $(cat log)"
/usr/bin/python3 - <<'E2' || fail "the report"
import json
run, = json.load(open("report/report.json"))["runs"]
assert run["imported"].startswith("by plunge") and run["solver"] == "DualSPHysics 5.4"
assert run["absent"] == ["energies", "volumes"], run["absent"]
first = run["against_time"]["mean_distance"][0]  # at t sqrt(g/H) = 2, before the water is at the right wall
assert 0.005 < first < 0.015, first  # half a coarse spacing: what lies below the water is twice as thick
E2
if /usr/bin/python3 -c 'import h5py' 2>/dev/null; then
  /usr/bin/python3 - <<'E2' || fail "the surfaces"
import h5py
for name, outputs, n, gap in (("dualsphysics-50", 7, 5000, 0.015), ("dualsphysics-100", 3, 20000, 0.0075)):
    f = h5py.File(name + ".h5"); s = f["surface"]
    assert len(s["time"]) == outputs and list(f["VTKHDF/NumberOfPoints"][:]) == [n] * outputs
    assert abs(s["time"][-1] - 6 * (0.6 / 9.81) ** 0.5) < 1e-4
    for k in range(outputs):
        a = int(s["first_piece"][k]); i, j = s["first_point"][a:a + 2].tolist()
        p = s["points"][i:j]
        assert s["closed"][a] == 0 and abs(p[0][0] - gap) < 1e-9, (name, k, p[0])  # from the left wall, less the gap
        ends = min(abs(p[-1][1] - gap), abs(p[-1][0] - (5.366 * 0.6 - gap)))
        assert ends < 1e-9, (name, k, p[-1])  # on the bed, or on the right wall
s = h5py.File("interfoam-25.h5")["surface"]
a, b = s["first_piece"][-2:].tolist(); f, p = s["first_point"][:].tolist(), s["points"][:]
assert s["closed"][a:b].tolist() == [0, 0, 1]  # of the last surface: the main one, a blob on the wall, the cavity
q = p[f[b - 1]:f[b]]
area = sum(u[0] * v[1] - v[0] * u[1] for u, v in zip(q, list(q[1:]) + [q[0]])) / 2
assert 0.05 < area < 0.0976, area  # m^2, counter-clockwise; most of its box of 0.326 m x 0.299 m
E2
fi
exit $failed
