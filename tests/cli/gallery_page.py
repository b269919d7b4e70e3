"""What a browser makes of the gallery's page: python3 gallery_page.py GALLERY.html [AXE.js]. Exits 1 with a line for each
claim that does not hold."""
import json, pathlib, re, sys

from browser import Browser, check_access, claim, failed

gallery = json.loads((pathlib.Path(sys.argv[1]).parent / "gallery.json").read_text())
entries = gallery["entries"]
rules = sys.argv[2] if len(sys.argv) > 2 else None
VISIBLE = "return document.querySelector(arguments[0]).getBoundingClientRect().height > 0"
SHOWN = "return [...document.querySelectorAll(arguments[0])].filter(e => !e.hidden).map(e => e.dataset.entry || e.id)"
SET = "const e = document.getElementById(arguments[0]); e.value = arguments[1]; e.dispatchEvent(new Event(e.tagName === 'INPUT' ? 'input' : 'change'))"


def check_content(b):
    keys = [e["key"] for e in entries]
    claim(b.run("return [...document.querySelectorAll('.cards li')].map(e => e.dataset.entry)") == keys, "a card for each entry, in order")
    for e in entries:
        shown = b.run("return document.getElementById(arguments[0]).textContent", e["key"])
        for words in [e["id"], e["title"], e["where"], e["setup"], e["verdict_words"], *e["remarks"]]:
            claim(" ".join(words.split()) in " ".join(shown.split()), f"{e['id']} says: {words}")
        measured = b.run("return [...document.querySelectorAll(`#${arguments[0]} .checks tbody tr`)].map(r => parseFloat(r.cells[3].textContent))", e["key"].replace(".", "\\."))
        claim(len(measured) == len(e["checks"]), f"{e['id']} has a row for each check")
        for shown_value, check in zip(measured, e["checks"]):
            value = check.get("measured")
            claim(value is None or abs(shown_value - value) <= 1e-3 * abs(value), f"{e['id']} shows what was measured: {check['says']}: {shown_value}")
            claim(check["says"] in shown and check["source"] in shown, f"{e['id']} shows the check: {check['says']}")
            if check.get("because"):
                claim(check["because"] in shown, f"{e['id']} says why {check['says']} does not hold")
        for command in [e["command"]] + [c["command"] for c in e["cases"]]:
            claim(command in shown, f"{e['id']} says how it is made: {command}")
    claim(not b.run("return document.querySelector('main [onerror], main script')"), "no text is a script")


def check_figures(b):
    b.run("document.querySelectorAll('img').forEach(i => { i.loading = 'eager'; })")
    b.wait("[...document.images].every(i => i.complete)", "the figures")
    lost = b.run("return [...document.images].filter(i => !i.naturalWidth).map(i => i.src.slice(-60))")
    claim(not lost, f"figures are found: {lost}")
    files = sum(len([f for f in figure["files"] if "missing" not in f]) for e in entries for figure in e["figures"])
    claim(b.run("return document.querySelectorAll('article .paper img').length") == files, f"{files} figures are shown")
    here = pathlib.Path(sys.argv[1]).parent
    dead = [a for a in b.run("return [...document.querySelectorAll('article a')].map(a => a.getAttribute('href'))") if not (here / a).exists()]
    claim(not dead, f"links lead somewhere: {dead}")
    claim(pathlib.Path(sys.argv[1]).stat().st_size < 15e6, "the page is smaller than 15 MB")


def group_of(e):
    """P, or the chapter of T: "T Tab 2.1" is of "T 2"."""
    return "P" if e["id"][0] == "P" else "T " + re.search(r"\d", e["id"])[0]


def check_sieve(b):
    groups = b.run("return [...document.getElementById('of').options].map(o => o.value).filter(Boolean)")
    claim(set(groups) == {group_of(e) for e in entries}, f"groups are {groups}")
    for group in groups:
        b.run(SET, "of", group)
        left = [e["key"] for e in entries if group_of(e) == group]
        claim(left == b.run(SHOWN, ".cards li") == b.run(SHOWN, "article"), f"of {group} alone: {left}")
    b.run(SET, "of", "")
    for verdict in {e["verdict"] for e in entries}:
        b.run(SET, "verdict", verdict)
        claim(b.run(SHOWN, "article") == [e["key"] for e in entries if e["verdict"] == verdict], f"{verdict} alone")
    b.run(SET, "verdict", "")
    last = entries[-1]
    b.run(SET, "words", last["title"].upper())
    claim(last["key"] in b.run(SHOWN, "article"), "an entry is found by its title")
    b.run(SET, "words", "no entry has such words")
    claim(b.run(SHOWN, "article") == [] and b.run("return document.getElementById('count').textContent").startswith("0 of"), "none is found")
    b.run(f"location.hash = '#{last['key']}'")
    b.wait(f"!document.getElementById('{last['key']}').hidden", "an entry that a link leads to")


def check_looks(b):
    ground = "return getComputedStyle(document.body).backgroundColor"
    light = b.run(ground)
    check_access(b, "light", rules)
    b.tell("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark"}])
    claim(b.run(ground) != light, "dark follows the system")
    check_access(b, "dark", rules)
    b.run("document.getElementById('theme').click()")
    claim(b.run(ground) == light, "the switch makes it light")
    b.tell("Emulation.setEmulatedMedia", features=[])
    for width in (400, 1400, 3840):
        b.tell("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=False)
        wide = b.run("return document.documentElement.scrollWidth")
        claim(wide <= width, f"at {width} px nothing sticks out: {wide}")
    b.tell("Emulation.clearDeviceMetricsOverride")
    claim(b.pages() >= 2, "it prints")


def check_without_scripts(b):
    b.tell("Emulation.setScriptExecutionDisabled", value=True)
    b.open(sys.argv[1])
    for what in (".cards a", "article h3", ".checks table", ".tally"):
        claim(b.run(VISIBLE, what), f"{what} without scripts")
    claim(not b.run(VISIBLE, "#sieve"), "no choices without scripts")


browser = Browser()
try:
    browser.open(sys.argv[1])
    browser.wait("document.documentElement.dataset.ready === 'yes'", "the page")
    for check in (check_content, check_figures, check_sieve, check_looks):
        check(browser)
    for line in browser.ask("POST", "/se/log", {"type": "browser"}):
        claim(False, f"console: {line['level']} {line['message']}")
    check_without_scripts(browser)
finally:
    browser.close()
sys.exit(bool(failed))
