# A lattice of boundary elements in the report: the velocity of reference and run, all of it numbers.
plunge=$1 failed=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cat >"$scratch/c.yaml" <<'CASE'
scales: {H: 1}
tank: {walls: [[[0, 2], [0, 0], [3, 0], [3, 2]]]}
water: {regions: [[[2, 0], [3, 0], [3, 1], [2, 1]]], pressure: released}
time: {end: 0.8 sqrt(H/g), every: 0.4 sqrt(H/g)}
compare: {reference: fine, times: [0.8 sqrt(H/g)]}
runs:
  - {name: fine, solver: bem, resolution: 16, velocity_lattice: 0.1 H}
  - {name: coarse, solver: bem, resolution: 10, velocity_lattice: 0.2 H}
  - {name: bare, solver: bem, resolution: 10}
CASE
"$plunge" run -q -o "$scratch/out" "$scratch/c.yaml" >/dev/null || { echo "FAIL the run"; failed=1; }
# rows FILE: how many, a header left out
rows() { tail -n +2 "$scratch/out/figures/velocity-t0.8-points-$1.csv" 2>/dev/null | wc -l; }
[ "$(rows 0)" -ge 95 ] && [ "$(rows 0)" -le 105 ] || { echo "FAIL $(rows 0) points of the reference, about 100 expected"; failed=1; }
[ "$(rows 1)" -ge 20 ] && [ "$(rows 1)" -le 30 ] || { echo "FAIL $(rows 1) points of the run, about 25 expected"; failed=1; }
[ "$(rows 2)" = 0 ] || { echo "FAIL nodes of a surface are drawn as points that fill the water"; failed=1; }
if grep -qi nan "$scratch"/out/figures/velocity-*.csv; then echo "FAIL not a number"; failed=1; fi
# the column stands at the right wall and falls to the left: so it does on the whole
awk -F, 'NR > 1 { u += $3 } END { exit !(u < 0) }' "$scratch/out/figures/velocity-t0.8-points-0.csv" ||
  { echo "FAIL water that runs to the right"; failed=1; }
exit $failed
