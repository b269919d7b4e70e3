#!/usr/bin/env bash
# Every dataset that the solvers write has units of the list in docs/result-file.md, in its spelling.
set -u
plunge=$1 source=$2
/usr/bin/python3 -c 'import h5py' 2>/dev/null || exit 77
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
printf '0, 1\n1, 1\n' >"$dir/gauge.txt"
cat >"$dir/dam.yaml" <<'YAML'
scales: {H: 0.6}
tank: {walls: [[[0, 3], [0, 0], [3, 0], [3, 3]]]}
water: {regions: [[[0, 0], [1.2, 0], [1.2, 0.6], [0, 0.6]]]}
time: {end: 0.02, every: 0.01}
probes: [{name: P, at: [3, 0.1]}]
gauges: [{name: G, x: 0.6}]
runs: [{solver: bem, resolution: 10}, {solver: sph, resolution: 10}]
compare: {experiments: [{label: l, source: s, target: G, file: gauge.txt}]}
YAML
{ sed '/^runs:/,$d' "$source/cases/standing-wave.yaml"; echo 'runs: [{solver: exact, resolution: 20}]'; } >"$dir/wave.yaml"
for case in dam wave; do
  "$plunge" run "$dir/$case.yaml" --out "$dir/$case" --quiet >"$dir/out" 2>&1 ||
    { echo "$case does not run:"; cat "$dir/out"; exit 1; }
done
/usr/bin/python3 - "$source/docs/result-file.md" "$dir"/dam/*.h5 "$dir"/wave/*.h5 <<'PY'
import re, sys, h5py
text = re.sub(r"\s+", " ", open(sys.argv[1], encoding="utf-8").read())
known = re.search(r'`units` \("1" for a pure number, else one of ([^)]*)\)', text).group(1).split(", ")
wrong, seen = [], 0
def visit(name, o):
    global seen
    if isinstance(o, h5py.Dataset):
        seen += 1
        if o.attrs["units"] not in known + ["1"]:
            wrong.append(f"{path}: {name} is in '{o.attrs['units']}'")
for path in sys.argv[2:]:
    with h5py.File(path) as f:
        f.visititems(visit)
        if "experiments/experiment_1" in f and f["experiments/experiment_1/value"].attrs["units"] != "m":
            wrong.append(f"{path}: a gauge is not measured in m")
print(f"{seen} datasets in {len(sys.argv) - 2} files")
sys.exit("\n".join(wrong) if wrong or seen < 100 or len(sys.argv) != 5 else 0)
PY
