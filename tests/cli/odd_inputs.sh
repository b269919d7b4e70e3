#!/usr/bin/env bash
# Inputs that are no plain files, byte-order marks, a case on standard input, closed descriptors,
# names with terminal escapes.
source "$2/tests/cli/begin"
# Wanted exit code, words that must be printed, then the command; five seconds are for ever here.
expect() {
  local wanted=$1 words=$2 got=0
  shift 2
  timeout 20 "$@" >log 2>&1 </dev/null || got=$?
  [ "$got" = "$wanted" ] || fail "exit code $got, expected $wanted: $*: $(cat log)"
  [ -z "$words" ] || grep -qF -- "$words" log || fail "$*: expected '$words' in: $(cat log)"
}

cat >dam.yaml <<'E2'
title: A small dam
scales: {H: 0.6}
tank:
  walls: [[[0, 2 H], [0, 0], [4 H, 0], [4 H, 2 H]]]
water:
  regions: [[[0, 0], [1 H, 0], [1 H, 1 H], [0, 1 H]]]
time: {end: 0.02 sqrt(H/g), every: 0.01 sqrt(H/g)}
probes:
  - {name: P, at: [4 H, 0.1 H]}
runs:
  - {name: sph, solver: sph, resolution: 10}
E2

# ---- devices, pipes, endless and binary files: refused in one sentence each ----
mkfifo pipe
{
  printf '# measured\n1, '
  head -c 3000 /dev/zero | tr '\0' 1
  echo
} >long.csv
for odd in /dev/zero:device pipe:pipe .:directory long.csv:"lines of at most 1000 bytes"; do
  file=${odd%%:*} words=${odd#*:}
  { cat dam.yaml; printf 'compare:\n  experiments:\n    - {file: "%s", target: P}\n' "$file"; } >with.yaml
  expect 2 "$words" "$program" check with.yaml
  [ -f "$file" ] || expect 2 "$words" "$program" check "$file"
  [ -f "$file" ] || expect 2 "$words" "$program" run "$file"
done
expect 0 "" "$program" run dam.yaml --out one -q
for odd in /dev/zero:device pipe:pipe .:directory long.csv:"at most 1000"; do
  expect 2 "${odd#*:}" "$program" diff one/sph.h5 one/sph.h5 --tol "${odd%%:*}"
done
got=0
timeout 20 "$program" check - </dev/zero >log 2>&1 || got=$?
[ $got = 2 ] && grep -q "more than 10 MB" log || fail "an endless standard input: $got, $(cat log)"

# ---- byte-order marks ----
mark=$'\xef\xbb\xbf'
printf '%s# t, p\n0, 1\n1, 1\n' "$mark" >mark.csv
{ printf '%s' "$mark"; cat dam.yaml; printf 'compare:\n  experiments:\n    - {file: mark.csv, target: P}\n'; } >mark.yaml
expect 0 "fine" "$program" check mark.yaml
printf '%s* 0 0\n' "$mark" >mark.tol
expect 0 "" "$program" diff one/sph.h5 one/sph.h5 --tol mark.tol

# ---- a case on standard input ----
"$program" run - -q <dam.yaml >log 2>&1 || fail "a case on standard input: $(cat log)"
[ -s out/stdin/sph.h5 ] || fail "a case on standard input leaves no out/stdin/sph.h5"
"$program" diff one/sph.h5 out/stdin/sph.h5 >/dev/null || fail "a case on standard input gives other results"
sed 's/time:/tmie:/' dam.yaml | "$program" check - 2>&1 | grep -q "^stdin:7: tmie" || fail "no line of standard input"

# ---- closed descriptors: nothing that is meant for the terminal gets into a file ----
"$program" run dam.yaml --out closed <&- >&- 2>&- || fail "a run with closed descriptors fails"
"$program" diff one/sph.h5 closed/sph.h5 >/dev/null || fail "a run with closed descriptors differs"
"$program" run dam.yaml --out closed-2 2>&- --set runs.sph.cfl_acoustic=1 --set runs.sph.alpha=0 >/dev/null
"$program" info closed-2/sph.h5 | grep -q complete || fail "closed standard error spoils the result"

# ---- terminal escapes in names are made visible ----
escape=$(printf '\033]0;owned\007\nplunge: fine')
expect 2 '\x1b]0;owned\x07\x0aplunge: fine' "$program" info "$escape"
expect 2 '\x1b]0;owned\x07\x0aplunge: fine' "$program" check "$escape"
expect 2 '\x1b]0;owned\x07\x0aplunge: fine' "$program" run dam.yaml --only "$escape"
expect 3 '\x1b]0;owned\x07\x0aplunge: fine' "$program" run dam.yaml --out "/proc/$escape"
cp one/sph.h5 "$escape.h5"
expect 0 'sph' "$program" info "$escape.h5"
grep -q "$(printf '\033')" log && fail "an escape reaches the terminal"
exit $failed
