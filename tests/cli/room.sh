#!/usr/bin/env bash
# Memory is estimated before it is taken: what does not fit is refused in a sentence, and under any limit
# of address space the program ends soon, with a result or a sentence.
nm "$1" | grep -q __asan_init && exit 77 # sanitizers take terabytes of address space
source "$2/tests/cli/begin"
pretend_gnuplot

small_dam 4 0.2 0.1 <<'E2'
runs:
  - {name: bem, solver: bem, resolution: 15}
  - name: sph
    solver: sph
    resolution: 20
E2

# ---- what a run will take ----
"$program" check dam.yaml >log || fail "a small case is refused"
grep -qE '^  sph +400 particles, [0-9]+ MB of memory, roughly' log || fail "no estimate: $(cat log)"
grep -qE '^  bem +[0-9]+ nodes, [0-9]+ MB of memory, roughly' log || fail "no estimate: $(cat log)"

# ---- more than any machine has, refused by check and by run, at the line of its key ----
sed 's/resolution: 20/resolution: 100000/' dam.yaml >huge.yaml
for command in "check huge.yaml" "run huge.yaml --only sph" "run dam.yaml --set runs.sph.resolution=100000"; do
  got=0
  # shellcheck disable=SC2086
  timeout 20 "$program" $command >log 2>&1 || got=$?
  [ $got = 2 ] || fail "$command: exit code $got: $(cat log)"
  grep -qE "resolution: found '100000', about 10000000000 particles in [0-9]+ MB of memory; allowed: " log ||
    fail "$command: $(cat log)"
done
"$program" check huge.yaml 2>&1 | grep -q '^huge.yaml:13: runs.sph' || fail "not at the line of the key"
[ -e out/dam/sph.h5 ] && fail "a refused run leaves a file"

# ---- an estimate is near what is taken: a third too low or twice too high at most, small ones aside ----
"$program" run dam.yaml --only sph --out more -q --set runs.sph.resolution=250 --set "time.end=0.01 sqrt(H/g)" \
  --set "time.every=0.01 sqrt(H/g)" --threads 1 &
pid=$!
most=0
while kill -0 $pid 2>/dev/null; do
  now=$(awk '/^VmHWM/ { print $2 }' "/proc/$(pgrep -P $pid)/status" 2>/dev/null) # the run's own process
  [ "${now:-0}" -gt $most ] && most=$now
  sleep 0.05
done
wait $pid || fail "a run of 62,500 particles fails"
sed 's/resolution: 20/resolution: 250/' dam.yaml | "$program" check - >log
estimate=$(awk '$1 == "sph" { print $4 }' log)
echo "62,500 particles: $((most / 1000)) MB, estimated $estimate MB"
awk -v a="$most" -v b="$estimate" 'BEGIN { exit !(b > 0.67e-3 * a && b < 2.5e-3 * a) }' ||
  fail "the estimate is off: $estimate MB for $most kB"

# ---- limits of address space, kB ----
for limit in 1000000 500000 300000 200000 160000 140000 120000; do
  got=0
  (
    ulimit -v $limit
    timeout -s KILL 60 "$program" run dam.yaml --only bem --force --threads 2 --out limited
  ) >log 2>&1 || got=$?
  [ $got != 137 ] || fail "ulimit -v $limit: it does not end"
  [ -s log ] || fail "ulimit -v $limit: neither a result nor a sentence"
  [ $got = 0 ] || [ $limit -lt 500000 ] || fail "ulimit -v $limit: exit code $got: $(cat log)"
done
exit $failed
