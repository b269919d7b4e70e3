#!/usr/bin/env bash
# plunge plan --for slurm in a real Slurm of one node: the array's runs and the comparison behind them give the
# files and the report of a plain run.
source "$2/tests/cli/begin"
source "$2/tests/cli/slurm"
slurm_there || {
  echo "skipped: no Slurm with munge here (package slurm-wlm)"
  exit 77
}
trap 'slurm_stop; rm -rf "$folder"' EXIT
pretend_gnuplot
slurm_start "$folder/slurm" || {
  fail "Slurm does not start"
  exit 1
}

mkdir "it's \$1"
cat >"it's \$1/case.yaml" <<'E2'
title: A wave
scales: {H: 2}
tank:
  walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]
water:
  wave: {amplitude: 0.04, wavelength: 4, depth: 2}
time: {end: 0.4, every: 0.1}
runs:
  - {name: a, solver: exact, resolution: 8}
  - {name: b, solver: bem, sweep: {resolution: [8, 16]}}
compare:
  reference: a
  tolerances: [{measure: mean_distance, max: 0.001}]
E2
cd "it's \$1" || exit 1
"$program" run case.yaml --out plain -q >log 2>&1 || fail "plain: $(cat log)"
"$program" plan case.yaml --for slurm --results "d \"x\"" --out "plan 1.sh" || fail "no plan"

# ---- the runs and, behind them, the comparison ----
bash "plan 1.sh" >log 2>&1 || fail "the plan as a command: $(cat log)"
grep -q "^runs: job [0-9]*$" log || fail "it says: $(cat log)"
for _ in $(seq 600); do
  [ -z "$(squeue -h -t all -o %T | grep -vE 'COMPLETED|FAILED|CANCELLED')" ] && break
  sleep 0.2
done
states=$(squeue -h -t all -o %T | sort | uniq -c | tr -s ' \n' ' ')
[ "$states" = " 4 COMPLETED " ] || fail "jobs: $states; $(cat slurm-*.out)"
for run in a b-8 b-16; do
  "$program" diff "plain/$run.h5" "d \"x\"/$run.h5" >log 2>&1 || fail "$run differs: $(cat log)"
done
strip() { sed '/"wall_time_s": \[/,/\]/d; /"\(file\|wall_time_s\)":/d' "$1/report.json"; }
diff <(strip plain) <(strip "d \"x\"") >log || fail "another report: $(head -5 log)"
[ -s "d \"x\"/report.html" ] || fail "no page"

# ---- the runs alone, which are there already; and one that fails is a failed job ----
sbatch --wait "plan 1.sh" >log 2>&1 || fail "sbatch of what is there: $(cat log)"
sed 's/solver: exact, resolution: 8/solver: exact, resolution: 8, order: 3/' case.yaml >wrong.yaml
"$program" plan case.yaml --for slurm --results other --out plan.sh || fail "no plan"
cp wrong.yaml case.yaml # it changes after the plan was made: each job says so itself
sbatch --wait plan.sh >log 2>&1 && fail "wrong runs do not fail"
grep -q "order" slurm-*.out || fail "the job does not say why: $(cat slurm-*.out)"
exit $failed
