#!/usr/bin/env bash
# plunge theory: every topic as a table, as CSV, as JSON and as a figure; lists of values; what it refuses.
source "$2/tests/cli/begin"
refuse() { # wanted message, then the command's words
  local wanted=$1 got=0
  shift
  "$program" theory "$@" >log 2>&1 || got=$?
  [ "$got" = 2 ] || fail "theory $*: exit code $got: $(head -3 log)"
  [ "$(head -1 log)" = "$wanted" ] || fail "theory $* says: $(cat log)"
}

"$program" theory >topics || fail "no list of topics"
"$program" theory | head -1 >/dev/null || fail "a reader that has had enough is a failure"
topics=$(awk '/^  [a-z]/ {print $1}' topics)
[ "$(wc -w <<<"$topics")" -ge 23 ] || fail "too few topics: $topics"
for topic in $topics; do
  "$program" theory "$topic" --help >log || fail "$topic --help"
  grep -q "default" log || fail "$topic --help names no parameters: $(cat log)"
  "$program" theory "$topic" >table 2>log || fail "$topic: $(cat log)"
  head -1 table | grep -q "^$topic: " || fail "$topic has no head"
  "$program" theory "$topic" --csv rows.csv --json - >numbers.json 2>log || fail "$topic: $(cat log)"
  awk -F'","|",|,"' 'NR == 1 {n = split($0, head, ","); exit n < 4}' rows.csv || fail "$topic has no columns"
  grep -q "\"topic\": \"$topic\"" numbers.json || fail "$topic has no JSON"
  grep -qi "nan\|inf" numbers.json && grep -qE ": (nan|inf)" numbers.json && fail "$topic has JSON that is none"
done

# numbers: the paper's first figure, all digits
"$program" theory dispersion --json - | grep -q '"mu_star": 2\.52513342' || fail "mu* of the paper's figure 1"
"$program" theory dispersion --delta "0.2, 1" --alpha 0,0.01 --points 3 --csv - >rows.csv
[ "$(wc -l <rows.csv)" = 13 ] || fail "two lists of two values are not four curves: $(cat rows.csv)"
head -1 rows.csv | grep -qxF 'curve,name,mu [1],a [c0],b [c0],b_minus [c0]' || fail "head: $(head -1 rows.csv)"
sed -n 5p rows.csv | grep -qE '^1,"alpha = 0, delta = 1",' || fail "names: $(cat rows.csv)"

# ---- figures ----
pretend_gnuplot
for format in svg pdf png; do
  "$program" theory damping --figure "it's.$format" >log 2>&1 || fail "no figure: $(cat log)"
  [ -s "it's.$format" ] || fail "no .$format"
done
[ ! -s log ] || fail "a figure is no reason to talk: $(cat log)"
[ "$(ls | grep -cE "^it's")" = 3 ] || fail "more than was asked for: $(ls)"
mkdir there
"$program" theory roots --figure there/roots.svg --json there/roots.json || fail "no figure in a folder"
[ "$(ls -A there | wc -l)" = 2 ] || fail "something is left behind: $(ls -A there)"

# ---- what is refused ----
refuse "plunge: delta: found '-1'; allowed: a number from 0 to 10, or auto" stability --delta -1
"$program" theory stability --waves 8 --points 2 --json - | grep -q '"delta": "auto"' || fail "no word in JSON"
refuse "plunge: there is no topic 'dispersoin'; did you mean 'dispersion'?" dispersoin
refuse "plunge: there is no topic 'zzz'; plunge theory lists them" zzz
refuse "plunge: alpha: found 'x'; allowed: a number from 0 to 100" dispersion --alpha x
refuse "plunge: alpha: found '-1'; allowed: a number from 0 to 100" dispersion --alpha 0,-1
refuse "plunge: alpha: found ''; allowed: a number from 0 to 100" dispersion --alpha 0,
refuse "plunge: points: found '1'; allowed: a whole number from 2 to 100000" dispersion --points 1
refuse "plunge: operator: found 'latice'; allowed: one of continuum, lattice; did you mean 'lattice'?" dispersion --operator latice
refuse "plunge: ratio: found '1 H'; allowed: a number from 0.5 to 4; write it without a unit" kernel --ratio "1 H"
refuse "plunge: from = 5: from: found 5; allowed: less than to = 4" waves --from 1,5 --to 4 --beta 1
refuse "plunge: integrator: found rk4-split with a diffusion that needs the density gradient, in each of its stages; allowed: any other; write integrator: rk4-frozen" stability --integrator rk4-split --diffusion antuono
refuse "plunge: surface: the lists make more than 64 curves; give fewer values" surface --rows "$(seq -s, 1 65)"
refuse "plunge: figure.txt is no name of a figure; allowed: NAME.svg, NAME.pdf, NAME.png" damping --figure figure.txt
refuse "plunge theory damping: other: one topic at a time; a parameter is --NAME=VALUE" damping other
refuse "plunge theory damping: unrecognized option '--alpha=1'" damping --alpha=1
got=0
"$program" theory damping --csv nowhere/x.csv >log 2>&1 || got=$?
[ $got = 3 ] && grep -q "cannot write nowhere/x.csv" log || fail "a folder that is not there: $got $(cat log)"
exit $failed
