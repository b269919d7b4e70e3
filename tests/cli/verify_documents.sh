#!/usr/bin/env bash
# The gallery with --quick, whole: all items of both documents are there, each was made, and every check came out
# as it is known to (exit code 0).
source "$2/tests/cli/begin"

ids() {
  local n
  for n in $(seq 10); do echo "P $n"; done
  for n in $(seq 34); do echo "T 2-$n"; done
  for n in 1 2; do echo "T 3-$n"; done
  for n in $(seq 48); do echo "T 4-$n"; done
  for n in 2.1 2.2 2.3 2.4 3.1 3.2; do echo "T Tab $n"; done
}

ids | sort >expected
"$program" gallery --list | cut -c 1-10 | sed 's/ *$//' | sort | diff expected - >log ||
  { fail "other entries than the items of the documents: $(cat log)"; exit $failed; }
"$program" gallery --quick --out g --quiet >log 2>err || fail "exit code $?: $(grep -v ' agrees ' log) $(tail -5 err)"
tail -2 log
sed -n 's/^   "id": "\(.*\)",$/\1/p' g/gallery.json | sort | diff expected - >log || fail "gallery.json has others: $(cat log)"
grep -q '"verdict": "failed"' g/gallery.json && fail "an entry could not be made"
[ -s g/gallery.html ] || fail "no page"
exit $failed
