#!/usr/bin/env python3
"""scripts/phrases.py finds phrases in texts, at their lines, and leaves code and names alone."""

import os
import subprocess
import sys
import unittest

import phrases

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def found(path, text):
    return [(line, phrase) for line, phrase, _ in phrases.hits(path, text)]


class Texts(unittest.TestCase):
    def test_comments_are_searched_at_their_lines(self):
        self.assertEqual(found("a.h", "int a;\n/* Answers\n * 0 where it is wanted. */\nint b; // told\n"),
                         [(2, "Answers"), (3, "wanted"), (4, "told")])

    def test_a_phrase_may_go_over_the_end_of_a_line(self):
        self.assertEqual(found("a.h", "// a surface that looks\n// outward\n"), [(1, "looks outward")])
        self.assertEqual(found("a.md", "a surface that looks\noutward\n"), [(1, "looks outward")])
        self.assertEqual(found("a.cpp", 'note("a surface that looks "\n     "outward");\n'), [(1, "looks outward")])

    def test_sentences_in_quotes_are_searched_and_words_are_not(self):
        self.assertEqual(found("a.cpp", 'throw Error("kind", "two values are wanted");\nkey("wanted"); wanted(1);\n'), [(1, "wanted")])
        self.assertEqual(found("a.py", '"""Tells how many."""\nwanted = {"wanted": 1}  # asks\n'), [(1, "Tells"), (2, "asks")])

    def test_names_are_not_searched(self):
        self.assertEqual(found("a.h", "/* Calls obc_trust_region_tell, wanted_shape, `wanted` and wanted() with --wanted. */\n"), [])
        self.assertEqual(found("a.md", "The member `wanted` and [its page](wanted.md).\n"), [])

    def test_code_of_pages_is_not_searched_but_its_comments_are(self):
        self.assertEqual(found("a.md", "```c\nint wanted; /* what is asked for */\n```\nTold.\n"), [(2, "asked"), (4, "Told")])
        self.assertEqual(found("a.md", "```\nwanted\n```\n"), [])

    def test_values_in_strings_are_not_searched(self):
        self.assertEqual(found("a.py", 'print(f"a line {colour} of it")\n'), [])


class Words(unittest.TestCase):
    def test_each_phrase_of_the_table_is_found(self):
        for phrase in ("it answers the number", "a limit that is asked for", "reports when told of it", "so many cells", "the greatest angle",
                       "the least angle", "50 cells at most.", "no triangle is turned over", "turned right again", "a tangled mesh", "what is inverted",
                       "looked inward", "the solid is inside out", "3 triangles were turned", "joined vertices", "started anew", "once more", "the method seed", "go to their places", "to meet features",
                       "sharp angles", "a wanted shape", "hexahedra by voxels", "a knob", "vertices held fixed",
                       "insists on it", "lifted to it", "even lengths", "the first degenerate step", "the positive part of the Hessian",
                       "the mean dilatation", "a Team of threads", "normalised", "optimisation", "colours", "its neighbours", "the centre", "behaviour"):
            self.assertEqual(len(phrases.hits("a.md", phrase)), 1, phrase)

    def test_some_phrases_are_looked_for_in_some_paths(self):
        self.assertEqual(len(phrases.hits("docs/polycube.md", "a chart with four corners, a facet")), 2)
        self.assertEqual(phrases.hits("docs/volume_map.md", "from chart to chart"), [])

    def test_words_of_the_field_are_not_found(self):
        for words in ("a least-squares fit", "by least squares", "at least 3 vertices and at most 7", "a right turn of 90 degrees", "threads are joined",
                      "turn the page over all the values", "a facet of STL", "an edge joins two vertices", "Horn 1987", "what costs least", "solves and returns", "decimal places", "untangled", "the rectangle",
                      "a file holds doubles", "two edges meet", "the exercise", "a precise promise", "otherwise", "concise"):
            self.assertEqual(phrases.hits("a.md", words), [], words)


class Tree(unittest.TestCase):
    def test_the_paths_that_are_clean_have_none(self):
        ran = subprocess.run([sys.executable, os.path.join(ROOT, "scripts", "phrases.py")], capture_output=True, text=True, check=False)
        self.assertIn(ran.returncode, (0, 77), ran.stdout + ran.stderr)


if __name__ == "__main__":
    unittest.main()
