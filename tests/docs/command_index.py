#!/usr/bin/env python3
"""Writes the command index of docs/gl_coverage.md anew, from the definitions in driver/api/ and the list of
entry points:

    tests/docs/command_index.py
"""
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PAGE = ROOT / "docs/gl_coverage.md"
BEGIN, END = "<!-- command index: written by tests/docs/command_index.py -->\n", "<!-- end of the command index -->\n"


def definitions():
    """(pattern of a command's name, file) for each definition; a macro's parameter stands for letters."""
    for path in sorted((ROOT / "driver/api").glob("*.cpp")):
        for name in re.findall(r"\b([A-Z][\w#]*)\(\s*Context& context", path.read_text()):
            pattern = "".join("[a-z]+" if part in ("suffix", "name") else part for part in re.split("##", name))
            yield re.compile(pattern + "$"), path.name


def main():
    text = (ROOT / "driver/commands/commands.inc").read_text()
    commands = re.findall(r"^GL_COMMAND\(.*?, (\w+), \(", text, re.M)
    aliases = {}
    for alias, target in re.findall(r"^GL_ALIAS\(.*?, (\w+), \(.*, (\w+)\)$", text, re.M):
        aliases.setdefault(target, []).append(alias)
    known = list(definitions())
    by_file = {}
    for command in commands:
        files = {file for pattern, file in known if pattern.match(command)}
        if len(files) != 1:
            raise SystemExit(f"gl{command}: defined in {sorted(files) or 'no file'}")
        by_file.setdefault(files.pop(), []).append(command)
    lines = [f"{len(commands)} commands and {sum(map(len, aliases.values()))} other names of them, the latter in parentheses.\n\n",
             "| file of driver/api | commands |\n|---|---|\n"]
    for file in sorted(by_file):
        names = [" ".join([c] + [f"({a})" for a in aliases.get(c, [])]) for c in by_file[file]]
        lines.append(f"| [{file}](../driver/api/{file}) | {', '.join(names)} |\n")
    page = PAGE.read_text()
    head, rest = page.split(BEGIN)
    PAGE.write_text(head + BEGIN + "".join(lines) + END + rest.split(END)[1])


main()
