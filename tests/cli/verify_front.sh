#!/usr/bin/env bash
# The surge front of a released dam, SPH (Antuono's diffusion, alpha = 0.01) against potential flow: where
# the water is 2 dx deep the positions differ by at most 0.03 H at H/dx = 100 until the front reaches
# the wall, and the difference shrinks with dx over H/dx = 25, 50, 100.
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1

cat >front.yaml <<'E2'
title: Surge front
scales: {H: 0.6}
tank:
  walls: [[[0, 3 H], [0, 0], [5.366 H, 0], [5.366 H, 3 H]]]
water:
  regions: [[[0, 0], [2 H, 0], [2 H, H], [0, H]]]
  pressure: released
time: {end: 2.4 sqrt(H/g), every: 0.05 sqrt(H/g)}
runs:
  - {name: bem, solver: bem, resolution: 40}
  - {name: sph, solver: sph, resolution: 25, diffusion: antuono, alpha: 0.01}
compare:
  reference: bem
  times: [2 sqrt(H/g)]
E2

differences=()
for resolution in 25 50 100; do
  "$program" run front.yaml --out out --quiet --set runs.sph.resolution=$resolution >log 2>&1 || {
    cat log
    exit 1
  }
  differences+=("$(awk '/"measure": "front"/ { here = 1 }
    here && /"value"/ { gsub(/[^-+.0-9eE]/, "", $2); print $2; exit }' out/report.json)")
done
echo "front difference over H at H/dx = 25, 50, 100: ${differences[*]}"
awk -v a="${differences[0]}" -v b="${differences[1]}" -v c="${differences[2]}" \
  'BEGIN { exit !(a > b && b > c && c > 0 && c <= 0.03) }'
