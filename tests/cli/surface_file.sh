# Boundary elements follow a standing wave that a file holds as they follow the built-in one: what is
# between is the spline's error, 5/384 h^4 of the fourth derivative inside and up to ten times that
# at the walls, where it has no knot; with half as many rows it is 16 times that and more.
set -u
plunge=$1
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
export OMP_NUM_THREADS=1
write() { # NAME WAVE
  cat >"$dir/$1.yaml" <<YAML
tank: {walls: [[[0, 2], [0, 0], [4, 0], [4, 2]]]}
water: {wave: {$2}}
time: {end: 0.2, every: 0.1}
runs: [{name: bem, solver: bem, resolution: 20}]
YAML
  "$plunge" run "$dir/$1.yaml" --out "$dir/$1" --quiet >"$dir/out" 2>&1 || { cat "$dir/out"; exit 1; }
}
surface() { # ROWS
  awk -v n="$1" 'BEGIN { for (i = 0; i <= n; i++) printf "%.17g, %.17g\n", 4 * i / n, 0.05 * cos(6.283185307179586 * i / n) }' >"$dir/$1.csv"
  write "$1" "kind: file, depth: 1, file: $1.csv"
  # across the surface: along it nodes may drift as they like
  "$plunge" compare "$dir/wave/bem.h5" "$dir/$1/bem.h5" --anyway --out "$dir/$1/report" >"$dir/out" 2>&1
  /usr/bin/python3 -c 'import json, sys
run, = json.load(open(sys.argv[1]))["runs"]
print(max(run["against_time"]["largest_distance"]))' "$dir/$1/report/report.json"
}
write wave 'kind: standing, amplitude: 0.05, wavelength: 4, depth: 1'
coarse=$(surface 32) fine=$(surface 64)
echo "surfaces differ by $coarse and $fine m"
awk -v a="${coarse:-1}" -v b="${fine:-1}" 'BEGIN {
  bound = 10 * 5 / 384 * 0.05 * (3.141592653589793 / 32) ^ 4
  exit !(b > 0 && b <= bound && b <= a / 12)
}' || { echo "more than the spline's error, or not of its order"; exit 1; }
"$plunge" info "$dir/64/bem.h5" >/dev/null || { echo "the result cannot be read"; exit 1; }
