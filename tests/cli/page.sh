#!/usr/bin/env bash
# The report's page in a real browser. With AXE_CORE=axe.min.js (npm pack axe-core, as
# ./quickstart test does) its rules of accessibility are checked too.
source "$2/tests/cli/begin"

for tool in chromium chromedriver; do
  command -v $tool >/dev/null || {
    echo "$tool is not installed"
    exit 77
  }
done
command -v gnuplot >/dev/null || {
  echo "gnuplot is not installed"
  exit 77
}

cat >dam.yaml <<'E2'
title: "</script><img src=x onerror='window.hacked=1'> & \"a dam\""
scales: {H: 0.6}
tank:
  walls: [[[0, 2 H], [0, 0], [3 H, 0], [3 H, 2 H]]]
water:
  regions: [[[0, 0], [1 H, 0], [1 H, 1 H], [0, 1 H]]]
  pressure: released
time: {end: 0.6 sqrt(H/g), every: 0.05 sqrt(H/g), sample: 0.02 sqrt(H/g)}
probes: [{name: P1, at: [0, 0.3 H]}]
gauges: [{name: G1, x: 0.5 H}]
runs:
  - {name: bem, solver: bem, resolution: 15}
  - {name: plain, solver: sph, resolution: 12}
  - {name: fine, solver: sph, resolution: 16}
compare:
  reference: bem
  times: [0.3 sqrt(H/g), 0.6 sqrt(H/g)]
  tolerances:
    - {measure: mean_distance, max: 0.1}
    - {measure: front, max: 0.2}
    - {measure: probe_rms, max: 1}
E2
"$program" run dam.yaml --out out -q >log 2>&1 || fail "no report: $(cat log)"
[ -n "${AXE_CORE:-}" ] || echo "AXE_CORE is not set: rules of accessibility are not checked"
/usr/bin/python3 "$2/tests/cli/page.py" out/report.html ${AXE_CORE:+"$AXE_CORE"} || fail "the page"
exit $failed
