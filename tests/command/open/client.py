"""A client of `objdict open` that is not ours: reads the list and a file, and replaces it once. Its argument is the address."""

import http.client
import json
import sys
from urllib.parse import urlsplit

address = urlsplit(sys.argv[1])


def ask(method, path, **arguments):
    connection = http.client.HTTPConnection(address.hostname, address.port, timeout=30)
    connection.request(method, path, **arguments)
    answer = connection.getresponse()
    return answer, answer.read()


page, text = ask("GET", address.path)
assert page.status == 200 and page.headers.get_content_type() == "text/html", page.status
assert b"<title>" in text and page.headers["X-Frame-Options"] == "DENY"

listed, text = ask("GET", address.path + "files")
names = [file["name"] for file in json.loads(text)["files"]]
assert names == ["drive.eds"], names

file, old = ask("GET", address.path + "files/0")
assert len(old) == int(file.headers["Content-Length"])
head, nothing = ask("HEAD", address.path + "files/0")
same = ["Content-Length", "ETag", "Content-Type", "Cache-Control"]
assert head.status == 200 and nothing == b"" and all(head.headers[name] == file.headers[name] for name in same), head.headers
new = old.replace(b"DefaultValue", b"defaultvalue", 1)
origin = f"http://{address.netloc}"
headers = {"Origin": origin, "If-Match": file.headers["ETag"]}

refused, text = ask("PUT", address.path + "files/0", body=new, headers=headers | {"Origin": "http://example.com"})
assert refused.status == 403 and "a different site" in json.loads(text)["error"]["message"], text
refused, _ = ask("PUT", address.path + "files/0", body=bytes(1 << 20), headers=headers)
assert refused.status == 413, refused.status
saved, _ = ask("PUT", address.path + "files/0", body=new, headers=headers)
assert saved.status == 200, saved.status
again, text = ask("GET", address.path + "files/0")
assert text == new and again.headers["ETag"] == saved.headers["ETag"] != file.headers["ETag"]
stale, text = ask("PUT", address.path + "files/0", body=old, headers=headers)
assert stale.status == 412 and "was changed" in json.loads(text)["error"]["message"], text
