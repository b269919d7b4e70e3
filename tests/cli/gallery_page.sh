#!/usr/bin/env bash
# The gallery's page in a real browser, of a few entries. With AXE_CORE=axe.min.js (npm pack axe-core, as ./quickstart
# test does) its rules of accessibility are checked too.
source "$2/tests/cli/begin"

for tool in chromium chromedriver gnuplot; do
  command -v $tool >/dev/null || {
    echo "$tool is not installed"
    exit 77
  }
done

"$program" gallery 'T 2-24' 'T Tab 2.2' 'T 3-1' --quick --out out -q >log 2>&1
[ -s out/gallery.html ] || fail "no page: $(cat log)"
[ -n "${AXE_CORE:-}" ] || echo "AXE_CORE is not set: rules of accessibility are not checked"
/usr/bin/python3 "$2/tests/cli/gallery_page.py" out/gallery.html ${AXE_CORE:+"$AXE_CORE"} || fail "the page"
exit $failed
