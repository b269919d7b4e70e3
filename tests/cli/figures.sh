#!/usr/bin/env bash
# Figures for print: two columns are 180 mm wide, one is 90 mm; text has 8 pt and notes 6.5 pt; fonts are embedded.
source "$2/tests/cli/begin"
for tool in gnuplot pdftotext pdffonts; do
  command -v $tool >/dev/null || {
    echo "$tool is not installed"
    exit 77
  }
done

cat >dam.yaml <<'E2'
scales: {H: 0.6}
tank:
  walls: [[[0, 2 H], [0, 0], [3 H, 0], [3 H, 2 H]]]
water:
  regions: [[[0, 0], [1 H, 0], [1 H, 1 H], [0, 1 H]]]
  pressure: released
time: {end: 0.4 sqrt(H/g), every: 0.1 sqrt(H/g), sample: 0.02 sqrt(H/g)}
probes: [{name: P1, at: [0, 0.3 H]}, {name: P1-column, at: [0, 0.5 H]}]
runs:
  - {name: fine, solver: bem, resolution: 12}
  - {name: a-run-of-a-name-that-is-longer-than-others, solver: bem, resolution: 8}
  - {name: coarse, solver: bem, resolution: 10}
compare:
  reference: fine
  times: [0.2 sqrt(H/g)]
  spectra: [{series: P1}]
E2
"$program" run dam.yaml --out out -q >log 2>&1 || fail "no report: $(cat log)"

width() { LC_ALL=C grep -a -m 1 MediaBox "$1" | sed -n 's/.*MediaBox \[ 0 0 \([0-9.]*\) .*/\1/p'; }
digits() { # widths of numbers in pt for each of their digits, which are 0.636 of the size in DejaVu Sans; one is upright, in a label
  pdftotext -bbox "$1" - | sed -n 's/.*xMin="\([0-9.]*\)".*xMax="\([0-9.]*\)".*>\([0-9][0-9]*\)<.*/\1 \2 \3/p' |
    awk '{print ($2 - $1) / length($3)}'
}

columns=0
for script in out/figures/*.gp; do
  name=${script%.gp}
  [ "$(width "$name.pdf")" = 510 ] || fail "${name##*/}.pdf is $(width "$name.pdf") pt wide, not 180 mm"
  case $name in
  *overlay* | *convergence* | *velocity*) [ ! -e "$name-column.pdf" ] || fail "${name##*/} in one column" ;;
  *)
    [ "$(width "$name-column.pdf")" = 255 ] || fail "${name##*/}-column.pdf is $(width "$name-column.pdf") pt wide, not 90 mm"
    columns=$((columns + 1))
    ;;
  esac
done
[ $columns -ge 8 ] || fail "only $columns figures of one column"
[ "$(grep -l "output 'pressure-P1-column'" out/figures/*.gp | wc -l)" = 0 ] || fail "two figures share a file"
for file in out/figures/{distance,distance-column,overlay-t0.2}.pdf; do
  pdffonts "$file" | awk 'NR > 2 && $(NF - 4) != "yes" {exit 1}' || fail "fonts of $file are not embedded"
done
font=$(pdffonts out/figures/distance.pdf | tail -n +3)
if grep -q DejaVuSans <<<"$font"; then
  for file in distance distance-column; do
    digits out/figures/$file.pdf | awk '{n++; d = $1 - 8 * 0.636; if (d < -0.05 || d > 0.05) bad++} END {exit !(n >= 4 && bad <= 1)}' ||
      fail "text of $file has not 8 pt: $(digits out/figures/$file.pdf | sort | uniq -c)"
  done
else
  echo "gnuplot draws in another font: the size of text is not checked"
fi
grep -q 'figures/distance-column.pdf' out/report.html || fail "the page leads to no figure of one column"
exit $failed
