"""How long the language server takes from an edit to its findings, beside a server that sends each message back unread.

    python benches/python/edits.py PROGRAM 28k.eds 498k.eds

`benches/instructions` makes such files; any other EDS does too. Each file is edited in turn by both, and the median of the edits
counts. Exits with 1 when the server takes more than the echo and 5 ms for a file up to 50 KB, or 30 ms for a larger one.
"""

import json
import statistics
import subprocess
import sys
import time

EDITS = 101

ECHO = """
import sys
read, write = sys.stdin.buffer, sys.stdout.buffer
while length := read.readline():
    read.readline()
    body = read.read(int(length.split()[1]))
    write.write(length + b'\\r\\n' + body)
    write.flush()
"""


class Server:
    """A server, and the messages to it and from it."""

    def __init__(self, *command):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def send(self, method, params, **more):
        body = json.dumps({"jsonrpc": "2.0", "method": method, "params": params, **more}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        self.process.stdin.flush()

    def receive(self):
        length = int(self.process.stdout.readline().split()[1])
        self.process.stdout.readline()
        return self.process.stdout.read(length)

    def open(self, uri, text):
        self.send("initialize", {"capabilities": {}}, id=1)
        self.receive()
        self.send("initialized", {})
        document = {"uri": uri, "languageId": "eds", "version": 0, "text": text}
        self.send("textDocument/didOpen", {"textDocument": document})

    def edit(self, uri, number, line):
        """The seconds until what follows a key at the start of a line is here."""
        place = {"line": line, "character": 0}
        change = {"range": {"start": place, "end": place}, "text": ";"}
        changed = {"textDocument": {"uri": uri, "version": number}, "contentChanges": [change]}
        start = time.perf_counter()
        self.send("textDocument/didChange", changed)
        self.receive()
        return time.perf_counter() - start


def medians(program, path):
    """The median of the server and that of the echo, in milliseconds."""
    with open(path, encoding="utf-8", newline="") as file:
        text = file.read()
    uri = "file:///nowhere/edited.eds"
    server, echo = Server(program, "lsp"), Server(sys.executable, "-c", ECHO)
    server.open(uri, text)
    server.receive()
    echo.open(uri, text)
    # the echo sends the two messages back that no server answers
    echo.receive(), echo.receive()
    times = {server: [], echo: []}
    for number in range(1, EDITS + 1):
        for one in (server, echo):
            times[one].append(one.edit(uri, number, text.count("\n")))
    for one in (server, echo):
        one.process.kill()
        one.process.wait()
    return [1000 * statistics.median(times[one]) for one in (server, echo)]


def main():
    program, *paths = sys.argv[1:]
    is_late = False
    for path in paths:
        with open(path, "rb") as file:
            size = len(file.read())
        ours, echo = medians(program, path)
        limit = 5 if size <= 50_000 else 30
        is_late |= ours - echo > limit
        print(f"{path}: {ours:.2f} ms, echo {echo:.2f} ms, {ours / echo:.1f} times as long; goal: {limit} ms more")
    sys.exit(is_late)


if __name__ == "__main__":
    main()
