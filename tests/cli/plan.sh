#!/usr/bin/env bash
# plunge plan: the runs of a case for other engines. A Makefile and a table, with names that shells and make
# mistake, give the files and the report of a plain run; runs without a report share a folder with each other
# and with nobody else; wrong plans are refused with one sentence.
source "$2/tests/cli/begin"
pretend_gnuplot

cat >case.yaml <<'E2'
title: A wave
scales: {H: 2}
tank:
  walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]
water:
  wave: {amplitude: 0.04, wavelength: 4, depth: 2}
time: {end: 0.4, every: 0.1}
probes: [{name: P, at: [0, 1]}]
runs:
  - {name: a, solver: exact, resolution: 8}
  - {name: -b, solver: bem, sweep: {resolution: [8, 16]}}
compare:
  reference: a
  tolerances: [{measure: mean_distance, max: 0.001}]
E2

# The two folders have the same runs and the same report, but for paths, clocks and dates.
same() { # plain folder, folder
  local run
  for run in a -b-8 -b-16; do
    "$program" diff -- "$1/$run.h5" "$2/$run.h5" >log 2>&1 || fail "$2: $run differs: $(cat log)"
  done
  for run in "$1" "$2"; do
    [ -s "$run/report.html" ] || fail "$run has no page"
    sed '/"wall_time_s": \[/,/\]/d; /"\(file\|wall_time_s\)":/d' "$run/report.json" >"$folder/${run##*/}.json"
  done
  diff "$folder/${1##*/}.json" "$folder/${2##*/}.json" >log || fail "$2 has another report: $(head -5 log)"
}

"$program" run case.yaml --set "title='A wave'" --out plain -q >log 2>&1 || fail "plain: $(cat log)"

# ---- make ----
odd="it's a \$(place) #1 %s; \`touch x\` \\ \"q\" é"
mkdir "$odd"
sed 's/^title:.*/title: T/' case.yaml >"$odd/\$case #.yaml"
if command -v make >/dev/null; then
  (cd "$odd" && "$program" plan "\$case #.yaml" --for make --results 'r $e #' --set "title='A wave'" --out '../plan.mk') ||
    fail "no Makefile"
  make -j2 -f plan.mk >log 2>&1 || fail "make: $(cat log)"
  same plain "$odd/r \$e #"
  [ -e x ] && fail "a word was taken for a command"
  make -j2 -f plan.mk >log 2>&1 || fail "make again: $(cat log)"
  before=$(stat -c %Y%s "$odd"/r*/a.h5)
  sleep 1.1
  make -f plan.mk compare >log 2>&1 || fail "make compare: $(cat log)"
  [ "$before" = "$(stat -c %Y%s "$odd"/r*/a.h5)" ] || fail "make compare runs again"
else
  echo "without make: not tried"
fi

# ---- a table, one command at a time as xargs hands them to a shell ----
(cd "$odd" && "$program" plan "\$case #.yaml" --for tsv --results "t'x" --set "title='A wave'") >plan.tsv || fail "no table"
[ "$(head -1 plan.tsv)" = $'step\trun\tseconds\tMB\tcommand' ] || fail "head of the table: $(head -1 plan.tsv)"
[ "$(awk -F '\t' 'NF != 5' plan.tsv)" = "" ] || fail "other than five columns"
[ "$(cut -f 1,2 plan.tsv | tr '\t\n' '= ')" = "step=run run=a run=-b-8 run=-b-16 compare= " ] || fail "rows: $(cut -f 1,2 plan.tsv)"
awk -F '\t' '$1 == "run" {print $5}' plan.tsv | xargs -d '\n' -P 2 -n 1 sh -c >log 2>&1 || fail "table: $(cat log)"
[ -e "$odd/t'x/report.html" ] && fail "--no-report writes one"
sh -c "$(tail -n 1 plan.tsv | cut -f 5)" >log 2>&1 || fail "the table's comparison: $(cat log)"
same plain "$odd/t'x"

# ---- some of the runs; one run, which nothing is compared with ----
"$program" plan case.yaml --for tsv --only=-b-16 --threads 3 >some.tsv || fail "--only"
[ "$(cut -f 2 some.tsv | tr '\n' ' ')" = "run -b-16  " ] || fail "--only plans: $(cat some.tsv)"
grep -q -- "--only=-b-16 --no-report --quiet --threads 3 --out $PWD/out/case$" some.tsv || fail "command: $(cat some.tsv)"
grep -q "cd $PWD/out/case && .* compare --out . -- a.h5 -b-16.h5$" some.tsv || fail "its comparison: $(cat some.tsv)"
"$program" plan case.yaml --for tsv --only a | cut -f 1 | tr '\n' ' ' >log
[ "$(cat log)" = "step run " ] || fail "a comparison of one run: $(cat log)"
for engine in make slurm; do
  "$program" plan case.yaml --for $engine --out plan.$engine --only a || fail "--for $engine --only a"
  grep -q " compare --out" plan.$engine && fail "$engine compares one run"
done
bash -n plan.slurm || fail "the script is none"

# ---- runs that share a folder ----
sed 's/end: 0.4/end: 4000/; s/every: 0.1/every: 10/' case.yaml >long.yaml
"$program" run long.yaml --out shared --only=-b-16 --no-report -q >one.log 2>&1 &
pid=$!
wait_for shared/-b-16.h5
"$program" run case.yaml --out shared --only a --no-report -q >log 2>&1 || fail "beside another: $(cat log)"
got=0
"$program" run long.yaml --out shared --only=-b-16 --no-report -q >log 2>&1 || got=$?
[ $got != 0 ] && [ "$(wc -l <log)" = 1 ] || fail "twice the same run: code $got, $(cat log)"
for command in "run case.yaml -q --out shared" "compare shared/a.h5 shared/a.h5 --out shared"; do
  got=0
  "$program" $command >log 2>&1 || got=$?
  [ $got = 3 ] || fail "$command beside a run: code $got"
  grep -qE "another plunge( \(process [0-9]+\))? is at work in shared: wait for it" log || fail "$command: $(cat log)"
done
kill -INT $pid
wait $pid
[ $? = 3 ] || fail "a stopped run without a report has another exit code: $(cat one.log)"

# ---- wrong plans: exit code 2 and this sentence ----
hint="Try \`plunge plan --help' or \`plunge plan --usage' for more information."
wrong() { # sentence, arguments
  local sentence=$1 got=0
  shift
  "$program" plan "$@" >out.log 2>log || got=$?
  [ $got = 2 ] && [ ! -s out.log ] || fail "plan $*: code $got"
  grep -vxF "$hint" log >said
  [ "$(cat said)" = "$sentence" ] || fail "plan $*: $(cat said)"
}
runs="its runs are a, -b-8, -b-16"
wrong "plunge plan: say what the plan is for: --for make, slurm or tsv" case.yaml
wrong "plunge plan: name a case file" --for make
wrong "plunge plan: one case file at a time; other.yaml is the second" case.yaml other.yaml --for make
wrong "plunge: --for: found 'ninja'; allowed: one of make, slurm, tsv" case.yaml --for ninja
wrong "plunge: --for: found 'Make'; allowed: one of make, slurm, tsv; did you mean 'make'?" case.yaml --for Make
wrong "plunge: --for: found ''; allowed: one of make, slurm, tsv" case.yaml --for ''
wrong "plunge: found '-'; allowed: a case in a file, which each run reads again; save it" - --for make
wrong "none.yaml: found nothing to read (No such file or directory); allowed: a case file in YAML of at most 10 MB, or - for standard input; correct the path" none.yaml --for tsv
wrong "plunge: --only c: case.yaml has no run of that name; $runs" case.yaml --for make --only c
wrong "plunge: --only -b: case.yaml has no run of that name; $runs" case.yaml --for make --only=-b
wrong "plunge: --only : case.yaml has no run of that name; $runs" case.yaml --for make --only a,
wrong "plunge plan: --threads 0: give a whole number from 1 to 1024" case.yaml --for make --threads 0
wrong "plunge plan: --threads two: give a whole number from 1 to 1024" case.yaml --for slurm --threads two
wrong "plunge: --out: found the case itself; allowed: another file, which the plan replaces" case.yaml --for make --out ./case.yaml
wrong "plunge plan: --set title: write PATH=VALUE, as in runs.NAME.alpha=0" case.yaml --for make --set title
wrong "--set runs.x.resolution=1: found no item 'x' in the list; allowed: a, -b; correct the path" case.yaml --for make --set runs.x.resolution=1
wrong "--set runs.-b.sweep.resolution=[8, -1]: runs.-b--1.resolution: found '-1'; allowed: a number above 0 and up to 100000" \
  case.yaml --for make --set 'runs.-b.sweep.resolution=[8, -1]'
wrong "--set runs.-b.sweep.resolution=[]: runs[1].sweep.resolution: found an empty list; allowed: a list of values in brackets" \
  case.yaml --for make --set 'runs.-b.sweep.resolution=[]'
wrong "plunge: --results: found ''; allowed: a folder" case.yaml --for make --results ''
wrong "plunge: --results: found a control character in $PWD/a\\x0ab; allowed: any others, since a plan has a line for each run; rename it" \
  case.yaml --for make --results $'a\nb'
wrong "plunge: --results: found a path of more than 4095 bytes; allowed: a shorter one" case.yaml --for tsv --results "$(printf '%05000d' 0)"
wrong "plunge plan: unrecognized option '--jobs'" case.yaml --for make --jobs 3
got=0
"$program" plan case.yaml --for make --out nowhere/plan.mk >log 2>&1 || got=$?
[ $got = 3 ] && [ "$(cat log)" = "plunge: cannot write nowhere/plan.mk: No such file or directory" ] || fail "--out nowhere: $got, $(cat log)"
for jobs in 0 many; do
  got=0
  "$program" run case.yaml --jobs $jobs >log 2>&1 || got=$?
  [ $got = 2 ] && [ "$(head -1 log)" = "plunge run: --jobs $jobs: give a whole number from 1 to 1024" ] || fail "--jobs $jobs: $(cat log)"
done
exit $failed
