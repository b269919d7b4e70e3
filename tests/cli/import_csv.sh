#!/usr/bin/env bash
# Text files become results: a small standing wave as several dialects of CSV have it agrees with theory, whatever
# the units, the offset and the origin; particles get a surface; names and texts of foreigners do no harm.
source "$2/tests/cli/begin"
pretend_gnuplot

cat >wave.yaml <<'E2'
title: A small standing wave
scales: {H: 2}
tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]}
water: {wave: {amplitude: 0.04, wavelength: 8, depth: 2}}
time: {end: 2, every: 0.5}
gauges: [{name: middle, x: 1}]
probes: [{name: P, at: [0, 1]}]
runs: [{name: theory, solver: exact, resolution: 40, order: 1}]
E2
"$program" run wave.yaml --out out -q >log 2>&1 || fail "no result: $(cat log)"

# the same wave by linear theory, as text
/usr/bin/python3 - <<'E2'
from math import cos, sin, sqrt, tanh, pi, cosh
H, g, rho, L, a = 2.0, 9.81, 1000.0, 4.0, 0.04
k = pi / L
w = sqrt(g * k * tanh(k * H))
xs = [L * i / 160 for i in range(161)]
eta = lambda x, t: a * cos(k * x) * cos(w * t)
T = [0, 0.5, 1, 1.5, 2]
for i, t in enumerate(T):  # one file a time, from right to left, as mm, moved by (1, 0.5) m
    with open(f"eta{i}.csv", "w") as f:
        f.write("# any words\n# x [mm],  'the surface' \n")
        for x in reversed(xs): f.write(f"{1000*(x+1):.17g}, {1000*(H+eta(x,t)+0.5):.17g}\n")
with open("long.txt", "w") as f:  # one table, in units of the scales, times beginning at 3
    for t in T:
        for x in xs: f.write(f"{3+t*sqrt(g/H):.17g};{x/H:.17g};{1+eta(x,t)/H:.17g}\n")
E = rho * g * L * a * a / 4
rest = rho * g * L * H * H / 2
with open("series.txt", "w") as f:
    f.write("t ke pe eta p vol\n")
    for i in range(201):
        t = i / 100
        p = -rho * g * (1 - H) + rho * g * eta(0, t) * cosh(k * 1) / cosh(k * H)
        f.write(f"{1000*t:.17g}\t{E*sin(w*t)**2/1000:.17g}  {(rest+E*cos(w*t)**2)/1000:.17g} {H+eta(1,t):.17g} {p/1000:.17g} 8\n")
# particles: still water, 40 x 20, with others of a wall that are left out
with open("cloud.csv", "w") as f:
    f.write('"x" , y, rho, m, kind\n')
    for i in range(40):
        for j in range(20): f.write(f"{0.05+0.1*i},{0.05+0.1*j},1000,10,1\n")
        f.write(f"{0.05+0.1*i},2.05,1000,10,2\n")
E2

cat >settings.yaml <<'E2'
compare:
  times: [0.5, 1.5]
  tolerances:
    - {measure: mean_distance, max: 1e-5}
E2
common='solver: another
source: made up
scales: {H: 2, g: 9.81, density: 1000}
tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]}
spacing: 0.025'

cat >files.yaml <<E2
run: files
$common
units: {length: mm, time: ms, pressure: kPa, energy: kJ/m}
origin: [1, 0.5]
profiles:
  format: csv
  files:
$(for i in 0 1 2 3 4; do echo "    - {file: eta$i.csv, time: $((i * 500)) ms}"; done)
  columns: {x: "x [mm]", y: the surface}
E2
"$program" import files.yaml >log 2>&1 || fail "files: $(cat log)"
grep -qx "files.h5: 5 surfaces, from t = 0 to 2 s" log || fail "what is told: $(cat log)"
"$program" compare out/theory.h5 files.h5 -s settings.yaml -o report1 >log 2>&1 || fail "files: $(cat log)"
grep -q "2 of 2 checks passed" log || fail "files: $(cat log)"
"$program" info files.h5 | tr -s '\n ' ' ' | grep -q "imported by plunge .* by files.yaml; surface as points from eta0.csv to eta4.csv, 5 files (csv); unit of length 0.001 m, of time 0.001 s, times moved by 0 s, places by (-1, -0.5) m; source: made up" || fail "how it was made"

cat >table.yaml <<E2
run: table
$common
units: {length: H, time: sqrt(H/g), pressure: kPa, energy: kJ/m}
time_offset: -3 sqrt(H/g)
profiles: {format: csv, separator: semicolon, file: long.txt, columns: {time: 1, x: 2, y: 3}}
E2
"$program" import table.yaml >log 2>&1 || fail "table: $(cat log)"
"$program" compare out/theory.h5 table.h5 -s settings.yaml -o report2 >log 2>&1 || fail "table: $(cat log)"
grep -q "2 of 2 checks passed" log || fail "table: $(cat log)"
absent() { # report, run: what that run has not
  /usr/bin/python3 -c 'import json, sys; print(*[r["absent"] for r in json.load(open(sys.argv[1]))["runs"] if r["run"] == sys.argv[2]][0])' "$1/report.json" "$2"
}
found=$(absent report2 table) || fail "no table in its report"
[ "$found" = "energies volumes probes gauges" ] || fail "absent of a table: $found"

# series in units of their own
sed 's/^run: files/run: series/; s/^units:.*/units: {length: m, time: ms, pressure: kPa, energy: kJ\/m}/; s/^origin.*/origin: [0, 0]/; /^profiles/,$d' files.yaml >series.yaml
cat >>series.yaml <<'E2'
profiles:
  format: csv
  files: [{file: flat.csv, time: 0}]
  columns: {x: x, y: y}
series:
  - {kind: energy, format: csv, separator: blanks, file: series.txt, columns: {time: t, kinetic: ke, potential: pe}, rest: 78.48}
  - {kind: gauge, name: middle, x: 1, format: csv, separator: blanks, file: series.txt, columns: {time: t, elevation: eta}}
  - {kind: probe, name: P, at: [0, 1], format: csv, separator: blanks, file: series.txt, columns: {time: t, pressure: p}}
  - {kind: run, format: csv, separator: blanks, file: series.txt, columns: {time: t, volume: vol}}
E2
printf 'x,y\n0,2.04\n4,1.96\n' >flat.csv
cat >settings2.yaml <<'E2'
compare:
  tolerances:
    - {measure: kinetic, max: 0.01}
    - {measure: gauge_rms, max: 1e-3}
    - {measure: probe_rms, max: 1e-3}
E2
"$program" import series.yaml >log 2>&1 || fail "series: $(cat log)"
grep -qx "series.h5: 1 surface, 804 rows of series, from t = 0 to 0 s" log || fail "series: $(cat log)"
"$program" compare out/theory.h5 series.h5 -s settings2.yaml -o report3 >log 2>&1 || fail "series: $(cat log)"
grep -q "5 of 5 checks passed" log || fail "series: $(cat log)"
found=$(absent report3 series) || fail "no series in its report"
[ -z "$found" ] || fail "absent beside series of all kinds: $found"

# pieces: a drop becomes clockwise, a cavity counter-clockwise, whichever way they were written
printf 'piece,x,y\n1,4,2\n1,0,2\n2,1,1\n2,1,1.2\n2,1.2,1\n2,1,1\n3,1,2.5\n3,1.2,2.5\n3,1,2.7\n3,1,2.5\n' >pieces.csv
sed 's/^run: .*/run: pieces/; s/flat.csv/pieces.csv/; s/columns: {x/columns: {piece: piece, x/; /^series/,$d' series.yaml >pieces.yaml
"$program" import pieces.yaml >log 2>&1 || fail "pieces: $(cat log)"
if /usr/bin/python3 -c 'import h5py' 2>/dev/null; then
  /usr/bin/python3 - <<'E2' || fail "orientation"
import h5py
s = h5py.File("pieces.h5")["surface"]
p, f = s["points"][:], s["first_point"][:]
area = lambda q: sum(a[0]*b[1]-b[0]*a[1] for a, b in zip(q, list(q[1:])+[q[0]])) / 2
assert list(s["closed"][:]) == [0, 1, 1] and list(f) == [0, 2, 5, 8], (s["closed"][:], f)
assert p[0][0] == 0 and p[1][0] == 4
assert abs(area(p[2:5]) - 0.02) < 1e-12 and abs(area(p[5:8]) + 0.02) < 1e-12
E2
fi

# particles: their own level set stands on the uppermost row of them, and ends on the walls
sed 's/^run: .*/run: cloud/; s/spacing: .*/spacing: 0.1/; s/^units:.*/units: {length: m, mass: kg\/m, density: kg\/m^3}/; /^profiles/,$d' series.yaml >cloud.yaml
cat >>cloud.yaml <<'E2'
particles:
  format: csv
  files: [{file: cloud.csv, time: 0}]
  columns: {x: x, y: y, density: rho, mass: m, only: kind}
  is: 1
E2
"$program" import cloud.yaml >log 2>&1 || fail "particles: $(cat log)"
grep -qx "cloud.h5: 1 surface, particles at 1 time, from t = 0 to 0 s" log || fail "particles: $(cat log)"
if /usr/bin/python3 -c 'import h5py' 2>/dev/null; then
  /usr/bin/python3 - <<'E2' || fail "the surface of particles"
import h5py
f = h5py.File("cloud.h5")
p = f["surface/points"][:]
assert len(f["VTKHDF/Points"]) == 800
assert f["surface/closed"][:].tolist() == [0] and p[0][0] == 0 and p[-1][0] == 4
assert abs(p[:, 1] - 2).max() < 4e-4 * 0.1  # the ripple of the lattice
E2
fi
sed '/^tank/d' cloud.yaml >open.yaml
"$program" import open.yaml -o open.h5 >log 2>&1 || fail "no tank: $(cat log)"
grep -q "names no tank" log || fail "no word that there is no tank: $(cat log)"

# injection: nothing of what foreigners write is run, read as markup, or leads elsewhere
mkdir sub
cat >sub/evil.yaml <<'E2'
run: evil
solver: "<script>alert(1)</script>\"; system('touch pwned') #"
title: "`touch pwned` $(touch pwned) <img src=x onerror=alert(2)> \\x1b[31m"
source: "</pre><script>alert(3)</script> %n%s @x{/=99 y}"
scales: {H: 2, g: 9.81, density: 1000}
tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]}
spacing: 0.025
units: {length: m, time: ms, pressure: kPa, energy: kJ/m}
profiles:
  format: csv
  file: "../<b>;touch pwned.csv"
  columns: {time: "t'\"", x: "$(touch pwned)", y: "<script>alert(4)</script>"}
series:
  - {kind: gauge, name: "../../<script>alert(5)</script>'\"`touch pwned`", x: 1, format: csv, separator: blanks, file: ../series.txt, columns: {time: t, elevation: eta}}
E2
printf 't'"'"'",$(touch pwned),<script>alert(4)</script>\n0,0,2.04\n0,4,1.96\n500,0,2\n500,4,2\n1500,0,1.98\n1500,4,2.02\n' >'<b>;touch pwned.csv'
PATH=${PATH#*:} # gnuplot itself
"$program" import sub/evil.yaml >log 2>&1 || fail "odd names: $(cat log)"
sed '/tolerances/,$d' settings.yaml >plain.yaml
"$program" compare evil.h5 files.h5 -s plain.yaml -o report4 >log 2>&1 || fail "odd names compared: $(cat log)"
[ -z "$(find . -name 'pwned*')" ] || fail "something was run: $(find . -name 'pwned*')"
[ -z "$(find .. -maxdepth 2 -name '*alert(5)*' 2>/dev/null)" ] || fail "a name led elsewhere"
! grep -qiE '<script>alert|<img src=x' report4/report.html || fail "markup in the report"
"$program" info evil.h5 >log 2>&1 || fail "info: $(cat log)"
! grep -q $'\x1b' log || fail "a command for the terminal"

exit $failed
