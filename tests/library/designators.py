"""Prints a C++ program that initialises one member of each public struct by name. Compilers then
warn about members without a default value.

  designators.py INCLUDE_FOLDER
"""

import pathlib
import re
import sys


# Inner loops fill these large arrays completely, so default values would cost time.
LEFT_OUT = {"Tap", "Taps"}


def without_braces(text):
    """Returns the text outside of all braces. Each outermost pair of braces becomes "{}"."""
    depth = 0
    kept = []
    for character in text:
        depth -= character == "}"
        if depth == 0:
            kept.append(character)
        depth += character == "{"
    return "".join(kept)


def members(body):
    body = without_braces(re.sub(r"//[^\n]*", "", body))
    # The body of a function ends a statement, as a semicolon does.
    for statement in re.split(r";|\)[^;{}=]*\{\}", body):
        head = re.sub(r"<[^;]*>", "", statement.split("=")[0].replace("{}", ""))
        words = re.findall(r"\w+", statement)
        if not words or "(" in statement or words[0] in ("static", "friend", "enum", "struct", "using", "bool operator"):
            continue
        name = re.search(r"^[^,]*?(\w+)\s*(?:,|$)", head.strip())
        yield name.group(1)


def main(folder):
    print("#include <lippmann/lippmann.hpp>\nusing namespace lippmann;\nint main() {")
    structs = 0
    for header in sorted(pathlib.Path(folder).rglob("*.hpp")):
        for template, name, body in re.findall(r"^(template <class T>\n)?struct (\w+) \{\n(.*?)^\};", header.read_text(), re.MULTILINE | re.DOTALL):
            if name in LEFT_OUT or f"  {name}(" in body:
                continue
            name += "<float>" if template else ""
            names = list(members(body))
            for member in dict.fromkeys((names[:1] + names[-1:])):
                print(f"  static_cast<void>({name}{{.{member} = {{}}}});")
            structs += 1
    print("}")
    if structs < 50:
        sys.exit(f"{folder}: only {structs} structs found")


main(*sys.argv[1:])
