#!/usr/bin/env python3
"""Man pages and shell completions hold the verbs and options that --help prints, no more and no less.

    manual_test.py COMMAND FOLDER     FOLDER: where the build puts both
"""
import glob
import json
import os
import re
import shutil
import subprocess
import sys
import unittest

FOLDER = os.path.abspath(sys.argv.pop(2))

from command import InFolder, main, run

DESCRIPTION = json.loads(run("--describe").stdout)
VERBS = [verb["name"] for verb in DESCRIPTION["verbs"]]
OPTION = re.compile(r"^  ((?:-\w,)?--[\w-]+(?:,--[\w-]+)*)", re.M)


def options_of_help(*verb):
    return {name for names in OPTION.findall(run(*verb, "--help").stdout) for name in names.split(",")}


def page(name):
    with open(os.path.join(FOLDER, name + ".1"), encoding="ascii") as file:
        return file.read()


def plain(text):
    """Of groff's text, without fonts and escapes of single characters."""
    for escape, character in (("\\fB", ""), ("\\fI", ""), ("\\fR", ""), ("\\-", "-"), ("\\(aq", "'"), ("\\(ga", "`"), ("\\(ha", "^"),
                              ("\\(ti", "~"), ("\\&", ""), ("\\e", "\\")):
        text = text.replace(escape, character)
    return re.sub(r"\\\[u([0-9A-F]{4})\]", lambda found: chr(int(found.group(1), 16)), text)


def options_of_page(name):
    signatures = re.findall(r"^\.TP\n(\\fB\\-.*)$", page(name), re.M)
    return {option for line in signatures for option in re.findall(r"\\fB(.*?)\\fR", line) for option in [plain(option)]}


class ManPages(InFolder):
    def test_there_is_a_page_for_the_command_and_for_each_verb(self):
        pages = {os.path.basename(path) for path in glob.glob(os.path.join(FOLDER, "*.1"))}
        self.assertEqual(pages, {"orbicube.1", *(f"orbicube-{verb}.1" for verb in VERBS)})

    def test_each_page_has_the_options_of_help(self):
        self.assertEqual(options_of_page("orbicube"), options_of_help())
        for verb in VERBS:
            own = options_of_help(verb)
            self.assertGreaterEqual(own, {"--help", "--quiet", "--report"}, verb)
            self.assertEqual(options_of_page("orbicube-" + verb), own, verb)

    def test_each_page_has_the_texts_and_examples_of_help(self):
        for verb in DESCRIPTION["verbs"]:
            text = plain(page("orbicube-" + verb["name"]))
            self.assertIn(f"orbicube-{verb['name']} - {verb['text']}\n", text)
            for option in verb["options"]:
                self.assertIn("\n" + option["text"], text)
            example = re.findall(r"^  (orbicube .*)$", verb["notes"], re.M)[-1]
            self.assertIn("\n" + example + "\n", text)
            self.assertIn(" " + verb["text"], " ".join(run("--help").stdout.split()))

    @unittest.skipUnless(shutil.which("man") or shutil.which("groff"), "neither man nor groff")
    def test_pages_are_drawn_without_a_warning(self):
        for name in ("orbicube", *("orbicube-" + verb for verb in VERBS)):
            path = os.path.join(FOLDER, name + ".1")
            command = ["man", "--warnings", "-l", path] if shutil.which("man") else ["groff", "-ww", "-man", "-Tutf8", path]
            done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "MANWIDTH": "80", "LC_ALL": "C.UTF-8"}, check=True)
            self.assertEqual(done.stderr, "", name)
            self.assertIn("NAME", done.stdout)


def completed_by_bash(folder, line):
    """What bash offers for the last word of a command line, divided as Bash does."""
    words = [word for part in line.split(" ") for word in (re.split("(=)", part) if "=" in part else [part])]
    script = ('set -u; source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); _orbicube; '
              'printf "%s\\n" "${COMPREPLY[@]}"')
    done = subprocess.run(["bash", "--norc", "-c", script, "bash", os.path.join(FOLDER, "orbicube"), *words], capture_output=True, text=True,
                          cwd=folder, check=True)
    assert done.stderr == "", done.stderr
    return [word.strip() for word in done.stdout.splitlines() if word.strip()]


class Completion(InFolder):
    def complete(self, line):
        return completed_by_bash(self.folder, line)

    def test_bash_completes_verbs(self):
        self.assertEqual(set(self.complete("orbicube ")), set(VERBS))
        self.assertEqual(self.complete("orbicube sph"), ["sphere"])
        self.assertEqual(self.complete("orbicube --threads 2 sph"), ["sphere"])
        self.assertEqual(self.complete("orbicube --report info sph"), ["sphere"])  # info is a file here

    def test_bash_completes_the_options_of_help(self):
        self.assertEqual(set(self.complete("orbicube --")), options_of_help() - {"-h"})
        for verb in VERBS:
            self.assertEqual(set(self.complete(f"orbicube {verb} --")), {name for name in options_of_help(verb) if name.startswith("--")}, verb)
        self.assertEqual(self.complete("orbicube --quiet sphere --area"), ["--area-weight"])

    def test_bash_completes_words_that_options_choose_from(self):
        self.assertEqual(set(self.complete("orbicube view a.obj --up ")), {"y", "z"})
        self.assertIn("conformal", self.complete("orbicube sphere a.obj --method conf"))
        self.assertEqual(self.complete("orbicube sphere a.obj --method=conf"), ["conformal"])
        self.assertEqual(set(self.complete("orbicube sphere a.obj --method=")), set(self.complete("orbicube sphere a.obj --method ")))
        self.assertIn("bracket", self.complete("orbicube make "))
        found = 0
        for verb in DESCRIPTION["verbs"]:
            for option in verb["options"]:
                if option["choices"] and not option["positional"]:
                    self.assertEqual(self.complete(f"orbicube {verb['name']} {option['names'][-1]} "), option["choices"])
                    found += 1
        self.assertGreater(found, 10)

    def test_the_command_takes_the_words_that_are_offered(self):
        for verb in DESCRIPTION["verbs"]:
            for option in verb["options"]:
                for word in option["choices"]:
                    given = [word] if option["positional"] else [f"{option['names'][-1]}={word}"]
                    message = run(verb["name"], *given).stderr  # what else is missing is refused
                    self.assertNotIn(" not in ", message)
                    self.assertNotIn("no shape", message)

    def test_bash_completes_files_by_the_ending_of_the_option(self):
        for name in ("a b.json", "a.html", "a.obj"):
            with open(self.path(name), "w", encoding="ascii"):
                pass
        os.mkdir(self.path("a.folder"))
        self.assertEqual(set(self.complete("orbicube info a")), {"a b.json", "a.html", "a.obj", "a.folder"})
        self.assertEqual(set(self.complete("orbicube info a.obj --report a")), {"a b.json", "a.folder"})
        self.assertEqual(set(self.complete("orbicube view a.obj -o a")), {"a.html", "a.folder"})
        self.assertEqual(self.complete("orbicube info a.obj --threads a"), [])

    @unittest.skipUnless(shutil.which("zsh"), "no zsh")
    def test_zsh_reads_its_completion(self):
        subprocess.run(["zsh", "-n", os.path.join(FOLDER, "_orbicube")], check=True)

    @unittest.skipUnless(shutil.which("fish"), "no fish")
    def test_fish_completes_verbs_options_and_words(self):
        def complete(line):
            home = {"HOME": self.folder, "XDG_CONFIG_HOME": self.folder, "XDG_DATA_HOME": self.folder}
            done = subprocess.run(["fish", "--no-config", "-c", f"source {FOLDER}/orbicube.fish; complete -C '{line}'"], capture_output=True,
                                  text=True, check=True, cwd=self.folder, env={**os.environ, **home})
            return {row.split("\t")[0] for row in done.stdout.splitlines()}

        self.assertEqual(complete("orbicube "), set(VERBS))
        self.assertEqual(complete("orbicube view a --up "), {"y", "z"})
        for verb in VERBS:
            self.assertGreaterEqual(complete(f"orbicube {verb} --"), {name for name in options_of_help(verb) if name.startswith("--")}, verb)


if __name__ == "__main__":
    main()
