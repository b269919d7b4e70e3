#!/usr/bin/env bash
# plunge gallery: the list, one entry that needs no run and one that does, what is finished and what is made again, a run
# that leaves nothing, plans for other engines, and wrong words.
source "$2/tests/cli/begin"
pretend_gnuplot

# ---- the list ----
"$program" gallery --list >list || fail "--list: $?"
[ "$(grep -cE '^[PT] .{8} (theory|lattice|run|experiment|sketch|text) ' list)" = "$(wc -l <list)" ] ||
  fail "lines that are no entries: $(cat list)"
[ -e out ] && fail "--list makes something"
listed() { # words of a choice
  "$program" gallery "$@" --list >chosen || fail "$*: $?"
  cut -c1-10 chosen | sed 's/ *$//' | paste -sd,
}
[ "$(listed 'P 1..P 3' 'T 2-1')" = "$(listed 'T 2-1' P 1..3)" ] && [ "$(listed P 1..P 3)" = "P 1,P 2,P 3" ] ||
  fail "a range beside another: $(listed 'P 1..P 3' 'T 2-1')"
[ "$(listed T Tab 2)" = "$(listed 'T Tab 2.*')" ] && listed 'T 2' | grep -q 'T 2-1,.*T Tab 2.1' ||
  fail "tables of chapter 2: $(listed T Tab 2); $(listed 'T 2')"
id=$(awk 'substr($0, 12, 6) == "theory" {print substr($0, 1, 10); exit}' list | sed 's/ *$//')
key=${id// /-}

# ---- an entry of theory, made once ----
"$program" gallery "$id" --out g >log 2>err || fail "$id: $? $(cat log err)"
grep -q "^$id .* checks hold" log && grep -q '^1 entry: ' log || fail "$id says $(cat log)"
for file in gallery.json gallery.html entries/$key.json; do
  [ -s g/$file ] || fail "$id has left no $file"
done
[ -e g/runs ] && fail "theory runs something"
before=$(stat -c %Y%i "g/entries/$key.json")
"$program" gallery ${id,,} --out g >log 2>err || fail "$id again: $?"
grep -q '^1 of 1 entries are there already' err || fail "$id again: $(cat err)"
[ "$before" = "$(stat -c %Y%i "g/entries/$key.json")" ] || fail "$id was made again"
sed -i 's/"fingerprint": "./"fingerprint": "x/' "g/entries/$key.json"
"$program" gallery "$key" --out g --quiet >log 2>err || fail "$id of another program: $?"
[ -s err ] && fail "--quiet says $(cat err)"
grep -q '"fingerprint": "x' "g/entries/$key.json" && fail "an entry of another program stays"
before=$(stat -c %Y%i "g/entries/$key.json")
"$program" gallery "$id" --out g --force >log 2>err || fail "--force: $?"
[ "$before" = "$(stat -c %Y%i "g/entries/$key.json")" ] && fail "--force leaves $id"
echo broken >"g/entries/$key.json"
"$program" gallery "$id" --out g >log 2>err || fail "a damaged file: $? $(cat err)"
grep -q '"finished": true' "g/entries/$key.json" || fail "a damaged file stays"
grep -q "\"id\": \"$id\"" g/gallery.json || fail "$id is not in gallery.json"

# ---- without gnuplot: the numbers are there, the picture is not, and it is tried again ----
if grep -q '"name": ' "g/entries/$key.json"; then
  got=0
  printf '#!/bin/sh\nexit 1\n' >"$folder/.bin/gnuplot.none"
  mv "$folder/.bin/gnuplot" "$folder/.bin/gnuplot.kept" && cp "$folder/.bin/gnuplot.none" "$folder/.bin/gnuplot" && chmod +x "$folder/.bin/gnuplot"
  "$program" gallery "$id" --out g --force >log 2>err || got=$?
  [ $got = 3 ] && grep -q "^$id .* checks hold" log || fail "without gnuplot: $got $(cat log err)"
  grep -q '"finished": false' "g/entries/$key.json" || fail "without a picture $id is finished"
  mv "$folder/.bin/gnuplot.kept" "$folder/.bin/gnuplot"
  "$program" gallery "$id" --out g >log 2>err || fail "with gnuplot again: $? $(cat log err)"
fi

# ---- a picture or the numbers of a table that somebody has taken away ----
"$program" gallery "$key" --out g --quiet >log 2>err || fail "$id before: $? $(cat log err)"
for file in $(ls -r g/figures/$key.svg g/figures/$key.csv 2>/dev/null | head -1); do
  rm $file
  "$program" gallery "$id" --out g >log 2>err || fail "$id without $file: $? $(cat log err)"
  grep -q 'are there already' err && fail "$id without $file is finished"
  [ -s $file ] || fail "$file is gone for good"
done

# ---- the page says what it lacks, and whose it is ----
grep -q '1 of the [0-9]* entries' g/gallery.html && grep -q 'Not made here: .*, ' g/gallery.html &&
  grep -q 'plunge [0-9.]*, revision ' g/gallery.html || fail "the page of one entry looks whole"
got=0
"$program" gallery "$id" --quick --out g >log 2>err || got=$?
[ $got = 2 ] && grep -qx 'plunge: --out: found g, which has entries made without --quick; allowed: a folder of its own for each' err ||
  fail "--quick in the folder of a whole gallery: $got $(cat err)"
rm g/gallery.json # as if the first making had been stopped
got=0
"$program" gallery "$id" --quick --out g >log 2>err || got=$?
[ $got = 2 ] && [ ! -e g/gallery.json ] || fail "--quick in the folder of a gallery that was stopped: $got $(cat err)"

# ---- --force, stopped while the first of two is drawn: the other stays as it was ----
second=$(awk -v id="$id" 'substr($0, 12, 6) == "theory" && substr($0, 1, 10) !~ "^" id " " {print substr($0, 1, 10)}' list |
  sed -n '1s/ *$//p')
"$program" gallery "$id" "$second" --out f >log 2>err || fail "$id and $second: $? $(cat log err)"
mv "$folder/.bin/gnuplot" "$folder/.bin/gnuplot.kept"
printf '#!/bin/sh\nsleep 5\n' >"$folder/.bin/gnuplot" && chmod +x "$folder/.bin/gnuplot"
"$program" gallery "$id" "$second" --out f --force --jobs 1 >log 2>err &
pid=$!
for _ in $(seq 400); do
  [ "$(find f/entries -name '*.json' | wc -l)" = 2 ] || break
  sleep 0.05
done
kill -INT $pid
got=0
wait $pid || got=$?
mv "$folder/.bin/gnuplot.kept" "$folder/.bin/gnuplot"
[ $got = 3 ] && [ "$(find f/entries -type f | wc -l)$(find f/entries -name '*.json' | wc -l)" = 22 ] ||
  fail "--force, stopped: $got, left $(ls -A f/entries) $(cat err)"

# ---- an entry with runs ----
run=
for candidate in 'T 4-19' 'P 4'; do
  grep -q "^$candidate  " list && run=$candidate
done
if [ "$run" ]; then
  "$program" plan gallery "$run" --quick --for tsv --results r >plan.tsv || fail "no plan of $run"
  [ "$(head -1 plan.tsv)" = $'step\trun\tseconds\tMB\tcommand' ] || fail "head of the table: $(head -1 plan.tsv)"
  grep -q "^gallery.*cd $PWD/r && .* gallery --out . --quick '$run'$" plan.tsv || fail "the last step: $(tail -1 plan.tsv)"
  [ -s r/cases/"$(sed -n 's|.*r/cases/\([^ ]*\).*|\1|p' plan.tsv | head -1)" ] || fail "the plan has left no case"
  if command -v make >/dev/null; then
    "$program" plan gallery "$run" --quick --for make --results r --out plan.mk || fail "no Makefile of $run"
    make -f plan.mk >log 2>&1 || fail "make: $(tail -5 log)"
    [ -s r/gallery.html ] || fail "make has left no page"
  fi
  "$program" gallery "$run" --quick --out r --force >log 2>err || fail "$run: $? $(cat log err)"
  sed -n 's/^ *"command": "plunge \(run .*\)".*/\1/p' "r/entries/${run// /-}.json" >commands
  [ -s commands ] || fail "$run does not say how its runs are made"
  while read -r command; do # finds them as the gallery has made them
    (cd r && eval "'$program' $command") >log 2>err </dev/null && grep -q ' is there already' log err ||
      fail "by hand: $command: $(cat log err)"
  done <commands
  rm -r r/runs
  "$program" gallery "$run" --quick --out r >log 2>err || fail "$run without results: $? $(cat log err)"
  [ -e r/runs ] && fail "a finished entry runs again"
  "$program" gallery "$run" --quick --out r --force >log 2>err || fail "$run again: $? $(cat log err)"
  grep -q '"not_believed"' "r/entries/${run// /-}.json" && fail "a sound run is not believed"
  if /usr/bin/python3 -c 'import h5py' 2>/dev/null; then # a run that came to its end, and whose energy has risen
    /usr/bin/python3 - r/runs/*/*.h5 <<'END' || fail "no energy raised"
import h5py, sys
for path in sys.argv[1:]:
    with h5py.File(path, "r+") as f: f["series/energy/kinetic"][-1] += 1000 * abs(f["series/energy/potential"][0])
END
    rm "r/entries/${run// /-}.json"
    "$program" gallery "$run" --quick --out r >log 2>err
    says='run [^ ]* is finished, but not to be believed: .*energy rises by'
    grep -q "\"not_believed\": \"$says" "r/entries/${run// /-}.json" && grep -q "by its own measures: $says" r/gallery.html ||
      fail "a run not to be believed: $(cat log err)"
  fi
  if command -v flock >/dev/null; then # it fails before its file is replaced: that of before is not its result
    result=$(find r/runs -name '*.h5' ! -name '.*' | head -1) got=0
    exec 9>"${result%/*}/.${result##*/}.lock" && flock 9
    "$program" gallery "$run" --quick --out r --force >log 2>err || got=$?
    exec 9>&-
    [ $got = 3 ] && grep -q "^$run .*could not be made .*run .* has failed" log && [ ! -e "$result" ] ||
      fail "--force that fails: $got $(cat log err)"
  fi
  "$program" plan gallery "$run" --quick --for tsv --results r | sed -n 's/^run\t\([^\t]*\).*/\1/p' >runs
  rm -r r/runs
  while read -r name; do mkdir -p "r/runs/$name.h5/in the way"; done <runs
  got=0
  "$program" gallery "$run" --quick --out r --force >log 2>err || got=$?
  [ $got = 3 ] && grep -q "^$run .*could not be made .*run .* has failed" log ||
    fail "results that cannot be written: $got $(cat log err)"
  grep -q ' 0 of 0 checks hold' r/gallery.html && ! grep -q 'Something has changed' r/gallery.html ||
    fail "the page counts checks of what could not be made"
  "$program" plan gallery "$run" --for slurm --results r | bash -n || fail "the script is none"
else
  echo "no entry with short runs: not tried"
fi

# ---- stopped: what is finished stays ----
if grep -q '^P 2  ' list; then
  "$program" gallery "$id" 'P 2' --out s >log 2>err &
  pid=$!
  for _ in $(seq 400); do
    [ "$(find s/runs -name '*.h5' 2>/dev/null)" ] && break
    sleep 0.05
  done
  kill -INT $pid
  got=0
  wait $pid || got=$?
  [ $got = 3 ] && [ "$(tail -2 err)" = "what is finished stays; the same command makes the rest and the page
plunge: stopped" ] || fail "stopped: $got $(cat log err)"
  [ -e s/gallery.json ] && fail "a stopped gallery looks whole"
fi

# ---- wrong words: exit code 2, this sentence, nothing made ----
hint="Try \`plunge [a-z]* --help' or \`plunge [a-z]* --usage' for more information."
wrong() { # sentence, arguments
  local sentence=$1 got=0
  shift
  "$program" "$@" >out.log 2>log || got=$?
  [ $got = 2 ] && [ ! -s out.log ] || fail "$*: code $got"
  [ "$(grep -vx "$hint" log)" = "$sentence" ] || fail "$*: $(cat log)"
}
allowed="allowed: an id that \`plunge gallery --list\` shows, as in 'P 1' or 'T 4-*'"
wrong "plunge: found 'nothing'; $allowed" gallery nothing
wrong "plunge: found 'nothing'; $allowed" gallery "$id" nothing --list
wrong "plunge: found ''; $allowed" gallery ''
wrong "plunge: found '$id..'; $allowed; did you mean '$id'?" gallery "$id.."
wrong "plunge: found '..$id'; $allowed; did you mean '$id'?" gallery "..$id"
wrong "plunge gallery: --out: found ''; allowed: a folder" gallery --out ''
wrong "plunge gallery: --jobs 0: give a whole number from 1 to 1024" gallery --jobs 0
wrong "plunge gallery: --threads x: give a whole number from 1 to 1024" gallery --threads x
wrong "plunge gallery: unrecognized option '--set'" gallery --set
wrong "plunge plan: --quick is for plunge plan gallery" plan case.yaml --quick --for make
wrong "plunge plan: of the gallery, name entries in place of --only" plan gallery --only a --for make
wrong "plunge plan: --set is for cases; the gallery's overrides are its entries'" plan gallery --set a=b --for make
wrong "plunge: found 'nothing'; $allowed" plan gallery nothing --for make
wrong "plunge: these entries need no runs; allowed: entries that have some, as \`plunge gallery\` makes the others at once" \
  plan gallery "$id" --for make
[ -e out ] && fail "wrong words make something"
exit $failed
