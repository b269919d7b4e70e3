"""What a browser makes of a report: python3 page.py REPORT.html [AXE.js]. Exits 1 with a line for each claim that does
not hold."""
import json, pathlib, sys, time

from browser import Browser, check_access, claim, failed

report = json.loads((pathlib.Path(sys.argv[1]).parent / "report.json").read_text())
rules = sys.argv[2] if len(sys.argv) > 2 else None


PICTURE = "return document.getElementById('picture').toDataURL()"
NOW = "return document.getElementById('now').textContent"
VALUES = "return [...document.querySelectorAll('.legend b')].map(b => b.textContent).join(' ')"
LEFT, RIGHT, HOME, END = "\ue012", "\ue014", "\ue011", "\ue010"


def settled(b):
    """The picture once it does not change any more."""
    before = None
    for _ in range(100):
        now = b.run(PICTURE)
        if now == before:
            return now
        before = now
        time.sleep(0.1)
    return before


def check_time(b):
    first, values, now = settled(b), b.run(VALUES), b.run(NOW)
    b.run("const s = document.getElementById('time'); s.value = Math.floor(s.max / 3); s.dispatchEvent(new Event('input'))")
    claim(settled(b) != first and b.run(NOW) != now, "the slider changes the picture and the time")
    if b.run("return document.querySelectorAll('.chart').length"):
        claim(b.run(VALUES) != values, "the slider changes the numbers of the charts")
    b.run("document.getElementById('picture').focus()")
    b.key(HOME)
    claim("t* = 0.000" in b.run(NOW), "Home goes to the start")
    b.key(RIGHT)
    later = b.run(NOW)
    claim("t* = 0.000" not in later, "an arrow steps")
    b.key(LEFT)
    b.key(" ")
    b.wait(f"document.getElementById('now').textContent !== {json.dumps('t* = 0.000 · 0.000 s')}", "play")
    b.key(END)
    b.wait("document.getElementById('play').textContent === '▶'", "the end of play")


def check_controls(b):
    for key, box in (("v", "show-velocity"), ("u", "show-surfaces"), ("p", "show-points")):
        before, checked = settled(b), b.run(f"return document.getElementById('{box}').checked")
        b.key(key)
        claim(b.run(f"return document.getElementById('{box}').checked") != checked, f"{key} toggles {box}")
        claim(settled(b) != before, f"{box} changes the picture")
        b.key(key)
    for colour in ("speed", "rho", "difference", "p"):
        before = settled(b)
        b.run(f"const s = document.getElementById('colour'); s.value = '{colour}'; s.dispatchEvent(new Event('change'))")
        claim(settled(b) != before, f"colour by {colour} changes the picture")
    before = settled(b)
    b.key("+")
    claim(settled(b) != before, "+ zooms")
    b.key("0")
    b.run("document.getElementById('run-1').click()")
    claim(settled(b) != before, "a run goes off")
    b.run("document.getElementById('run-1').click()")
    b.run("""const p = document.getElementById('picture'), at = p.getBoundingClientRect();
      p.dispatchEvent(new PointerEvent('pointermove', {clientX: at.left + at.width / 2, clientY: at.top + at.height * 0.8}))""")
    claim("x = " in b.run("return document.getElementById('pointed').textContent"), "the pointer shows where it is")


SPANS = """return [...document.querySelectorAll('.chart svg')].map(s => s.getAttribute('aria-label').match(/from t\\* = (\\S+) to (\\S+)$/)
  .slice(1).map(Number))"""


def spans(b):
    """The times that charts show: those of all, when they are the same."""
    time.sleep(0.3)  # of D3's wheel, and the next frame
    found = b.run(SPANS)
    return found[0] if all(f == found[0] for f in found) else None


def check_zoom(b):
    b.run("document.querySelector('.drawing').scrollIntoView({block: 'center', behavior: 'instant'})")
    box = b.run("const r = document.querySelector('.drawing').getBoundingClientRect(); return [r.left, r.top, r.width, r.height]")
    x, y = box[0] + 0.6 * box[2], box[1] + 0.5 * box[3]
    whole = b.run(SPANS)[0]
    claim(whole[0] == 0 and whole[1] > 0.5, f"charts begin with all times: {whole}")

    def widths(what, fine):
        span = spans(b)
        claim(span is not None and span[0] >= 0 and span[1] <= whole[1] and fine(*span), f"{what}: {span} of {whole}")
        return span

    mouse = lambda kind, at, modifiers=0, **more: b.tell("Input.dispatchMouseEvent", type=kind, x=at, y=y, modifiers=modifiers, **more)
    mouse("mouseWheel", x, 2, deltaX=0, deltaY=-400)
    near = widths("Ctrl and wheel zoom all charts", lambda low, high: high - low < 0.7 * whole[1] and low > 0)
    now = b.run(NOW)
    pressed = dict(button="left", buttons=1, clickCount=1)
    for kind, at in (("mousePressed", x), ("mouseMoved", x + 30), ("mouseMoved", x + 60), ("mouseReleased", x + 60)):
        mouse(kind, at, 8, **pressed)
    moved = widths("Shift and drag move them", lambda low, high: low < near[0] - 1e-6)
    claim(abs(moved[1] - moved[0] - (near[1] - near[0])) < 2e-3 * whole[1] and b.run(NOW) == now, "a move keeps the width and the time")
    b.run("document.querySelector('.drawing').dispatchEvent(new MouseEvent('dblclick', {bubbles: true, view: window}))")
    time.sleep(0.3)
    claim(b.run(SPANS)[0] == whole, "a double click shows all times")
    b.run("document.querySelector('.drawing').focus()")
    view = settled(b)
    b.key("+")
    b.key("+")
    near = widths("+ zooms", lambda low, high: abs((high - low) / whole[1] - 0.64) < 2e-3)
    b.key(RIGHT if near[0] == 0 else LEFT)
    widths("an arrow moves", lambda low, high: low != near[0])
    claim(b.run(NOW) == now and settled(b) == view, "keys of a chart leave the picture alone")
    b.run("document.querySelector('.back').click()")
    time.sleep(0.3)
    claim(b.run(SPANS)[0] == whole and b.run("return document.querySelector('.back').hidden"), "the button shows all times")
    touch = lambda kind, *at: b.tell("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": p, "y": y, "id": k} for k, p in enumerate(at)])
    b.tell("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=2)
    for kind, at in (("touchStart", (x - 20,)), ("touchStart", (x - 20, x + 20)), ("touchMove", (x - 40, x + 40)), ("touchMove", (x - 60, x + 60)), ("touchEnd", ())):
        touch(kind, *at)
    widths("two fingers zoom", lambda low, high: high - low < 0.6 * whole[1])
    b.tell("Emulation.setTouchEmulationEnabled", enabled=False)
    b.run("document.querySelector('.back').click()")


def check_jet(b):
    """Where "Follow the jet" leads: past a short fold at 4.25, and not to what overhangs after touchdown."""
    stage = pathlib.Path(__file__).resolve().parents[2] / "compare/page/stage.js"
    led = b.run("""const s = (t, overhang) => ({t, overhang, tip: overhang ? [5, 1] : null}), none = [s(0, null), s(9, null)];
      const pack = {runs: [{surfaces: none}, {surfaces: [s(4, null), s(4.25, 0.02), s(5, 0.3), s(5.5, 0.45), s(6, 0.5), s(6.4, 1.2)]}, {surfaces: none}]};
      const runs = [{touchdown: {t_star: null}}, {touchdown: {t_star: 6.05}}, {touchdown: {t_star: null}}], named = [0, 1, 2], byId = () => ({});
      """ + stage.read_text() + "return [1, 2].flatMap(of => { shown.of = of; return [3.5, 5.6, 9].map(jetTime); })")
    claim(led == [5, 5.5, 6] * 2, f"the jet is found at {led}")


def check_distances(b):
    """Of surfaces with few nodes: a zigzag whose segments are long, and places near their middles and far away."""
    water = pathlib.Path(__file__).resolve().parents[2] / "compare/page/water.js"
    off = b.run(water.read_text() + """const x = [0, 3, 0, 3, 3.5], y = [0, 0.3, 0.6, 0.9, 5];
      const surface = {x, y, pieces: [2, 3], closed: [0, 1]}, places = {x: [], y: []};
      for (let i = 0; i < 4000; i++) { places.x.push(-1 + 7 * (i * 0.618034 % 1)); places.y.push(-1 + 8 * (i * 0.414214 % 1)); }
      const to = (a, b, px, py) => {
        const l = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2, w = ((px - a[0]) * (b[0] - a[0]) + (py - a[1]) * (b[1] - a[1])) / l;
        const v = Math.max(0, Math.min(1, w));
        return Math.hypot(a[0] + v * (b[0] - a[0]) - px, a[1] + v * (b[1] - a[1]) - py);
      };
      const p = k => [x[k], y[k]], sides = [[0, 1], [2, 3], [3, 4], [4, 2]], found = distancesFrom(surface, places);
      return places.x.reduce((most, px, i) => Math.max(most, Math.abs(found[i] - Math.min(...sides.map(([m, n]) => to(p(m), p(n), px, places.y[i]))))), 0);""")
    claim(off < 1e-12, f"distances from a surface of long segments are off by {off}")


def check_tables(b):
    rows = b.run("""const t = document.getElementById('summary-table'), sort = t.tHead.querySelectorAll('.sort')[3];
      sort.click(); sort.click(); return [...t.tBodies[0].rows].map(r => parseFloat(r.cells[3].textContent))""")
    claim(rows == sorted(rows, reverse=True) and len(rows) == len(report["runs"]), f"the summary sorts: {rows}")
    places = b.run("""const t = document.getElementById('summary-table'), heads = [...t.tHead.querySelectorAll('th')].map(h => h.textContent);
      const column = heads.findIndex(h => h.startsWith('front'));
      return [...t.tBodies[0].rows].map(r => [r.cells[0].textContent, r.cells[column].className])""")
    for row in report["measures"]:
        if row["measure"] == "front" and row["t_star"] is None and row["value"] is not None:
            grey = next(look for name, look in places if row["run"] in name) == "below"
            claim(grey == (row["value"] < (row["noise_floor"] or 0)), f"front of {row['run']} in the summary: grey is {grey}")
    shown = b.run("return document.querySelector('main').textContent")
    for row in report["measures"]:
        if row["value"] is not None:
            number = f"{row['value']:.4g}"
            claim(number in shown, f"{row['measure']} of {row['run']}, {number}, is shown")
    for words in ("How it is measured", "Scales: lengths in H", "Where the energy went", "Main surface: pieces", report["runs"][0]["file"]):
        claim(words in shown, f"the page says: {words}")
    b.run("document.querySelector('.chip').click()")
    b.wait("document.getElementById('said').textContent.includes('limit')", "a chip's place")


def check_text(b):
    claim(b.run("return document.querySelector('h1').textContent") == report["title"], "the title is text")
    claim(not b.run("return window.hacked || document.querySelector('main [onerror], main script')"), "no name is a script")
    claim(b.run("return [...document.images].every(i => i.src.startsWith('data:'))"), "pictures are in the page")


def check_looks(b):
    ground = "return getComputedStyle(document.body).backgroundColor"
    light = b.run(ground)
    b.tell("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark"}])
    dark = b.run(ground)
    claim(dark != light, "dark follows the system")
    check_access(b, "dark", rules)
    b.run("document.getElementById('theme').click()")
    claim(b.run(ground) == light, "the switch makes it light")
    b.tell("Emulation.setEmulatedMedia", features=[])
    for width in (400, 1400, 3840):
        b.tell("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=False)
        settled(b)
        wide = b.run("return document.documentElement.scrollWidth")
        claim(wide <= width, f"at {width} px nothing sticks out: {wide}")
    b.tell("Emulation.clearDeviceMetricsOverride")
    b.tell("Emulation.setEmulatedMedia", media="print")
    hidden = b.run("""const rows = '<tr><td>1</td></tr>'.repeat(60), box = document.createElement('div');
      box.className = 'scroll';
      box.innerHTML = `<table><tbody>${rows}</tbody></table>`;
      document.querySelector('main').append(box);
      const off = box.scrollHeight - box.clientHeight;
      box.remove();
      return off""")
    claim(hidden <= 1, f"a long table is printed whole: {hidden} px are hidden")
    b.run("""const tall = document.createElement('img');
      tall.id = 'tall';
      tall.src = 'data:image/svg+xml,' + encodeURIComponent('<svg xmlns="http://www.w3.org/2000/svg" width="500" height="5000"/>');
      document.querySelector('.paper').append(tall)""")
    b.wait("document.getElementById('tall').naturalHeight === 5000", "a tall figure")
    height = b.run("const tall = document.getElementById('tall'), h = tall.getBoundingClientRect().height; tall.remove(); return h")
    claim(0 < height <= 1027, f"a tall figure stays on one sheet: {height} px")  # of A4 without its margins, at 96 px an inch
    b.tell("Emulation.setEmulatedMedia", media="")
    pages = b.pages()
    claim(pages >= 3, f"it prints: {pages} pages")


def check_without_scripts(b):
    b.tell("Emulation.setScriptExecutionDisabled", value=True)
    b.open(sys.argv[1])
    visible = "return document.querySelector(arguments[0]).getBoundingClientRect().height > 0"
    claim(b.run(visible, "#summary-table") and b.run(visible, "#health-table") and b.run(visible, "noscript p"), "tables without scripts")
    claim(b.run(visible, ".fixed img") and not b.run(visible, "#explore"), "fixed figures without scripts")


browser = Browser()
try:
    browser.open(sys.argv[1])
    browser.wait("document.documentElement.dataset.ready === 'yes'", "the page")
    for check in (check_text, check_time, check_controls, check_zoom, check_jet, check_distances, check_tables, lambda b: check_access(b, "light", rules), check_looks):
        check(browser)
    for line in browser.ask("POST", "/se/log", {"type": "browser"}):
        claim(False, f"console: {line['level']} {line['message']}")
    check_without_scripts(browser)
finally:
    browser.close()
sys.exit(bool(failed))
