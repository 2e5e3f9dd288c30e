"""Tests that the script that recomputes the figures of the pages finds differences, and that all tables are in its lists."""

import unittest

import figures

PAGE = """# Page

## Results

| solid | cells | error / bound | s | theirs |
|---|---|---|---|---|
| bunny | 1200 | 0.125 / 1e-3 | 3.1 | 7 |
| `two words` | 12, 1.6 s | -0.5 | 4 | 8 |
"""
OUTPUT = "bunny  1200 0.1249 0.001 9.9\nTwo words: 12 -0.5 | 0.3 s\n"


class Figures(unittest.TestCase):
    def table(self, page=PAGE):
        return figures.tables_of("page.md", page)[0]

    def test_every_table_with_figures_is_listed_and_every_listed_table_is_there(self):
        self.assertEqual(figures.check(), "")

    def test_a_table_that_is_not_listed_is_found(self):
        self.assertIsNone(figures.entry_of(self.table()))
        self.assertTrue(self.table().has_figures())

    def test_a_page_that_is_written_again_may_differ_in_times_and_in_one_of_the_last_digit(self):
        again = PAGE.replace("3.1", "5.5").replace("0.125", "0.126").replace("1.6 s", "2 s")
        self.assertEqual(figures.differences_of_tables(self.table(), self.table(again)), [])
        for old, new in (("1200", "1202"), ("0.125", "0.127"), ("1e-3", "3e-3"), ("| -0.5", "| 0.5"), ("1200", "none"), ("bunny", "cow")):
            found = figures.differences_of_tables(self.table(), self.table(PAGE.replace(old, new)))
            self.assertEqual(len(found), 1, (old, new, found))
        self.assertEqual(len(figures.differences_of_tables(self.table(), self.table("\n".join(PAGE.splitlines()[:-1])))), 1)

    def test_each_figure_of_a_pasted_row_has_to_be_in_a_line_of_its_name(self):
        self.assertEqual(figures.differences_of_rows(self.table(), OUTPUT, ("theirs",)), [])
        self.assertEqual(len(figures.differences_of_rows(self.table(), OUTPUT)), 2)  # what others have is not printed
        self.assertEqual(figures.differences_of_rows(self.table(), OUTPUT.replace("1200", "7"), ("theirs", ("bun", "cell"))), [])
        for old, new in (("1200", "1300"), ("0.1249", "0.2"), ("-0.5", "0.5"), ("Two words", "Three")):
            self.assertEqual(len(figures.differences_of_rows(self.table(), OUTPUT.replace(old, new), ("theirs",))), 1, new)


unittest.main()
