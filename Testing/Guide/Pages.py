# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Links between pages lead somewhere, and the guide's troubleshooting page has each error message.

usage: python3 Pages.py PROJECT
"""

import pathlib
import re
import sys

project = pathlib.Path(sys.argv[1])
documentation = project / "Plugin" / "Documentation"
pages = [project / "README.md", project / ".github" / "CONTRIBUTING.md", *documentation.rglob("*.md")]


def anchor_of(heading):
    """As GitHub makes it."""
    words = re.sub(r"[*`]|\[([^]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", words).replace(" ", "-")


def anchors_of(page):
    return {anchor_of(heading) for heading in re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)}


def broken_links(page):
    for link in re.findall(r"\]\(([^)\s]+)\)", page.read_text(encoding="utf-8")):
        if link.startswith(("http:", "https:")):
            continue
        path, _, anchor = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        if not target.exists() or (anchor and anchor not in anchors_of(target)):
            yield f"{page.relative_to(project)}: {link}"


def joined_literals(code):
    """Without comments; literals that follow each other, also in a stream, are one."""
    code = re.sub(r"//[^\n]*|/\*.*?\*/", "", code, flags=re.DOTALL)
    return re.sub(r'"\s*\n\s*(<<\s*)?"', "", code)


def literals(code):
    return [part.strip(' .;:,\\"') for part in re.findall(r'"((?:[^"\\\n]|\\.)*)"', code)]


# What no user meets: errors that our own code catches.
INTERNAL = ("InjectedFault.h", "Interruption.h", "SolvedField.h", "SolveOptions.h")


def messages():
    """Of each error that a user can meet, its literals but for short ones; and all others that read like a sentence, as
    they are parts of errors and warnings that are put together from variables."""
    for layer in ("Core", "Bridge", "Distributed", "Surface", "Geodesics"):
        for source in sorted((project / "Filters" / layer).rglob("*.*")):
            if source.suffix not in (".cxx", ".h") or source.name in INTERNAL:
                continue
            code = joined_literals(source.read_text(encoding="utf-8"))
            code = re.sub(r"throw std::logic_error\(.*?\);", "", code, flags=re.DOTALL)
            for error in re.findall(r"throw [\w:]+\((.*?)\);", code, re.DOTALL):
                yield from ((source.name, part) for part in literals(error) if len(part) > 12)
            yield from ((source.name, part) for part in literals(code) if len(part.split()) > 3)
    for source in sorted((project / "Widgets" / "Seeds").glob("*.cxx")):
        code = joined_literals(source.read_text(encoding="utf-8"))
        for refusal in re.findall(r"(?:refused\(|return \{ \{\}, )(.*?);", code, re.DOTALL):
            for text in re.findall(r'tr\("((?:[^"\\]|\\.)*)"', refusal):
                yield from ((source.name, part.strip(' .;:,\\"')) for part in re.split(r"%\d", text) if len(part) > 12)


def plain(text):
    return re.sub(r"[\s*`\\]+", " ", text)


broken = [link for page in pages for link in broken_links(page)]
assert not broken, "\n".join(["These links lead nowhere:", *broken])

guide = plain("".join(page.read_text(encoding="utf-8") for page in (documentation / "guide").glob("*.md")))
found = list(messages())
assert len(found) > 300 and any(name == "SurfaceProbe.cxx" for name, _ in found), found
missing = [f"{name}: {message}" for name, message in found if plain(message) not in guide]
assert not missing, "\n".join(["No page of the guide has these messages; add them to troubleshooting.md:", *missing])

lost = [page.name for page in (documentation / "guide").glob("*.md")
        if f"(guide/{page.name})" not in (documentation / "guide.md").read_text(encoding="utf-8")]
assert not lost, f"guide.md does not lead to {lost}"
