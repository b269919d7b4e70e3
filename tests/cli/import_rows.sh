#!/usr/bin/env bash
# Which lines of a text are rows, which time its comments tell, and which of its particles are water: none gets lost
# without a word.
source "$2/tests/cli/begin"

sidecar() { # name, then its section
  cat >"$1.yaml" <<'E2'
run: same
solver: another
source: made up
scales: {H: 2, g: 9.81, density: 1000}
tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]}
spacing: 0.1
units: {length: m, time: s, pressure: Pa}
E2
  cat >>"$1.yaml"
}
same() { # text of columns, what is wrong: its profile is that of plain.csv
  printf "$1" >text.csv
  "$program" import text.yaml -o text.h5 >log 2>&1 && "$program" diff plain.h5 text.h5 >log 2>&1 || fail "$2: $(cat log)"
}
refused() { # text of columns, sidecar, message
  printf "$1" >text.csv
  rm -f text.h5
  "$program" import "$2" -o text.h5 >log 2>&1
  code=$?
  [ $code = 2 ] && [ ! -e text.h5 ] || fail "$3: exit code $code: $(cat log)"
  grep -qF "plunge: $2:8: $3" log || fail "expected '$3', found: $(cat log)"
}

# ---- lines ----
for name in plain text; do
  sidecar $name <<<"profiles: {format: csv, files: [{file: $name.csv, time: 0}], columns: {x: x, y: y}}"
done
printf 'x,y\n0,2.1\n2,2\n4,1.9\n' >plain.csv
"$program" import plain.yaml -o plain.h5 >log 2>&1 || fail "plain: $(cat log)"
same '\xef\xbb\xbfx,y\n0,2.1\n2,2\n4,1.9\n' "a mark of byte order"
same '\xef\xbb\xbf# words\n# x,y\n0,2.1\n2,2\n4,1.9\n' "a mark of byte order before a comment"
same 'p,x,y\n,0,2.1\n,2,2\n3.5,4,1.9\n' "rows before the first full one"
same 'x,y,p\n0,2.1,\n2,2,\n4,1.9,7\n' "rows without their last field"
same 'kind,x,y\n1,0,2.1\n1,2,2\n1,4,1.9\n' "a column beside"
same 'x,y,kind\n0,2.1,water\n2,2,water\n4,1.9,water\n' "a column of words"
same 'x,y\n,,\n0,2.1\n,,\n2,2\n4,1.9\n' "lines of separators alone"
same ',x,y\n0,0,2.1\n1,2,2\n2,4,1.9\n' "a column without a name"

# a gauge that is dry at first
sidecar gauge <<'E2'
series: [{kind: gauge, name: G, x: 1, format: csv, file: text.csv, columns: {elevation: h, time: t}}]
profiles: {format: csv, files: [{file: plain.csv, time: 0}], columns: {x: x, y: y}}
E2
printf 'h,t\n,0\n,1\n2.1,2\n,3\n' >text.csv
"$program" import gauge.yaml -o gauge.h5 >log 2>&1 || fail "dry at first: $(cat log)"
grep -q "4 rows of series" log || fail "dry at first: $(cat log)"

# names that are numbers, of a table whose first column has none: neither is taken for the other
sed 's/{x: x, y: y}/{x: "1", y: "2"}/' text.yaml >numbered.yaml
refused ',0,1,2\n0,9,0,2.1\n1,9,4,1.9\n' numbered.yaml "profiles.files[0]: text.csv:1: this line may be names or numbers; put a # before it if they are names, or a number into each field"
sed -i 's/text.csv/table.csv/' numbered.yaml
printf '#,0,1,2\n0,9,0,2.1\n1,9,2,2\n2,9,4,1.9\n' >table.csv
"$program" import numbered.yaml -o text.h5 >log 2>&1 && "$program" diff plain.h5 text.h5 >log 2>&1 || fail "names after a #: $(cat log)"

# ---- the time ----
sidecar when <<<'profiles: {format: csv, file: text.csv, columns: {x: x, y: y}, time_after: "t="}'
sed -i 's/, time: 0//' text.yaml
time_of() { # text, the time
  printf "$1" >text.csv
  "$program" import when.yaml -o when.h5 >log 2>&1 || fail "a time of $2: $(cat log)"
  grep -qx "when.h5: 1 surface, from t = $2 to $2 s" log || fail "a time of $2: $(cat log)"
}
rows='x,y\n0,2.1\n4,1.9\n'
time_of "# t=3\n$rows" 3
time_of "#t=3, dt=0.5\n$rows" 3
time_of "# dt=0.5\n# t=3\n$rows" 3
time_of "# t=3\n# dt=0.5\n$rows" 3
time_of "# dt=0.5 out_t=7 4t=8 (t=3)\n$rows" 3
time_of "# \xce\x94t=0.5 t=3\n$rows" 3
sed -i 's/"t="/"="/' when.yaml
time_of "# time=3\n$rows" 3 # what begins with no letter may follow one
sed -i 's/"="/"t="/' when.yaml
for text in "# dt=0.5\n" "# T=3\n" "# t=soon\n" ""; do
  refused "$text$rows" when.yaml "profiles.file: text.csv has no comment with a number after 't='; correct time_after, or give the files their time by another key"
done

for word in 1,5 1.2.3 0x10 inf; do
  refused "# t=$word s\n$rows" when.yaml "profiles.file: text.csv:1: found the time '$word'; allowed: a decimal number; correct that line"
done
time_of "# t=3s, then words\n# t=3\n$rows" 3
refused "# t=0\n$rows# t=1\n0,2.2\n4,1.8\n" when.yaml "profiles.file: text.csv:5: found the time 1 after 0; allowed: one time in a file; divide it, or make the times a column"

# ---- the kind ----
sidecar kind <<<'particles: {format: csv, file: text.csv, columns: {time: t, x: x, y: y, only: kind}, is: 1}'
cloud() { # of each time its kind, one row of 40 x 20 particles
  echo "t,x,y,kind"
  for at in "$@"; do
    awk -v t="${at%:*}" -v kind="${at#*:}" 'BEGIN { OFS = ","; for (i = 0; i < 40; i++) for (j = 0; j < 20; j++) print t, 0.05 + 0.1 * i, 0.05 + 0.1 * j, kind == "both" ? 2 * (j % 2) : kind }'
  done
}
cloud 0:1 0.5:1 >text.csv
"$program" import kind.yaml -o kind.h5 >log 2>&1 || fail "particles of a kind: $(cat log)"
none() { # message, kinds
  cloud "${@:2}" >text.csv
  rm -f text.h5
  "$program" import kind.yaml -o text.h5 >log 2>&1
  code=$?
  [ $code = 2 ] && [ ! -e text.h5 ] || fail "$*: exit code $code: $(cat log)"
  grep -qF "text.csv has no particle whose 'kind' is 1$1; allowed for the key is: a value that is there" log || fail "$*: $(cat log)"
}
none " at its time 0: found 0" 0:0 0.5:1
none " at its time 0.5: found 2.5" 0:1 0.5:2.5
none " at its time 0.5: found 0, 2.5" 0:1 0.5:0 0.5:2.5
sed -i 's/{time: t, /{/; s/file: text.csv/files: [{file: text.csv, time: 0}]/' kind.yaml
none ": found 0, 2" 0:both

# ---- a result that is only shifted in time: the comparison tells by how much ----
pretend_gnuplot
for late in 0 0.07; do
  sed "s/^profiles.*/time_offset: $late\n&/; s/^run: .*/run: late-$late/" plain.yaml | sed 's/\[{file.*}\]/[{file: plain.csv, time: 0}, {file: plain.csv, time: 0.2}]/' >late-$late.yaml
  "$program" import late-$late.yaml -o late-$late.h5 >log 2>&1 || fail "late by $late: $(cat log)"
done
"$program" compare late-0.h5 late-0.07.h5 -o late >log 2>&1
grep -q "no outputs at common times: the nearest is 0.07 s after one of the reference (see time_offset)" log || fail "a shift is not told: $(cat log)"
"$program" compare late-0.07.h5 late-0.h5 -o late >log 2>&1
grep -q "the nearest is 0.07 s before one of the reference" log || fail "a shift back is not told: $(cat log)"

# ---- a periodic tank: particles that have gone on beyond its ends are water inside ----
cat >round.yaml <<'E2'
scales: {H: 1}
tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]], sides: periodic}
water: {wave: {kind: airy, depth: 1, amplitude: 0.01, wavelength: 4}}
time: {end: 1, every: 1}
runs: [{name: bem, solver: bem, resolution: 10}]
E2
for name in inside beyond; do
  cat >$name.yaml <<E2
run: same
solver: another
source: made up
case: round.yaml
spacing: 0.125
units: {length: m, time: s, pressure: Pa}
particles: {format: csv, files: [{file: $name.csv, time: 0}], columns: {x: x, y: y}}
E2
  awk -v gone=$([ $name = beyond ] && echo 1 || echo 0) 'BEGIN {
    print "x,y"
    for (i = 0; i < 32; i++) for (j = 0; j < 8 + (i < 9); j++) printf "%.17g,%.17g\n", (i + 0.5) / 8 + gone * (i % 3 - 1) * 4, (j + 0.5) / 8 }' >$name.csv
  "$program" import $name.yaml -o $name.h5 >log 2>&1 || fail "$name: $(cat log)"
done
"$program" diff inside.h5 beyond.h5 >log 2>&1 || fail "particles beyond the ends: $(cat log)"
exit $failed
