"""One option of a C struct, as the generated table _options.py lists them."""

from __future__ import annotations

from typing import Any, Mapping, Optional


class Option:
    """`kind` is "int", "float", "bool", "word" or "text"; `words` are those allowed, with the constants that they stand for."""

    def __init__(self, name: str, kind: str, default: Any, *, words: Optional[Mapping[str, int]] = None,
                 low: Optional[int] = None, high: Optional[int] = None, doc: str = "") -> None:
        self.name, self.kind, self.default, self.doc = name, kind, default, doc
        self.words, self.low, self.high = words, low, high
