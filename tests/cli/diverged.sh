# A run that blows up says where and when, fails with exit code 3, and leaves its outputs readable.
set -u
plunge=$1
# A build with floating-point traps stops at the first overflow instead: that is what it is for.
nm "$plunge" | grep -q __asan_init && exit 77
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
export OMP_NUM_THREADS=1
cat >"$dir/case.yaml" <<'YAML'
title: water thirty times as fast as its sound
scales: {H: 0.6}
tank:
  walls: [[[0, 3 H], [0, 0], [5.366 H, 0], [5.366 H, 3 H]]]
water:
  regions: [[[0, 0], [2 H, 0], [2 H, H], [0, H]]]
  pressure: released
time: {end: 4 sqrt(H/g), every: 0.05 sqrt(H/g)}
runs:
  - {name: none, solver: sph, resolution: 10, diffusion: none, alpha: 0, cfl_acceleration: 10, c0: 0.03 sqrt(gH)}
YAML
fail=0
"$plunge" run "$dir/case.yaml" --out "$dir" --quiet >"$dir/out" 2>"$dir/err"
code=$?
[ $code -eq 3 ] || { echo "exit code $code, expected 3"; fail=1; }
grep -q 'run none: particle [0-9]* at .* has velocity .*, faster than its sound, .* at t = .* s: raise c0 or alpha, or lower cfl_acoustic$' "$dir/err" ||
  { echo "no particle, place and time in:"; cat "$dir/err"; fail=1; }
"$plunge" info "$dir/none.h5" >"$dir/info" || { echo "its file is not readable"; fail=1; }
grep -q 'stopped before its end' "$dir/info" || { echo "the file does not say that it is incomplete"; fail=1; }

# Forms that are not adjoint feed sound beside the surface (thesis, 2.6): the sentence names their term.
cat >"$dir/fed.yaml" <<'YAML'
title: still water by forms of momentum and continuity that are not adjoint
scales: {H: 1}
tank:
  walls: [[[0, 1.5 H], [0, 0], [2 H, 0], [2 H, 1.5 H]]]
water:
  regions: [[[0, 0], [2 H, 0], [2 H, H], [0, H]]]
time: {end: 20 sqrt(H/g), every: 0.2 sqrt(H/g)}
runs:
  - {name: fed, solver: sph, resolution: 12, scheme: ma-sph, continuity: absolute, mls_volume: 0}
YAML
"$plunge" run "$dir/fed.yaml" --out "$dir" --quiet >"$dir/out" 2>"$dir/err"
code=$?
[ $code -eq 3 ] || { echo "exit code $code, expected 3"; fail=1; }
grep -q 'run fed: particle [0-9]* at .* at t = [0-9.]* s, pairs in the budget of energy having given .* adjoint' "$dir/err" ||
  { echo "no particle, time and cause in:"; cat "$dir/err"; fail=1; }
"$plunge" info "$dir/fed.h5" >"$dir/info" || { echo "its file is not readable"; fail=1; }
grep -q 'stopped before its end' "$dir/info" || { echo "the file does not say that it is incomplete"; fail=1; }
exit $fail
