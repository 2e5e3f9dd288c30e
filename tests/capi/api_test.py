#!/usr/bin/env python3
"""Tests of scripts/c_header.py and scripts/api.py on small headers."""

import copy
import unittest

import api
from c_header import Header, HeaderError

GOOD = """/* A library. */
#ifndef ORBICUBE_THING_H
#define ORBICUBE_THING_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How it ended. */
enum {
  OBC_THING_DONE = 1, /* well */
  OBC_THING_STOPPED,
  OBC_THING_FLAGS = 1 << 4 | OBC_THING_DONE
};

typedef int32_t obc_status;
typedef struct obc_error { obc_status status; char kind[28]; } obc_error;

/* A thing. */
typedef struct obc_thing obc_thing;

typedef struct obc_thing_options {
  uint32_t struct_size;
  const double *lower, *upper; /* bounds */
  double corners[OBC_THING_STOPPED][3];
  void (*log)(const char *line, void *user);
} obc_thing_options;

/* Returns 0 to go on. */
typedef int32_t (*obc_thing_function)(const double *x, double *const *rows, void *user);

/* Fills the options. */
OBC_API obc_status obc_thing_options_init(obc_thing_options *options, size_t struct_size);

/* Makes a thing.
 * Two lines. */
OBC_API obc_status obc_thing_create(const obc_thing_options *, obc_thing_function f, void *user, obc_thing **out,
                                    obc_error *error);
OBC_API void obc_thing_destroy(obc_thing *thing);

OBC_API uint32_t obc_thing_version(void); /* its version */

#ifdef __cplusplus
}
#endif

#endif
"""


def parsed(text):
    return Header("thing.h", text, {})


def breaches(text):
    header = parsed(text)
    return api.breaches("thing", header, {"thing": header})


class ReadingHeaders(unittest.TestCase):
    def test_everything_of_the_subset_is_read(self):
        header = parsed(GOOD)
        self.assertEqual([v["value"] for v in header.constants[0]["values"]], [1, 2, 17])
        self.assertEqual(header.constants[0]["doc"], "How it ended.")
        self.assertEqual(header.constants[0]["values"][0]["doc"], "well")
        self.assertEqual([h["name"] for h in header.handles], ["obc_thing"])
        options = header.structs[1]["fields"]
        self.assertEqual([(f["name"], f.get("type")) for f in options],
                         [("struct_size", "uint32_t"), ("lower", "const double *"), ("upper", "const double *"),
                          ("corners", "double"), ("log", None)])
        self.assertEqual(options[2]["doc"], "bounds")
        self.assertEqual(options[3]["lengths"], [2, 3])
        self.assertEqual(options[4]["function"]["parameters"][1]["type"], "void *")
        self.assertEqual(header.callbacks[0]["parameters"][1]["type"], "double *const *")
        create = header.functions[1]
        self.assertEqual(create["doc"], "Makes a thing.\nTwo lines.")
        self.assertEqual([p["type"] for p in create["parameters"]],
                         ["const obc_thing_options *", "obc_thing_function", "void *", "obc_thing **", "obc_error *"])
        self.assertEqual(header.functions[2]["doc"], create["doc"], "shares the comment of the function above")
        self.assertEqual(header.functions[3]["parameters"], [])
        self.assertEqual(header.functions[3]["doc"], "its version")

    def test_what_is_not_understood_is_refused_with_file_and_line(self):
        function = "OBC_API uint32_t obc_thing_version(void); /* its version */"
        line = GOOD[:GOOD.index(function)].count("\n") + 1
        for replacement in ("OBC_API long obc_thing_version(void);", "OBC_API int obc_thing_version(void);",
                            "OBC_API uint32_t obc_thing_version();", "uint32_t obc_thing_version(void);",
                            "#define OBC_THING_MAXIMUM 3", "struct obc_bits { uint32_t bits : 3; };",
                            "typedef enum { OBC_A } obc_kind;", "OBC_API obc_other *obc_thing_other(void);",
                            "// a comment", "static uint32_t x = 3;", "#include <stdbool.h>", "enum { OBC_A = sizeof(int) };",
                            "OBC_API uint32_t @;"):
            with self.subTest(replacement):
                with self.assertRaisesRegex(HeaderError, rf"^thing\.h:{line}: "):
                    parsed(GOOD.replace(function, replacement))

    def test_a_header_that_ends_early_is_refused(self):
        for end in ("typedef struct obc_thing_options {", "OBC_API obc_status obc_thing_create("):
            with self.subTest(end):
                with self.assertRaises(HeaderError):
                    parsed(GOOD[:GOOD.index(end) + len(end)])


class Rules(unittest.TestCase):
    def test_a_good_header_keeps_them(self):
        self.assertEqual(breaches(GOOD), [])

    def test_each_breach_is_said(self):
        for old, new, said in (
                ("/* its version */", "", "not documented"),
                ("  uint32_t struct_size;", "  uint64_t struct_size;", "does not start with uint32_t struct_size"),
                ("(obc_thing *thing)", "(obc_thing thing)", "struct passed by value"),
                ("obc_thing_version", "obc_version", "does not start with obc_thing_"),
                ("OBC_THING_DONE = 1", "DONE = 1, OBC_THING_DONE = 1", "does not start with OBC_"),
                ("obc_thing **out,\n                                    obc_error *error",
                 "obc_error *error,\n                                    obc_thing **out", "obc_error * is the last"),
                ("double *const *rows, void *user", "void *user, double *const *rows", "takes void *user last"),
                ("OBC_API void obc_thing_destroy(obc_thing *thing);", "", "no function obc_thing_destroy"),
                ("obc_thing_options_init(", "obc_thing_options_fill(", "no function obc_thing_options_init"),
        ):
            with self.subTest(said):
                changed = GOOD.replace(old, new)
                self.assertNotEqual(changed, GOOD)
                self.assertTrue(any(said in line for line in breaches(changed)), breaches(changed))


    def test_two_headers_do_not_declare_the_same_name(self):
        headers = {"thing": parsed(GOOD), "other": Header("other.h", "typedef double obc_thing;", {})}
        self.assertEqual(api.declared_twice(headers), ["other.h:1: obc_thing is declared in thing.h too"])


class Compatibility(unittest.TestCase):
    def changes(self, old, new):
        before = api.description({"thing": parsed(GOOD)}, "0")
        after = api.description({"thing": parsed(GOOD.replace(old, new))}, "0")
        self.assertNotEqual(before, after)
        raised = copy.deepcopy(after)
        raised["libraries"]["thing"]["soversion"] = "1"
        self.assertEqual(api.abi_breaches(before, raised), [])
        return api.abi_breaches(before, after)

    def test_additions_are_compatible(self):
        for old, new in (("OBC_THING_STOPPED,", "OBC_THING_STOPPED, OBC_THING_LATE = 9,"),
                         ("void *user);\n} obc_thing_options", "void *user);\n  double late;\n} obc_thing_options"),
                         ("OBC_API void", "OBC_API void obc_thing_late(void);\nOBC_API void"),
                         ("obc_thing_function f, void *user", "obc_thing_function g, void *user")):
            with self.subTest(new):
                self.assertEqual(self.changes(old, new), [])

    def test_what_breaks_a_program_needs_a_new_soname(self):
        for old, new in (("1 << 4 |", "1 << 5 |"),
                         ("*lower, *upper", "*upper, *lower"),
                         ("char kind[28];", "char kind[32];"),
                         ("obc_status status; char kind[28];", "obc_status status; char kind[28]; double late;"),
                         ("obc_thing_destroy", "obc_thing_release"),
                         ("size_t struct_size)", "uint32_t struct_size)"),
                         ("const char *line, void *user", "const char *line, double when, void *user")):
            with self.subTest(new):
                self.assertEqual(len(self.changes(old, new)), 1)


if __name__ == "__main__":
    unittest.main()
