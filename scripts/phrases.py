#!/usr/bin/env python3
"""Lists phrases that the project's texts avoid, with file, line and the words to use instead.

    phrases.py [--count] [PATH...]

Searched are the texts that people read: Markdown pages without their code, and comments and sentences in quotes of source files.
Names in code are not searched: identifiers with an underscore, a call `name()`, and what stands in backticks. Without PATH, the paths of
CLEAN are searched, which `scripts/test --all` requires to be free of these phrases; `phrases.py .` searches the whole tree. `--count` prints
the number of hits by folder instead. The exit code is 1 where a phrase was found.
"""

import collections
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

# What has no such phrase left, as git's path patterns; `scripts/test --all` fails where one of these gets one.
CLEAN = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "meson.build", "meson_options.txt", "bench", "capi", "cli", "docs", "examples", "libs",
         "scripts", "bindings/cpp", "bindings/js", "bindings/rust", ":!bindings/js/raw", ":!bindings/rust/orbicube-sys"]

# A pattern and what to write instead. A blank stands for any white space, line ends included. Patterns with capitals are of exactly these
# letters, others of any case. What matches with the group `not` is no hit. A third entry is a pattern of the paths that are searched.
PHRASES = [
    (r"answer(s|ed|ing)?", "returns; is returned"),
    (r"ask(s|ed|ing)?", "requests, requires, queries"),
    (r"tells|told|tell (of|the user|whether|which|how|what|why)", "reports; distinguishes"),
    (r"so many|as many as there are", "N, about N; the number of"),
    (r"(the )?greatest(?! common)", "maximum, max_, largest"),
    (r"(?P<not>at )?(the|of|with|its|their|has|have|a) least(?![- ]squares)(?! recently)", "minimum, min_, smallest"),
    (r"at (most|least)(?=\s*[,;:.)])", "at most N, at least N, max_, min_"),
    (r"(turn(s|ed|ing)?( \w+){0,2} over|over-turned)(?! (all|the (values|whole)))", "flips, flipped; inverted"),
    (r"turn(s|ed|ing)?( \w+){0,4} right(?! (angle|hand))", "untangles, untangled"),
    (r"(?<!re)tangle[sd]?|tangling", "inverted mesh; untangle"),
    (r"what (is|are) (turned|inverted|flipped|twisted|read|written|joined|held)", "a noun: inverted tetrahedra, the written file"),
    (r"look(s|ed|ing)? (in|out)wards?|looks? the opposite way|inside out", "inward-oriented, outward-oriented; inverted"),
    (r"(triangles?|faces?|cells?|tetrahedr(a|on)) (is|are|was|were) (all )?turned(?! over)", "reversed"),
    (r"join(s|ed|ing)? (the |identical |coincident )?vertices|vert(ex|ices) (\w+ ){0,5}(are|is|was|were|be) joined", "weld, welded vertices"),
    (r"anew|once more", "again; restart"),
    (r"method `?seed`?|the seed's|seed (recipe|method)", "`dissertation`"),
    (r"(given|wanted|right|best|their|own) places|(meet|find|reach|hit)s? (its|their) places?|places (of|for) (the )?corners",
     "positional constraints, target positions"),
    (r"(meet(s|ing)?|met) (the )?(features|landmarks)|(features|landmarks) (are met|meet)", "aligns to features, landmarks that coincide"),
    (r"sharp angles?|feature angles?(?= (of|in|from))", "`feature_angle`, in degrees"),
    (r"wanted", "target, requested"),
    (r"by (the )?voxels", "grid-based"),
    (r"charts?", "patch", r"polycube"),
    (r"facets?", "patch", r"polycube"),
    (r"rectangles? of (a|the) polycube|polycube's (faces?|facets?)|faces? of (a|the|its|that|this) (same )?polycubes?", "patch"),
    (r"knobs?|horns?(?! \d)|limbs?", "protrusion"),
    (r"(is|are|be|been|being|was|were) (not )?held|held (fast|fixed|there|where|as|to|in place|while|at|but)|else held", "fixed"),
    (r"insist(s|ed|ing)?", "enforces"),
    (r"lift(s|ed|ing)?", "raises, raised"),
    (r"even(er)? lengths|lengths are even|evenly long", "arc-length equalization"),
    (r"first degenerate step", "flip-avoiding step bound (Smith and Schaefer 2015)"),
    (r"positive part of (the|its|each|a) \w+", "PSD projection"),
    (r"dilatations?", "quasi-conformal distortion"),
    (r"(Team|Waves|Manner)", "thread pool, dependency levels, strategy"),
    (r"(it|they|this|that|these) used to|used to be|before this change|where (it|they) took|(it|they) took \d", "the present state"),
    (r"(normal|optim|minim|maxim|initial|organ|recogn|regular|parametr|equal|discret|vectoris|summar|real|general|symmetr|linear|triangular|"
     r"serial|visual|orthogonal|penal|special|local|final|util|factor|orthonormal|factori)is(e[sd]?|ing|ations?|ers?)", "-ize, -ization"),
    (r"colour\w*|neighbour\w*|behaviour\w*|centre[sd]?|grey|favour\w*|analyse[sd]?|metres?|modell\w+|labell\w+|licence[sd]?|catalogue|artefacts?", "American spelling"),
]

WHOLE = r"(?<![\w-])(?:%s)(?!\w|-[\w-]*\.\w|-\x01)"  # words, and not a part of the name of a file
COMPILED = [(re.compile(WHOLE % pattern.replace(" ", r"\s+"), 0 if re.search("[A-Z]", pattern.replace("P<", "")) else re.IGNORECASE), words,
             re.compile(paths[0] if paths else "")) for pattern, words, *paths in PHRASES]

C_LIKE = re.compile(r"(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<text>R\"\(.*?\)\"|\"(?:\\.|[^\"\\\n])*\"|`(?:\\.|[^`\\])*`)|(?P<other>'(?:\\.|[^'\\\n])*')", re.DOTALL)
SCRIPT = re.compile(r"(?P<comment>(?<![\w$&{])#[^\n]*)|(?P<text>\"\"\".*?\"\"\"|'''.*?'''|\"(?:\\.|[^\"\\])*\"|'(?:\\.|[^'\\\n])*')", re.DOTALL)
KINDS = {".h": C_LIKE, ".c": C_LIKE, ".cpp": C_LIKE, ".hpp": C_LIKE, ".in": C_LIKE, ".js": C_LIKE, ".mjs": C_LIKE, ".ts": C_LIKE, ".rs": C_LIKE,
         ".py": SCRIPT, ".jl": SCRIPT, ".build": SCRIPT, ".txt": SCRIPT, ".toml": SCRIPT, "": SCRIPT, ".md": None}
# Names, which are not prose: in backticks, with an underscore, calls, options, references to parts of a struct.
NAMES = re.compile(r"``[^`\n]+``|`[^`\n]+`|@?\b\w*[a-z0-9]_\w*|\b_\w+|\b[A-Z][A-Z0-9]*_[A-Z0-9_]+|\b[\w.]+\(\)|--[\w-]+|\b\w+(?:\.|->|::)[a-z_]\w*\b(?!\s[A-Z])|\]\([^)\s]+\)")


def blank(text, filler=" "):
    """The text with everything replaced but line ends, so that lines and offsets stay."""
    return re.sub(r"[^\n]", filler, text)


def without_names(text):
    return NAMES.sub(lambda found: blank(found.group(0), "\1"), text)


def prose_of_page(text):
    """A page without its fenced code, of which comments stay."""
    def fenced(found):
        fence, language, code = found.groups()
        pattern = SCRIPT if language in ("sh", "python", "julia") else C_LIKE
        return blank(fence, "\1") + (prose_of_source(code, pattern) if language else blank(code, "\1")) + "\1\1\1"
    return without_names(re.sub(r"^(```(\w*)[^\n]*\n)(.*?)^```", fenced, text, flags=re.MULTILINE | re.DOTALL))


def prose_of_source(text, pattern):
    """Comments and the sentences in quotes, with blanks for their frames; the rest becomes a character that no phrase has."""
    kept, end, sentence = [], 0, False
    for found in pattern.finditer(text):
        between, piece = text[end:found.start()], found.group(0)
        kept.append(re.sub(r"\S", "\1", between))
        # A string of one word is a key or a name, unless it goes on with the sentence of the string before it.
        sentence = found.lastgroup == "text" and bool(re.search(r"\w[,.;:]?\s+\w", piece) or sentence and not between.strip())
        if found.lastgroup == "comment":
            kept.append(re.sub(r"(?m)^(\s*)(//+!?|/\*+|\*/|\*|#+)|\*/$", lambda frame: blank(frame.group(0)), piece))
        elif sentence and "gl_Position" not in piece and "out vec4" not in piece:
            # Values in a string of Python, JavaScript, Julia or a shell.
            piece = re.sub(r"\{[^{}\n]*\}|\$\w+", lambda value: blank(value.group(0), "\1"), piece)
            kept.append(re.sub(r"\\n|^R?[\"'`(]+|[\"'`)]+$", lambda frame: blank(frame.group(0)), piece))
        else:
            kept.append(blank(piece, "\1"))
        end = found.end()
    kept.append(blank(text[end:], "\1"))
    return without_names("".join(kept))


def hits(path, text):
    """(line, phrase, words to use) of each phrase in a file's text, in the order of lines."""
    pattern = KINDS[os.path.splitext(path)[1]]
    prose = prose_of_page(text) if pattern is None else prose_of_source(text, pattern)
    prose = re.sub("[ \1]*\1[ \1]*", "\1", prose)  # only lines matter from here on, and short texts are searched faster
    found = [(prose.count("\n", 0, match.start()) + 1, " ".join(match.group(0).split()), words)
             for expression, words, paths in COMPILED if paths.search(path)
             for match in expression.finditer(prose) if not match.groupdict().get("not")]
    return sorted(found)


def files(paths):
    """The tracked text files at paths, without this script and its test, which name the phrases."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "--", *paths], capture_output=True, text=True, check=False)
    if listed.returncode != 0:
        print("not a git tree: the files are not known")
        sys.exit(77)  # what Meson takes for "skipped"
    for path in listed.stdout.split("\n")[:-1]:
        extension = os.path.splitext(path)[1]
        if extension in KINDS and os.path.basename(path) not in ("phrases.py", "phrases_test.py", "LICENSE"):
            yield path


def folder_of(path):
    """The folder that a count is given for: the first two names of a path."""
    parts = path.split("/")[:-1]
    return "/".join(parts[:2]) or path


def main(arguments):
    count = "--count" in arguments
    paths = [path for path in arguments if path != "--count"]
    if any(path.startswith("-") for path in paths):
        sys.exit(__doc__)
    total, by_folder = 0, collections.Counter()
    for path in files(paths or CLEAN):
        with open(os.path.join(ROOT, path), encoding="utf-8", errors="replace") as file:
            text = file.read()
        if text.startswith("#!") or os.path.splitext(path)[1]:
            for line, phrase, words in hits(path, text):
                total += 1
                by_folder[folder_of(path)] += 1
                if not count:
                    print(f'{path}:{line}: "{phrase}": {words}')
    if count:
        for folder, number in sorted(by_folder.items()):
            print(f"{number:6} {folder}")
    print(f"{total} phrases to replace")
    return 1 if total else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
