#!/usr/bin/env bash
# The report's page shows the water in spite of particles that have escaped, have no position or cannot be read, and says so.
source "$2/tests/cli/begin"
pretend_gnuplot
python=/usr/bin/python3
$python -c 'import h5py' 2>/dev/null || {
  echo "python3-h5py is not installed"
  exit 77
}

small_dam 3 0.4 0.1 <<'E2'
runs:
  - {name: bem, solver: bem, resolution: 15}
  - {name: sph, solver: sph, resolution: 15}
compare:
  reference: bem
E2
"$program" run dam.yaml --out . --threads 1 --no-report -q >log 2>&1 || fail "no run: $(cat log)"
cp sph.h5 cut.h5
cp sph.h5 whole.h5

cat >page.py <<'E2'
import base64, json, sys, zlib
import h5py, numpy
H = 0.6
page = open(sys.argv[1] + "/report.html").read()
start = page.index('id="pack-data">') + 15
pack = json.loads(page[start:page.index("</script>", start)])
points = pack["runs"][1]["points"]

def columns(planes):
    raw, n = numpy.frombuffer(zlib.decompress(base64.b64decode(planes["data"])), numpy.uint8), planes["n"]
    for k, (lo, hi, steps) in enumerate(zip(planes["lo"], planes["hi"], planes["steps"])):
        folded = raw[2 * n * k:][:n].astype(int) | raw[2 * n * k + n:][:n].astype(int) << 8
        value = numpy.cumsum((folded >> 1) ^ -(folded & 1)) & 0xffff
        yield numpy.where(value == 0xffff, numpy.nan, lo + (hi - lo) / steps * value)

E2

# ---- one flies off, two have no position: all others are where they were, to a fifth of a millimetre ----
$python - <<'E2' || fail "no made-up particles"
import h5py
with h5py.File("sph.h5", "r+") as f:
    last = int(f["VTKHDF/Steps/PointOffsets"][-1])
    points = f["VTKHDF/Points"]
    points[last + 3] = [6e5, -3e7, 0]
    points[last + 7] = [float("nan"), 0.1, 0]
    points[last + 20] = [0.1, float("inf"), 0]
E2
"$program" compare bem.h5 sph.h5 --out escaped >log 2>&1 || fail "no report of escaped particles: $(cat log)"
(cat page.py && cat <<'E2') >check.py
with h5py.File("whole.h5") as f:
    first, n = int(f["VTKHDF/Steps/PointOffsets"][-1]), int(f["VTKHDF/NumberOfPoints"][-1])
    all = numpy.delete(numpy.array(f["VTKHDF/Points"][first:first + n, :2]) / H, [3, 7, 20], axis=0)
x, y = list(columns(points[-1]["planes"]))[:2]
assert len(x) == n - 3, (len(x), n)
far = [numpy.hypot(x - a, y - b).min() for a, b in all]
assert max(far) < 0.0003 / H, max(far)
says = "Particles of sph without a position, or further from the tank than it is large, are left out: at most 3 of an output."
assert says in pack["thinned"], pack["thinned"]
E2
$python check.py escaped || fail "escaped particles"

# ---- positions of an output are damaged: the page is there without particles ----
$python - <<'E2' || fail "no damage"
import h5py
with h5py.File("cut.h5", "r+") as f:
    f["VTKHDF/Steps/PointOffsets"][-1] = 10**9
E2
"$program" compare bem.h5 cut.h5 --out cut >log 2>&1 || fail "no report of particles that cannot be read: $(cat log)"
(cat page.py && echo 'assert points == [] and "Particles of sph are left out: cut.h5, output 4: " in pack["thinned"], pack["thinned"]') >check.py
$python check.py cut || fail "particles that cannot be read"
exit $failed
