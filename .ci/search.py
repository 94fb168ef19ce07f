"""Searches a built site in Chromium: python3 .ci/search.py target/site

A rule must be found by its id, its name and its title, an option and a key by their names, and each must be the first result or nearly so.
"""

import functools
import json
import os
import queue
import signal
import subprocess
import sys
import tempfile
import threading
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer

# what is searched for, the page, and its latest place among the results
SEARCHES = [
    ("cia306/access-without-mapping", "rules/cia306/access-without-mapping.html", 1),
    ("access-without-mapping", "rules/cia306/access-without-mapping.html", 1),
    ("the access type specifies a PDO direction", "rules/cia306/access-without-mapping.html", 2),
    ("octal", "rules/cia306/octal-number.html", 5),
    ("--unsafe-fixes", "reference/commands/check.html", 5),
    ("--loss-report", "reference/commands/convert.html", 5),
    ("network boot", "guides/network-boot.html", 10),
    ("product-number", "reference/device.html", 10),
]


# loads a page of a folder, whose links to the index begin with `../`, and sends the addresses of the results to this program
TESTER = """<!DOCTYPE html><script type="module">
const found = [];
for (const text of %s) {
  const frame = document.createElement("iframe");
  frame.src = `guides/check.html?search=${encodeURIComponent(text)}`;
  document.body.append(frame);
  let results;
  for (let tries = 0; !(results?.childNodes.length) && tries < 600; tries += 1) {
    await new Promise((done) => setTimeout(done, 50));
    results = frame.contentDocument.getElementById("results");
  }
  found.push([...results.querySelectorAll("a")].map((link) => new URL(link.href).pathname.slice(1)));
  frame.remove();
}
fetch("found", { method: "POST", body: JSON.stringify(found) });
</script><body></body>"""


class Handler(SimpleHTTPRequestHandler):
    def __init__(self, *arguments, found, **named):
        self.found = found
        super().__init__(*arguments, **named)

    def log_message(self, *_):
        pass

    def do_GET(self):
        if self.path != "/tester":
            return super().do_GET()
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.end_headers()
        self.wfile.write((TESTER % json.dumps([text for text, *_ in SEARCHES])).encode())

    def do_POST(self):
        self.found.put(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.send_response(204)
        self.end_headers()


def main(site):
    found = queue.Queue()
    server = ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Handler, directory=site, found=found))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        chromium = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}"]
        browser = subprocess.Popen([*chromium, f"http://127.0.0.1:{server.server_port}/tester"], stderr=subprocess.DEVNULL, start_new_session=True)
        try:
            answers = found.get(timeout=180)
        finally:
            # its processes write to the profile until they end
            os.killpg(browser.pid, signal.SIGKILL)
            browser.wait()
    wrong = [
        f"`{text}` does not find {page} among its first {place}: {pages}"
        for (text, page, place), pages in zip(SEARCHES, answers)
        if page not in pages[:place]
    ]
    print(*wrong, f"{len(SEARCHES)} searches, {len(wrong)} wrong", sep="\n")
    sys.exit(bool(wrong))


main(*sys.argv[1:])
