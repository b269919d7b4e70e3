#!/usr/bin/env bash
# Arrays of particle codes become results: npz as numpy writes it, plain and deflated, HDF5 in PySPH's layout, and
# points over time in VTKHDF, which are our own. All of them hold the same particles as a text file.
source "$2/tests/cli/begin"
/usr/bin/python3 -c 'import h5py, numpy' 2>/dev/null || { echo "skipped: no h5py or numpy"; exit 77; }

cat >arrays.py <<'E2'
import numpy as np, h5py
T = [0.0, 0.25, 0.5]
for k, t in enumerate(T):
    i, j = np.meshgrid(np.arange(40), np.arange(20 - 2 * k), indexing="ij")
    x, y = 0.05 + 0.1 * i.ravel(), 0.05 + 0.1 * j.ravel()
    m, rho = np.full(x.size, 10.0), np.full(x.size, 1000.0)
    u, v, p = 0.1 * y + t, -0.1 * x, 9810 * (2 - y)
    vel = np.stack([u, v, 0 * u], axis=1)
    kind = np.zeros(x.size, np.int32)
    if k == 0: vel0 = vel
    with open(f"p{k}.csv", "w") as f:
        f.write("x,y,m,rho,u,v,p\n")
        for row in zip(x, y, m, rho, u, v, p): f.write(",".join(f"{a:.17g}" for a in row) + "\n")
    extra = dict(wide=vel.astype(np.float32).astype(float) if False else vel, kind=kind, when=np.array(t))
    np.savez(f"plain{k}.npz", x=x, y=y, m=m, rho=rho, p=p, **extra)
    np.savez_compressed(f"small{k}.npz", x=x, y=y, m=m, rho=rho, p=p, wide=np.asfortranarray(vel), kind=kind, when=np.array([t]))
    with h5py.File(f"pysph{k}.hdf5", "w") as f:
        f.create_group("solver_data").attrs["t"] = t
        a = f.create_group("particles/fluid/arrays")
        for name, values in dict(x=x, y=y, m=m, rho=rho, u=u, v=v, p=p).items():
            a.create_dataset(name, data=values, compression="gzip")
np.savez("objects.npz", x=np.array([{"t": 1}], dtype=object), y=np.zeros(1))
np.savez("records.npz", x=np.zeros(2, [("first", "<f8"), ("second", "<f8")]), y=np.zeros(2))
with open("whole.npy", "wb") as f: np.save(f, np.zeros(2))
import zipfile
whole = open("whole.npy", "rb").read()
with zipfile.ZipFile("nul.npz", "w") as z:  # a type that ends before its letter
    z.writestr("x.npy", whole.replace(b"'<f8'", b"'<\0\0'")); z.writestr("y.npy", whole)
with h5py.File("pysph0.hdf5", "a") as f:
    f["particles/fluid/arrays/long"] = np.zeros(801)
    f["particles/fluid/arrays/short"] = np.zeros(799)
    f["particles/fluid/arrays/wide"] = vel0
np.savez("lengths.npz", x=np.zeros(3), y=np.zeros(2))
np.savez("cube.npz", x=np.zeros((2, 2, 2)), y=np.zeros(2))
np.savez("halves.npz", x=np.zeros(2, np.float16), y=np.zeros(2))
E2
/usr/bin/python3 arrays.py || fail "no arrays"

sidecar() { # name, then the lines of the section
  cat >"$1.yaml"
  cat >>"$1.yaml" <<E2
run: same
solver: another
source: made up
scales: {H: 2, g: 9.81, density: 1000}
tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]}
spacing: 0.1
units: {length: m, time: s, velocity: m/s, mass: kg/m, density: kg/m^3, pressure: Pa}
E2
}
files() { # pattern with K for the number, extra of each
  for k in 0 1 2; do echo "    - {file: ${1/K/$k}$2}"; done
}
sidecar text <<E2
particles:
  format: csv
  files:
    - {file: p0.csv, time: 0}
    - {file: p1.csv, time: 0.25}
    - {file: p2.csv, time: 0.5}
  columns: {x: x, y: y, mass: m, density: rho, u: u, v: v, pressure: p}
E2
for which in plain small; do
  sidecar $which <<E2
particles:
  format: npz
  time_after: when
  files:
$(files ${which}K.npz)
  columns: {x: x, y: y, mass: m, density: rho, u: "wide:0", v: "wide:1", pressure: p, only: kind}
E2
done
a=particles/fluid/arrays
sidecar pysph <<E2
particles:
  format: hdf5
  time_after: solver_data@t
  files:
$(files pysphK.hdf5)
  columns: {x: $a/x, y: $a/y, mass: $a/m, density: $a/rho, u: $a/u, v: $a/v, pressure: $a/p}
E2
"$program" import text.yaml -o text.h5 >log 2>&1 || fail "text: $(cat log)"
sidecar over_time <<E2
particles:
  format: vtkhdf
  file: text.h5
  columns: {x: "Points:0", y: "Points:1", mass: mass, density: density, u: "velocity:0", v: "velocity:1", pressure: pressure}
E2
for which in plain small pysph over_time; do
  "$program" import $which.yaml -o $which.h5 >log 2>&1 || fail "$which: $(cat log)"
  "$program" diff text.h5 $which.h5 >log 2>&1 || fail "$which is not the same as text: $(cat log)"
done
grep -q "3 surfaces, particles at 3 times, from t = 0 to 0.5 s" <("$program" import pysph.yaml -o again.h5) || fail "what is told"

import_refused plain 's/x: x/x: X/' "5: particles.files[0]: plain0.npz has no column 'X'; it has x, y, m, rho, p, wide, kind, when"
import_refused plain 's/wide:1/wide:3/' "5: particles.files[0]: plain0.npz has no component 3 of 'wide', which has 3, from 0"
import_refused plain 's/wide:1/wide/' "5: particles.files[0]: plain0.npz has 3 components of 'wide'; ask for one, as 'wide:0'"
import_refused pysph "s|$a/v|$a/wide|" "5: particles.files[0]: pysph0.hdf5 has 3 components of '$a/wide'; ask for one, as '$a/wide:0'"
import_refused pysph "s|$a/v|$a/wide:3|" "5: particles.files[0]: pysph0.hdf5 has no component 3 of '$a/wide', which has 3, from 0"
import_refused over_time 's/velocity:1/velocity/' "2: particles.file: text.h5 has 3 components of 'velocity'; ask for one, as 'velocity:0'"
for other in long:801 short:799; do
  import_refused pysph "s|$a/v|$a/${other%:*}|" "5: particles.files[0]: pysph0.hdf5: '$a/${other%:*}' has ${other#*:} rows, other columns 800"
  import_refused pysph "s|x: $a/x|x: $a/${other%:*}|" "5: particles.files[0]: pysph0.hdf5: '$a/y' has 800 rows, other columns ${other#*:}"
done
import_refused plain 's/plain0/records/' "5: particles.files[0]: records.npz: 'x' is not of plain numbers ([('first', '<f8'), ('second', '<f8')]);"
import_refused plain 's/plain0/nul/' "5: particles.files[0]: nul.npz: 'x' is not of plain numbers ('<);"
mkdir folder.hdf5
import_refused pysph 's/pysph0/folder/' "5: particles.files[0]: folder.hdf5 is a directory, not an HDF5 file"
import_refused plain 's/plain0/objects/' "5: particles.files[0]: objects.npz: 'x' is not of plain numbers ('|O');"
import_refused plain 's/plain0/lengths/' "5: particles.files[0]: lengths.npz: 'y' has 2 rows, other columns 3"
import_refused plain 's/plain0/cube/' "5: particles.files[0]: cube.npz: 'x' has more than two dimensions"
import_refused plain 's/plain0/halves/' "5: particles.files[0]: halves.npz: 'x' is not of plain numbers ('<f2');"
import_refused plain 's/plain0.npz/p0.csv/' "5: particles.files[0]: p0.csv is no npz: it cannot be read as a zip"
import_refused plain 's/: when/: wide/' "5: particles.files[0]: plain0.npz: 'wide' is not one number"
import_refused pysph "s|$a/x|$a/z|" "5: particles.files[0]: pysph0.hdf5 has no column '$a/z'; it has long, m, p, rho, short, u, v, wide, x, y"
import_refused pysph 's/data@t/data@time/' "5: particles.files[0]: pysph0.hdf5: 'solver_data' has no numeric attribute 'time'"
import_refused pysph 's/pysph0.hdf5/p0.csv/' "5: particles.files[0]: p0.csv is not HDF5"
import_refused pysph "s|x: $a/x|x: particles|" "5: particles.files[0]: pysph0.hdf5: 'particles' is not a dataset of one or two dimensions"
head -c 1500 small1.npz >cut.npz
import_refused small 's/small1/cut/' "6: particles.files[1]: cut.npz is no npz: it cannot be read as a zip"
head -c 3000 pysph1.hdf5 >cut.hdf5
import_refused pysph 's/pysph1/cut/' "6: particles.files[1]: cut.hdf5 is damaged (HDF5: truncated file"

exit $failed
