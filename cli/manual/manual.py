#!/usr/bin/env python3
"""Writes the man pages of the command and of each verb, from what `orbicube --describe` prints.

    manual.py DESCRIPTION.json FOLDER
"""
import json
import os
import sys


def escaped(text):
    """As groff reads it: no character has a meaning, hyphens are those of the keyboard."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq").replace("`", "\\(ga").replace("^", "\\(ha").replace("~", "\\(ti")
    text = "".join(c if ord(c) < 128 else f"\\[u{ord(c):04X}]" for c in text)
    return "\\&" + text if text.startswith(".") else text


def bold(text):
    return "\\fB" + escaped(text) + "\\fR"


def italic(text):
    return "\\fI" + escaped(text) + "\\fR"


def paragraphs(text):
    """Lines of a help text; indented ones stay as they are."""
    lines, literal = [], False
    for line in text.split("\n"):
        if line.startswith("  ") != literal:
            literal = not literal
            lines += [".PP", ".nf", ".RS"] if literal else [".RE", ".fi", ".PP"]
        if line.strip():
            lines.append(escaped(line[2:] if literal else line))
        elif not literal:
            lines.append(".PP")
    return lines + ([".RE", ".fi"] if literal else [])


def signature(option):
    """Of an option: its names and what they take."""
    text = ", ".join(map(bold, option["names"]))
    value = option["value"]
    if not option["positional"] and option["max_values"] > 0 and value:
        text += f" [{italic(value)}]" if option["min_values"] == 0 else " " + italic(value)
    return text


def positional(option):
    text = italic(option["value"] or option["names"][0])
    text += "" if option["value"].endswith("...") or option["max_values"] == 1 else "..."
    return text if option["required"] else f"[{text}]"


def described_options(options):
    lines, groups = [], []
    for option in options:
        if option["group"] and option["group"] not in groups:
            groups.append(option["group"])
    for group in groups:
        lines.append(".SH " + escaped(group.upper()))
        for option in options:
            if option["group"] == group and not option["positional"]:
                text = option["text"] + ("; required" if option["required"] else "")
                lines += [".TP", signature(option), escaped(text)]
    return lines


def synopsis(name, options):
    words = [bold(name)]
    words += [positional(option) for option in options if option["positional"]]
    words += [signature(option).rpartition(", ")[2] if len(option["names"]) > 1 else signature(option)
              for option in options if option["required"] and not option["positional"]]
    return " ".join(words) + " [" + italic("options") + "]"


def page(name, title, version, text, body, see):
    """One page, without a date, so that every build writes the same bytes."""
    lines = [f'.TH {escaped(name.upper())} 1 "" "Orbicube {version}" "Orbicube"',
             ".nh", ".ad l", ".SH NAME", f"{escaped(name)} \\- {escaped(text)}", ".SH SYNOPSIS", title, *body,
             ".SH EXIT STATUS", "0: success with a valid result; 1: no valid result; 2: a wrong input or command line.",
             ".SH SEE ALSO", ",\n".join(bold(other) + "(1)" for other in see)]
    return "\n".join(line for line in lines if line) + "\n"


def notes_and_examples(notes):
    text, _, examples = notes.partition("For example:\n")
    lines = []
    if text.strip():
        lines += [".SH NOTES", *paragraphs(text.strip("\n"))]
    if examples:
        lines += [".SH EXAMPLES", *paragraphs(examples)[1:]]
    return lines


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        command = json.load(file)
    name, version = command["name"], command["version"]
    pages = [f"{name}-{verb['name']}" for verb in command["verbs"]]
    verbs = [".SH VERBS"]
    for verb in command["verbs"]:
        verbs += [".TP", bold(verb["name"]), escaped(verb["text"])]
    text = command["text"].rstrip(".")
    written = {name: page(name, f"{bold(name)} {italic('verb')} [{italic('options')}]", version, text[0].lower() + text[1:],
                          verbs + described_options(command["options"]) + notes_and_examples(command["notes"]), pages)}
    for verb in command["verbs"]:
        options = verb["options"]
        arguments = [".SH ARGUMENTS"] if any(option["positional"] for option in options) else []
        for option in options:
            if option["positional"]:
                arguments += [".TP", positional(option), escaped(option["text"])]
        body = arguments + described_options(options) + notes_and_examples(verb["notes"])
        own = f"{name}-{verb['name']}"
        written[own] = page(own, synopsis(f"{name} {verb['name']}", options), version, verb["text"], body, [name])
    for own, content in written.items():
        with open(os.path.join(sys.argv[2], own + ".1"), "w", encoding="ascii") as file:
            file.write(content)


if __name__ == "__main__":
    main()
