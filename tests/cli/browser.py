"""A headless Chromium that is driven through chromedriver (WebDriver, and the DevTools protocol through it), and claims
about what it shows: each that does not hold is printed, and kept in `failed`."""
import base64, json, pathlib, re, subprocess, time, urllib.request

failed = []


def claim(holds, what):
    if not holds:
        failed.append(what)
        print("FAIL", what)


class Browser:
    def __init__(self):
        self.driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE, text=True)
        for line in self.driver.stdout:
            found = re.search(r"started successfully on port (\d+)", line)
            if found:
                break
        self.at = f"http://127.0.0.1:{found[1]}"
        flags = ["--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1400,1000", "--hide-scrollbars"]
        made = self.ask("POST", "/session", {"capabilities": {"alwaysMatch": {
            "browserName": "chrome", "timeouts": {"script": 300000}, "goog:chromeOptions": {"args": flags}, "goog:loggingPrefs": {"browser": "ALL"}}}})
        self.at += f"/session/{made['sessionId']}"

    def ask(self, how, path, body=None):
        request = urllib.request.Request(self.at + path, method=how, headers={"Content-Type": "application/json"},
                                         data=None if body is None else json.dumps(body).encode())
        with urllib.request.urlopen(request, timeout=300) as answer:
            return json.load(answer)["value"]

    def run(self, script, *arguments):
        return self.ask("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def wait(self, script, what):
        for _ in range(600):
            if self.run(f"return {script}"):
                return
            time.sleep(0.05)
        claim(False, f"waited for {what}")

    def tell(self, command, **params):
        return self.ask("POST", "/goog/cdp/execute", {"cmd": command, "params": params})

    def key(self, *keys):
        actions = [{"type": t, "value": k} for k in keys for t in ("keyDown", "keyUp")]
        self.ask("POST", "/actions", {"actions": [{"type": "key", "id": "keys", "actions": actions}]})

    def open(self, path):
        self.ask("POST", "/url", {"url": pathlib.Path(path).resolve().as_uri()})

    def pages(self):
        """How many sheets of paper it takes; 0 when it does not print."""
        pdf = base64.b64decode(self.tell("Page.printToPDF", printBackground=False)["data"])
        return len(re.findall(rb"/Type\s*/Page\b", pdf)) if pdf.startswith(b"%PDF") and pdf.rstrip().endswith(b"%%EOF") else 0

    def close(self):
        try:
            self.ask("DELETE", "")
        finally:
            self.driver.terminate()


def check_access(b, look, rules):
    """By axe-core, the script at the path `rules`; None: nothing is checked."""
    if not rules:
        return
    b.run(pathlib.Path(rules).read_text())
    found = b.ask("POST", "/execute/async", {"args": [], "script": "const done = arguments[0]; axe.run().then(r => done(r.violations.map(v => "
        "`${v.id}: ${v.help}: ${v.nodes.slice(0, 3).map(n => n.target.join(' ')).join('; ')}`)))"})
    for line in found:
        claim(False, f"accessibility, {look}: {line}")
