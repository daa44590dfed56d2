#!/usr/bin/env python3
"""Checks that every link within a built site leads to a file of it, and its #anchor to an element; nothing is fetched. Of the C++
interface, whose links Doxygen makes, only what leads there is checked.
usage: check_site.py SITE
"""
import functools
import html
import pathlib
import re
import sys
import urllib.parse

LINK = re.compile(r'<(?:a|img|link|script)\b[^>]*?\s(?:href|src)="([^"]*)"')
ANCHOR = re.compile(r'\s(?:id|name)="([^"]*)"')


@functools.cache
def text_of(page):
    return page.read_text(encoding="utf-8")


@functools.cache
def anchors_of(page):
    return {html.unescape(anchor) for anchor in ANCHOR.findall(text_of(page))}


def leads_somewhere(page, link):
    """Links to other sites are theirs to keep."""
    parts = urllib.parse.urlsplit(html.unescape(link))
    if parts.scheme or parts.netloc:
        return True
    target = (page.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else page
    if target.is_dir():
        target = target / "index.html"
    if not target.is_file():
        return False
    return not parts.fragment or target.suffix != ".html" or urllib.parse.unquote(parts.fragment) in anchors_of(target)


def main():
    site = pathlib.Path(sys.argv[1]).resolve()
    pages = [page for page in sorted(site.rglob("*.html")) if "cpp" not in page.parts and page.name != "404.html"]
    links = [(page, link) for page in pages for link in LINK.findall(text_of(page))]
    broken = [(page, link) for page, link in links if not leads_somewhere(page, link)]
    for page, link in broken:
        print(f"{page.relative_to(site)}: {link} leads nowhere")
    print(f"{len(broken)} of {len(links)} links on {len(pages)} pages lead nowhere")
    sys.exit(1 if broken or not links else 0)


if __name__ == "__main__":
    main()
