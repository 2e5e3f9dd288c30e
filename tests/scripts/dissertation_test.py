"""Tests that the page of the dissertation by command is searched for names as its labels mean them."""

import unittest

import dissertation


class Names(unittest.TestCase):
    def test_there_are_ninety_seven(self):
        self.assertEqual(len(dissertation.NAMES), 97)
        self.assertEqual(len(set(dissertation.NAMES)), 97)

    def test_a_label_may_have_several(self):
        self.assertEqual(dissertation.names_of("Eq. 3.1"), {"Eq. 3.1"})
        self.assertEqual(dissertation.names_of("Eq. 3.8-3.11, 4.2"), {"Eq. 3.8", "Eq. 3.9", "Eq. 3.10", "Eq. 3.11", "Eq. 4.2"})
        self.assertEqual(dissertation.names_of("Algorithm 1 and 3"), {"Algorithm 1", "Algorithm 3"})
        self.assertEqual(dissertation.names_of("Figure 5.2a"), {"Figure 5.2"})
        self.assertEqual(dissertation.names_of("---"), set())
        self.assertEqual(dissertation.names_of("Section 6.1.4"), set())

    def test_a_row_that_is_left_out_is_missed(self):
        page = dissertation.write()
        self.assertEqual(dissertation.missing_names(page), [])
        for name in dissertation.NAMES:
            label = f"| {name}"
            rest = "\n".join(line for line in page.splitlines() if not line.startswith((label + " ", label + "a ", label + "b ")))
            self.assertEqual(dissertation.missing_names(rest), [name])


unittest.main()
