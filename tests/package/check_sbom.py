#!/usr/bin/env python3
"""Checks a bill of materials: what SPDX 2.3 asks of every element is there, relations lead to elements, and what dpkg-shlibdeps
found the program to depend on is listed as linked.
usage: check_sbom.py FILE DEPENDS     DEPENDS: that field of the Debian package
"""
import json
import re
import sys

PACKAGE_KEYS = {"SPDXID", "name", "versionInfo", "downloadLocation", "licenseConcluded", "licenseDeclared", "copyrightText"}
RELATIONS = {"DESCRIBES", "DYNAMIC_LINK", "STATIC_LINK", "RUNTIME_DEPENDENCY_OF", "BUILD_DEPENDENCY_OF", "CONTAINS"}


def problems_of(bill, depends):
    if (bill["spdxVersion"], bill["dataLicense"], bill["SPDXID"]) != ("SPDX-2.3", "CC0-1.0", "SPDXRef-DOCUMENT"):
        yield "is no SPDX 2.3 document"
    if not re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", bill["creationInfo"]["created"]):
        yield "has no moment of creation"
    identifiers = [package["SPDXID"] for package in bill["packages"]]
    if len(set(identifiers)) != len(identifiers):
        yield "gives two packages one identifier"
    for package in bill["packages"]:
        if not PACKAGE_KEYS <= package.keys() or not all(package[key] for key in PACKAGE_KEYS):
            yield f"{package.get('name')} lacks {PACKAGE_KEYS - package.keys()}"
        if not re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", package["SPDXID"]):
            yield f"{package['SPDXID']} is no identifier"
        if any(not re.fullmatch(r"[0-9a-f]{64,128}", sum["checksumValue"]) for sum in package.get("checksums", [])):
            yield f"{package['name']} has a checksum that is none"
    known = {*identifiers, "SPDXRef-DOCUMENT"}
    for relation in bill["relationships"]:
        if not {relation["spdxElementId"], relation["relatedSpdxElement"]} <= known:
            yield f"{relation} leads nowhere"
        if relation["relationshipType"] not in RELATIONS:
            yield f"{relation} is of no kind that is made"
    linked = {r["relatedSpdxElement"] for r in bill["relationships"] if r["relationshipType"] == "DYNAMIC_LINK"}
    for dependency in depends.split(","):
        name = re.match(r"\s*([a-z0-9.+-]+)", dependency)[1]
        # Where there is a choice (LAPACK), what is linked here may come from yet another that provides it.
        if "|" not in dependency and "SPDXRef-deb-" + re.sub("[+]+", "-", name).strip("-") not in linked:
            yield f"{name} is not listed as linked"
    if not any(package["SPDXID"].startswith("SPDXRef-npm-") for package in bill["packages"]):
        yield "lists nothing of the page"


def main():
    file, depends = sys.argv[1:]
    with open(file, encoding="utf-8") as opened:
        problems = list(problems_of(json.load(opened), depends))
    for problem in problems:
        print(f"{file}: {problem}")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
