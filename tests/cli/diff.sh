#!/usr/bin/env bash
# plunge diff as a user and a continuous integration have it: files, folders, tolerances of times, the report in four forms.
source "$2/tests/cli/begin"
pretend_gnuplot
python=/usr/bin/python3

says() { # the one line of talk
  [ "$(tail -1 talk)" = "$1" ] || fail "expected '$1', found '$(cat talk)'"
}

small_dam 4 0.5 0.1 <<'E2'
probes:
  - {name: P1, at: [0, 0.1 H]}
runs:
  - {name: bem, solver: bem, resolution: 15}
  - {name: sph, solver: sph, resolution: 15}
compare:
  reference: bem
E2
run() { "$program" run dam.yaml --threads 1 -q "$@" >log 2>&1 || fail "no run: $(cat log)"; }

# ---- the recipe of docs/ci.md: baseline, the same again, a change, a tolerance for it ----
run --out baseline
run --out now
code 0 "$program" diff baseline now --out same
grep -qx "0 of 2 runs differ" log || fail "the same runs: $(cat log)"
for file in diff.html diff.json diff.md diff.xml; do [ -s "same/$file" ] || fail "no $file"; done
grep -q "## plunge diff: same" same/diff.md || fail "the summary: $(cat same/diff.md)"
run --out now --set runs.sph.alpha=0.02
code 1 "$program" diff baseline now --out changed
grep -qx "1 of 2 runs differ" log && grep -qx "sph.h5:" log || fail "a change: $(cat log)"
grep -q "^first difference at t = .*: series/energy/" log || fail "no first difference: $(cat log)"
"$program" diff baseline now --draft >tolerances || [ $? = 1 ] || fail "no draft"
code 0 "$program" diff baseline now --tol tolerances --out allowed
code 1 "$program" diff baseline/bem.h5 now/sph.h5 --out two
grep -q "report: two/diff.html" log || fail "two files: $(cat log)"
code 0 "$program" diff baseline/bem.h5 now/bem.h5 --out $'a\e[31mred'
grep -qxF 'report: a\x1b[31mred/diff.html' log || fail "a name commands the terminal: $(cat -v log)"
code 0 "$program" compare baseline/bem.h5 baseline/sph.h5 --out $'b\e[31mred'
grep -qF 'report: b\x1b[31mred/report.html' log || fail "a name commands the terminal: $(cat -v log)"

# ---- what the report says ----
$python - changed same <<'E2' || fail "diff.json"
import json, sys
d = json.load(open("changed/diff.json"))
assert d["outcome"] == "differs" and [r["outcome"] for r in d["runs"]] == ["same", "differs"], d["runs"]
run = d["runs"][1]
assert run["differ"] == sum(q["outcome"] == "differs" for q in run["quantities"]) > 5
assert run["differ"] + run["same"] + run["ignored"] == len(run["quantities"])
first = min(q["t"] for q in run["quantities"] if q.get("t") is not None)
assert first == run["t"] and abs(run["t_star"] - first / (0.6 / 9.81) ** 0.5) < 1e-9
alpha = next(q for q in run["quantities"] if q["name"] == "parameters/alpha")
assert alpha["worst"]["a"] == 0.01 and alpha["worst"]["b"] == 0.02 and alpha["t"] is None
pressure = next(q for q in run["quantities"] if q["name"] == "series/probes/P1/pressure")
assert abs(pressure["worst"]["y"] - 0.06) < 1e-12 and pressure["worst"]["x"] == 0
assert pressure["first"]["t"] <= pressure["worst"]["t"] and pressure["relative"] > 0
assert any("overlay" in f["name"] for f in run["figures"]) and any("distance" in f["name"] for f in run["figures"])
assert sum(f["name"].startswith("sph-energy") for f in run["figures"]) > 1
s = run["surfaces"]
assert s and all(x["mean_distance"] <= x["largest_distance"] for x in s)
assert json.load(open("same/diff.json"))["outcome"] == "same"
page = open("changed/diff.html").read()
start = page.index('<script type="application/json" id="data">') + 42
assert json.loads(page[start:page.index("</script>", start)]) == d
assert "<td class=\"t\">parameters/alpha</td>" in page
assert "http://" not in page.replace("http://www.w3.org", "") and "https://" not in page
E2
if command -v xmllint >/dev/null; then
  xmllint --noout changed/diff.xml same/diff.xml || fail "diff.xml is no XML"
  n=$(xmllint --xpath 'count(//testsuite[@name="sph.h5"]/testcase/failure)' changed/diff.xml)
  [ "$n" = "$(xmllint --xpath 'string(//testsuite[@name="sph.h5"]/@failures)' changed/diff.xml)" ] && [ "$n" -gt 5 ] ||
    fail "the failures in diff.xml: $n"
  [ "$(xmllint --xpath 'count(//failure)' same/diff.xml)" = 0 ] || fail "failures of the same runs"
fi

# ---- a run that only one has; a damaged one ----
mkdir -p now/more && cp baseline/bem.h5 now/more/extra.h5
mv now/bem.h5 moved.h5
code 1 "$program" diff baseline now --out alone
grep -qx "bem.h5: only in baseline" log && grep -qx "more/extra.h5: only in now" log || fail "alone: $(cat log)"
grep -qx "1 of 3 runs differ, 1 only in A, 1 only in B" log || fail "counts: $(cat log)"
head -c 3000 moved.h5 >now/bem.h5
code 2 "$program" diff baseline now --out damaged
grep -q "bem.h5" talk && grep -qx "1 of 3 runs differ, 1 only in B, 1 could not be read" log || fail "damaged: $(cat log talk)"
! command -v xmllint >/dev/null || [ "$(xmllint --xpath 'count(//error)' damaged/diff.xml)" = 1 ] || fail "no error in diff.xml"
mv moved.h5 now/bem.h5
rm -r now/more

# ---- links are followed; those that lead nowhere, or round, are named ----
mkdir linked && ln -s ../baseline/bem.h5 linked/bem.h5 && ln -s nowhere linked/notes.txt
mkdir linked/more && ln -s ../../baseline linked/more/folder
mkdir plain plain/more && cp -r baseline plain/more/folder && cp baseline/bem.h5 plain
code 0 "$program" diff linked plain
grep -qx "0 of 3 runs differ" log || fail "links: $(cat log)"
ln -s nowhere.h5 linked/gone.h5
code 2 "$program" diff linked plain
says "plunge: linked/gone.h5 is a link to a file that is not there"
rm linked/gone.h5
ln -s .. linked/more/round
code 2 "$program" diff linked plain
says "plunge: linked/more/round is a link to the folder that it is in: remove it"
rm linked/more/round
ln -s loop.h5 linked/loop.h5
code 2 "$program" diff linked plain
grep -q "^plunge: .*linked/loop.h5" talk && [ "$(wc -l <talk)" = 1 ] || fail "a link to itself: $(cat talk)"

# ---- times ----
echo "* ignore
series/energy/* 0 0 t*>0.3
series/energy/* 0 1e9 t*<=0.3" >late
code 1 "$program" diff baseline/sph.h5 now/sph.h5 --tol late
grep -qE "first difference at t = .*\(t sqrt\(g/H\) = 0.3[0-9]*\)" log || fail "a tolerance until a time: $(cat log)"
echo "serie/* 0 1" >slip
code 1 "$program" diff baseline now --tol slip
says "plunge: slip:1: serie/* is the rule of nothing in these results"

# ---- wrong words ----
mkdir empty
code 2 "$program" diff baseline now/sph.h5
says "plunge: baseline is a folder and now/sph.h5 is not: name two files or two folders"
code 2 "$program" diff now/sph.h5 baseline
says "plunge: baseline is a folder and now/sph.h5 is not: name two files or two folders"
code 2 "$program" diff empty empty
says "plunge: there is no result (NAME.h5) in empty nor in empty"
code 2 "$program" diff baseline nowhere
says "plunge: baseline is a folder and nowhere is not: name two files or two folders"
code 2 "$program" diff missing.h5 now/sph.h5
says "plunge: cannot read missing.h5: No such file or directory"
code 2 "$program" diff baseline now --tol missing
says "plunge: cannot read tolerances, a text of at most 1 MB, from missing: found nothing to read (No such file or directory)"
code 2 "$program" diff baseline now --out dam.yaml
says "plunge: dam.yaml is not a folder; choose another --out"
for words in "|name two result files, or two folders of them" "baseline|name two result files, or two folders of them" \
  "a b c|two files or folders are compared; c is the third" "a b --rtol x|--rtol x: give a number that is not negative" \
  "a b --rtol -1|--rtol -1: give a number that is not negative" "a b --atol inf|--atol inf: give a number that is not negative" \
  "a b --out=|--out: the folder's name is empty" "a b --draft --out c|--draft writes tolerances and --out a report: one at a time" \
  "a b --nothing|unrecognized option '--nothing'"; do
  # shellcheck disable=SC2086
  code 2 "$program" diff ${words%%|*}
  grep -qF -- "${words#*|}" talk || fail "expected '${words#*|}', found: $(cat talk)"
done
[ ! -e c ] || fail "a refused report leaves a folder"

# ---- names that would be commands: in HTML, XML, Markdown, gnuplot and paths ----
$python -c 'import h5py' 2>/dev/null || exit $failed
unset -f pretend_gnuplot
PATH=${PATH#"$folder/.bin:"}

# ---- surfaces that are the same but for rounding have no close-up; those a little further apart have one ----
for raised in 1e-13 2e-6; do
  cp baseline/bem.h5 raised.h5
  $python - $raised <<'E2' || fail "no raised surface"
import h5py, sys
with h5py.File("raised.h5", "r+") as f: f["surface/points"][:, 1] += float(sys.argv[1]) * 0.6
E2
  code 1 "$program" diff baseline/bem.h5 raised.h5 --out raised-$raised
  [ "$(cat talk)" = "drawing $(ls raised-$raised/figures/*.gp | wc -l) figures" ] || fail "raised by $raised: $(cat talk)"
done
ls raised-1e-13/figures/closeup* >talk 2>&1 && fail "a close-up of rounding"
ls raised-2e-6/figures/closeup*.png >talk 2>&1 || fail "no close-up of a difference"

mkdir -p "evil/a" "evil/b"
name='</script><img src=x onerror=alert(1)>`|@all $(touch hit) '"'"'; system "touch hit" #.h5'
cp baseline/sph.h5 "evil/a/${name//\//}"
cp now/sph.h5 "evil/b/${name//\//}"
$python - "evil/a/${name//\//}" "evil/b/${name//\//}" <<'E2' || fail "no made-up names"
import h5py, sys
for path in sys.argv[1:]:
    with h5py.File(path, "r+") as f:
        f.attrs["run"] = "</script><script>alert(2)</script>'\n; system 'touch hit' ` \"&]]>"
        f.attrs["title"] = "\x1b[31m<b>"
        f.move("series/probes/P1", "series/probes/<b>'; system 'touch hit' #`|")
        f["series/probes/<b>'; system 'touch hit' #`|/pressure"].attrs["units"] = "'; system 'touch hit' #"
E2
code 1 "$program" diff evil/a evil/b --out hostile
[ ! -e hit ] && [ ! -e hostile/figures/hit ] && [ -z "$(find . -name hit)" ] || fail "a name was a command"
grep -qE 'could not be drawn|cannot draw' talk && fail "a name spoils a picture: $(cat talk)"
$python - <<'E2' || fail "names in the report"
import html.parser, json, re
class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__(); self.tags = []; self.data = None; self.inside = False
    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        for key, value in attributes:
            assert not key.startswith("on"), (tag, key)
        assert tag != "img" or dict(attributes)["src"].startswith("data:")
        assert tag != "b" or dict(attributes).get("class"), "a tag of a name"
        self.inside = tag == "script" and dict(attributes).get("type") == "application/json"
    def handle_data(self, data):
        if self.inside: self.data = (self.data or "") + data
    def handle_endtag(self, tag):
        self.inside = False
p = Page()
p.feed(open("hostile/diff.html").read())
assert p.tags.count("script") == 2, p.tags.count("script")
d = json.loads(p.data)
assert d == json.load(open("hostile/diff.json"))
assert "<script>" in d["runs"][0]["name"].replace("img src=x", "script") or "<img" in d["runs"][0]["name"]
md = open("hostile/diff.md").read()
outside = re.sub(r"(`+)(?!`).*?(?<!`)\1(?!`)", "", md)
assert "<" not in outside and "@" not in outside and "$" not in outside, outside
for line in outside.splitlines():
    if line.startswith("|") and "`" not in line:
        assert line.count("|") in (6, 7), line
E2
! command -v xmllint >/dev/null || xmllint --noout hostile/diff.xml || fail "names break diff.xml"
exit $failed
