"""Reads a C header of the subset of C99 that Orbicube's public headers are written in.

Understood are: include guards and `#if` blocks that hold nothing but directives, `#include <orbicube/x.h>`, `extern "C"`
in `#ifdef __cplusplus`, enumerations, type aliases, opaque, tagged and untagged structs, function pointer types, and
functions declared with the header's export macro. Everything else is a HeaderError with file and line: what the bindings
cannot see must not be in a header.

A comment that ends on the line above a declaration, or on the same line behind it, is its documentation. Functions that follow
a documented one without a blank line or another comment share its documentation.
"""

import ast
import re

TOKEN = re.compile(r"""(?P<comment>/\*.*?\*/)|(?P<line_comment>//[^\n]*)|(?P<string>"[^"\n]*")|(?P<name>[A-Za-z_]\w*)
                       |(?P<number>\d\w*(?:\.\d*)?)|(?P<punctuation><<|>>|\.\.\.|[{}()\[\];,*=+\-|&~:<>])
                       |(?P<space>[ \t\r\n]+)""", re.DOTALL | re.VERBOSE)
DIRECTIVE = re.compile(r"[ \t]*#[ \t]*(\w+)[ \t]*(.*)")
SCALARS = {"void", "char", "double", "float", "size_t", "int8_t", "int16_t", "int32_t", "int64_t", "uint8_t", "uint16_t",
           "uint32_t", "uint64_t"}


class HeaderError(Exception):
    """What is wrong in a header, with file and line."""

    def __init__(self, path, line, message):
        super().__init__(f"{path}:{line}: {message}")


class Token:
    def __init__(self, text, line):
        self.text = text
        self.line = line


def comment_text(raw):
    """The words of a comment, without its frame; line breaks stay, so that lists stay readable."""
    lines = [re.sub(r"^\s*\* ?", "", line) if i else line.strip() for i, line in enumerate(raw[2:-2].split("\n"))]
    return "\n".join(line.strip() if i == 0 else line.rstrip() for i, line in enumerate(lines)).strip()


class Header:
    """One parsed header. `known_types` and `known_constants` are those of the headers that it includes."""

    def __init__(self, path, text, included):
        self.path = path
        self.includes, self.constants, self.aliases, self.handles = [], [], [], []
        self.structs, self.callbacks, self.functions = [], [], []
        self.types = set(SCALARS)
        self.values = {}
        self.tokens, self.comments, self.position = [], [], 0
        self.read_tokens(self.without_directives(text))
        for name in self.includes:
            if name in included:
                self.types |= included[name].types
                self.values.update(included[name].values)
        self.read_declarations()

    def fail(self, line, message):
        raise HeaderError(self.path, line, message)

    # -- lines and tokens -------------------------------------------------------------------------------------------

    def without_directives(self, text):
        """The text with directives, and what only C++ sees, replaced by blank lines."""
        conditions, result, in_comment = [], [], False
        for number, line in enumerate(text.split("\n"), 1):
            match = None if in_comment else DIRECTIVE.fullmatch(line)
            if match:
                word, rest = match.group(1), match.group(2).strip()
                if word in ("if", "ifdef", "ifndef"):
                    guard = word == "ifndef" and not conditions and rest.startswith("ORBICUBE_")
                    conditions.append("guard" if guard else "cpp" if rest == "__cplusplus" else "directives")
                elif word == "endif":
                    if not conditions:
                        self.fail(number, "#endif without #if")
                    conditions.pop()
                elif word == "include":
                    self.read_include(number, rest)
                elif word == "define":
                    if not re.fullmatch(r"ORBICUBE_\w+_H|OBC_API(\s.*)?", rest):
                        self.fail(number, "a macro, which other languages cannot see: use an enumeration")
                elif word not in ("else", "elif"):
                    self.fail(number, f"directive #{word} is not understood")
                line = ""
            elif conditions and conditions[-1] == "cpp":
                if line.strip() not in ('extern "C" {', "}", ""):
                    self.fail(number, "only extern \"C\" may stand in #ifdef __cplusplus")
                line = ""
            elif conditions and conditions[-1] == "directives" and line.strip():
                self.fail(number, "only directives may stand in this #if")
            result.append(line)
            for mark in re.finditer(r"/\*|\*/", line):
                in_comment = mark.group() == "/*"
        if conditions:
            self.fail(len(result), "#if without #endif")
        return "\n".join(result)

    def read_include(self, number, rest):
        own = re.fullmatch(r"[<\"]orbicube/(\w+)\.h[>\"]", rest)
        if own:
            self.includes.append(own.group(1))
        elif rest not in ("<stddef.h>", "<stdint.h>"):
            self.fail(number, f"includes {rest}: a public header needs nothing but stddef.h, stdint.h and orbicube's own")

    def read_tokens(self, text):
        position, line = 0, 1
        while position < len(text):
            match = TOKEN.match(text, position)
            if not match:
                self.fail(line, f"not understood: {text[position:position + 30].splitlines()[0]!r}")
            kind, piece = match.lastgroup, match.group()
            if kind == "line_comment":
                self.fail(line, "// is not a comment of every C compiler: use /* */")
            if kind == "comment":
                self.comments.append((line, line + piece.count("\n"), comment_text(piece)))
            elif kind != "space":
                self.tokens.append(Token(piece, line))
            line += piece.count("\n")
            position = match.end()

    def peek(self, ahead=0):
        return self.tokens[self.position + ahead].text if self.position + ahead < len(self.tokens) else ""

    def line(self):
        return self.tokens[min(self.position, len(self.tokens) - 1)].line

    def take(self, expected=None):
        if self.position >= len(self.tokens):
            self.fail(self.line(), "the header ends in the middle of a declaration")
        token = self.tokens[self.position]
        if expected is not None and token.text != expected:
            self.fail(token.line, f"expected '{expected}', found '{token.text}'")
        self.position += 1
        return token.text

    def take_name(self):
        if not re.fullmatch(r"[A-Za-z_]\w*", self.peek()):
            self.fail(self.line(), f"expected a name, found '{self.peek()}'")
        return self.take()

    def comment_for(self, first_line, last_line):
        """The comment above `first_line`, and the one that starts on `last_line` behind the declaration."""
        above = [text for _, end, text in self.comments if end == first_line - 1 and not self.is_behind_code(end, text)]
        behind = [text for start, _, text in self.comments if start == last_line]
        return "\n".join(above + behind)

    def is_behind_code(self, end, text):
        start = next(s for s, e, t in self.comments if e == end and t == text)
        return any(token.line == start for token in self.tokens)

    # -- declarations -----------------------------------------------------------------------------------------------

    def read_declarations(self):
        while self.position < len(self.tokens):
            word = self.peek()
            if word == "typedef":
                self.read_typedef()
            elif word == "enum":
                self.read_enumeration()
            elif word == "struct" and self.peek(2) == "{":
                self.read_struct()
            elif word == "OBC_API":
                self.read_function()
            else:
                self.fail(self.line(), f"'{word}' does not start a declaration that is understood (a function starts "
                                       "with OBC_API)")

    def read_typedef(self):
        first = self.line()
        self.take("typedef")
        if self.peek() == "enum":
            self.fail(first, "an enumeration type has no fixed size: use enum { ... } and int32_t")
        if self.peek() == "struct":
            if self.peek(1) == "{" or self.peek(2) == "{":
                self.read_struct(first)
                return
            self.take()
            tag, name = self.take_name(), self.take_name()
            if tag != name:
                self.fail(first, f"struct {tag} has another name than its type {name}")
            self.take(";")
            self.types.add(name)
            self.handles.append({"name": name, "doc": self.comment_for(first, first)})
            return
        returns = self.read_type()
        if self.peek() == "(":
            declared = self.read_function_pointer(returns)
            self.callbacks.append({"name": declared["name"], "returns": returns,
                                   "parameters": declared["function"]["parameters"]})
            declared_list = self.callbacks
        else:
            declared = {"name": self.take_name()}
            self.aliases.append({"name": declared["name"], "type": returns})
            declared_list = self.aliases
        last = self.line()
        self.take(";")
        declared_list[-1]["doc"] = self.comment_for(first, last)
        declared_list[-1]["line"] = first
        self.types.add(declared["name"])

    def read_enumeration(self):
        first = self.line()
        self.take("enum")
        name = "" if self.peek() == "{" else self.take_name()
        self.take("{")
        values, following = [], 0
        while self.peek() != "}":
            line = self.line()
            constant = self.take_name()
            if self.peek() == "=":
                self.take()
                following = self.read_constant({",", "}"})
            if self.peek() == ",":
                self.take()
            elif self.peek() != "}":
                self.fail(self.line(), f"expected ',' or '}}', found '{self.peek()}'")
            self.values[constant] = following
            values.append({"name": constant, "value": following, "doc": self.comment_for(line, line), "line": line})
            following += 1
        self.take("}")
        self.take(";")
        self.constants.append({"name": name, "doc": self.comment_for(first, -1), "values": values, "line": first})

    def read_constant(self, ends):
        """An integer expression of numbers and earlier constants, up to one of `ends`."""
        line, words = self.line(), []
        while self.peek() not in ends:
            word = self.take()
            if word in self.values:
                word = f"({self.values[word]})"
            elif not re.fullmatch(r"0[xX][0-9a-fA-F]+[uU]?|\d+[uU]?|<<|>>|[()+\-*|&~]", word):
                self.fail(line, f"'{word}' is not an integer or an earlier constant")
            words.append(word.rstrip("uU"))
        try:
            tree = ast.parse(" ".join(words), mode="eval")
        except SyntaxError:
            self.fail(line, "not an integer expression")
        return int(eval(compile(tree, self.path, "eval"), {"__builtins__": {}}))  # numbers and operators only

    def read_struct(self, typedef_line=None):
        first = typedef_line or self.line()
        self.take("struct")
        tag = "" if self.peek() == "{" else self.take_name()
        self.take("{")
        fields = []
        while self.peek() != "}":
            fields += self.read_fields()
        self.take("}")
        name = self.take_name() if typedef_line else tag
        self.take(";")
        if tag and tag != name:
            self.fail(first, f"struct {tag} has another name than its type {name}")
        self.types.add(name)
        self.handles = [handle for handle in self.handles if handle["name"] != name]
        self.structs.append({"name": name, "doc": self.comment_for(first, -1), "fields": fields, "line": first})

    def read_fields(self):
        """One line of a struct, which may declare several fields of one type."""
        first, fields = self.line(), []
        base = self.read_type(pointers=False)
        while True:
            stars = self.read_stars(base)
            if self.peek() == "(":
                field = self.read_function_pointer(stars)
            else:
                field = {"name": self.take_name(), "type": stars}
                lengths = self.read_lengths()
                if lengths:
                    field["lengths"] = lengths
            if self.peek() == ":":
                self.fail(self.line(), "a bit-field")
            fields.append(field)
            if self.peek() != ",":
                break
            self.take(",")
        last = self.line()
        self.take(";")
        doc = self.comment_for(first, last)
        for field in fields:
            field.update(doc=doc, line=first)
        return fields

    def read_lengths(self):
        lengths = []
        while self.peek() == "[":
            self.take()
            lengths.append(self.read_constant({"]"}))
            self.take("]")
        return lengths

    def read_type(self, pointers=True):
        constant = self.peek() == "const"
        if constant:
            self.take()
        if self.peek() == "struct":
            self.take()
        line = self.line()
        name = self.take_name()
        if name not in self.types:
            self.fail(line, f"'{name}' is not a type that may be in a public header (known: fixed-size integers, size_t, "
                            "float, double, char, void and what the headers declare)")
        if self.peek() == "const":
            self.take()
            constant = True
        text = f"const {name}" if constant else name
        return self.read_stars(text) if pointers else text

    def read_stars(self, text):
        while self.peek() == "*":
            self.take()
            text += "*" if text.endswith("*") else " *"
            if self.peek() == "const":
                self.take()
                text += "const"
        return text

    def read_function_pointer(self, returns):
        self.take("(")
        self.take("*")
        name = self.take_name()
        self.take(")")
        return {"name": name, "function": {"returns": returns, "parameters": self.read_parameters()}}

    def read_parameters(self):
        self.take("(")
        parameters = []
        if self.peek() == "void" and self.peek(1) == ")":
            self.take()
        elif self.peek() == ")":
            self.fail(self.line(), "() declares no parameters in C++ and any in C: write (void)")
        while self.peek() != ")":
            line, base = self.line(), self.read_type()
            if self.peek() == "(":
                parameter = self.read_function_pointer(base)
            else:
                parameter = {"name": "" if self.peek() in (",", ")", "[") else self.take_name(), "type": base}
                lengths = self.read_lengths()
                if lengths:
                    parameter["lengths"] = lengths
            parameter["line"] = line
            parameters.append(parameter)
            if self.peek() == ",":
                self.take()
            elif self.peek() != ")":
                self.fail(self.line(), f"expected ',' or ')', found '{self.peek()}'")
        self.take(")")
        return parameters

    def read_function(self):
        first = self.line()
        self.take("OBC_API")
        returns = self.read_type()
        name = self.take_name()
        parameters = self.read_parameters()
        last = self.line()
        self.take(";")
        doc = self.comment_for(first, last)
        if not doc and self.functions and self.functions[-1]["last_line"] == first - 1:
            doc = self.functions[-1]["doc"]
        self.functions.append({"name": name, "returns": returns, "parameters": parameters, "doc": doc, "line": first,
                               "last_line": last})
