"""Checks a built site: python3 .ci/links.py target/site

Each link and picture of a page must lead to a file of the site, each anchor to an id in it, and the site must stay small enough to publish.
The tests of the pages check Markdown; this checks what mdBook made of it.
"""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

MAX_BYTES = 8_000_000
# the sidebar without scripts, whose links start at the folder of the page that shows it
FRAMES = {"toc.html"}


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.ids = [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.ids.add(attrs.get("id") or attrs.get("name"))
        link = attrs.get({"a": "href", "link": "href", "img": "src", "script": "src"}.get(tag))
        if link is not None:
            self.links.append(link)


def is_dead(page, link, pages):
    """Whether a link on the page leads nowhere in the site."""
    parts = urlsplit(link)
    if parts.scheme or parts.netloc:
        return False
    target = (page.parent / unquote(parts.path)).resolve() if parts.path else page
    if target.is_dir():
        target /= "index.html"
    anchor = unquote(parts.fragment)
    return not target.is_file() or bool(anchor) and target in pages and anchor not in pages[target].ids


def main(site):
    root = Path(site).resolve()
    # `web/site.mjs` adds the workbench, which has tests of its own
    files = [path for path in sorted(root.rglob("*")) if path.is_file() and root / "workbench" not in path.parents]
    pages = {path: Page(path) for path in files if path.suffix == ".html" and path.name not in FRAMES}
    dead = [
        f"{path.relative_to(root)}: {link}"
        for path, page in pages.items()
        for link in page.links
        if path.name != "404.html" and is_dead(path, link, pages)
    ]
    size = sum(path.stat().st_size for path in files)
    links = sum(len(page.links) for page in pages.values())
    print(*dead, f"{len(pages)} pages, {links} links, {len(dead)} dead, {size / 1e6:.1f} MB", sep="\n")
    if dead or not links:
        sys.exit("dead links, or a site without links")
    if size > MAX_BYTES:
        sys.exit(f"the site exceeds {MAX_BYTES / 1e6:.0f} MB")


main(*sys.argv[1:])
