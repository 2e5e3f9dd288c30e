"""The C types of api.json taken apart, and how structs lie in memory."""

import re

# name -> bytes; every platform that is supported aligns these to their size.
SCALAR_SIZES = {"char": 1, "int8_t": 1, "uint8_t": 1, "int16_t": 2, "uint16_t": 2, "int32_t": 4, "uint32_t": 4,
                "int64_t": 8, "uint64_t": 8, "float": 4, "double": 8}


class Type:
    """`name`, whether that is const, and for each star from left to right whether it is followed by const."""

    def __init__(self, text):
        match = re.fullmatch(r"(const )?(\w+)\s*((?:\*(?:const)?\s*)*)", text)
        if not match:
            raise ValueError(f"not understood: {text}")
        self.constant = match.group(1) is not None
        self.name = match.group(2)
        self.stars = [bool(star) for star in re.findall(r"\*(const)?", match.group(3))]

    @property
    def is_pointer(self):
        return bool(self.stars)

    @property
    def is_string(self):
        return self.name == "char" and self.constant and len(self.stars) == 1


class Api:
    """api.json, with names looked up."""

    def __init__(self, description):
        self.libraries = description["libraries"]
        self.owner, self.alias, self.structs, self.callbacks, self.handles = {}, {}, {}, {}, set()
        for name, library in self.libraries.items():
            for kind in ("aliases", "structs", "callbacks", "handles"):
                for entry in library[kind]:
                    self.owner[entry["name"]] = name
            self.alias.update({entry["name"]: entry["type"] for entry in library["aliases"]})
            self.structs.update({entry["name"]: entry for entry in library["structs"]})
            self.callbacks.update({entry["name"]: entry for entry in library["callbacks"]})
            self.handles |= {entry["name"] for entry in library["handles"]}

    def type(self, text):
        """The type behind aliases."""
        kind = Type(text)
        while kind.name in self.alias:
            behind = Type(self.alias[kind.name])
            behind.constant = behind.constant or kind.constant
            behind.stars += kind.stars
            kind = behind
        return kind

    def size_and_alignment(self, field, pointer=8):
        """Of a field of a struct (or {"type": ...}), bytes."""
        if "function" in field:
            return pointer, pointer
        kind = self.type(field["type"])
        if kind.is_pointer or kind.name in self.callbacks:
            size = alignment = pointer
        elif kind.name == "size_t":
            size = alignment = pointer
        elif kind.name in self.structs:
            size, alignment, _ = self.layout(kind.name, pointer)
        else:
            size = alignment = SCALAR_SIZES[kind.name]
        for length in field.get("lengths", []):
            size *= length
        return size, alignment

    def layout(self, name, pointer=8):
        """Size, alignment and offsets of the fields of a struct, bytes, as C compilers have it."""
        offset, strictest, offsets = 0, 1, []
        for field in self.structs[name]["fields"]:
            size, alignment = self.size_and_alignment(field, pointer)
            offset = -(-offset // alignment) * alignment
            offsets.append((field["name"], offset))
            offset += size
            strictest = max(strictest, alignment)
        return -(-offset // strictest) * strictest, strictest, offsets

    def used(self, name):
        """The libraries that `name` uses, directly or not, each after those that it uses itself."""
        result = []
        for direct in self.libraries[name]["uses"]:
            result += [used for used in self.used(direct) + [direct] if used not in result]
        return result

    def imports(self, name):
        """Library -> names of it that the declarations of library `name` use, besides its own."""
        used = {}

        def look(entry):
            if "function" in entry:
                look(entry["function"])
                return
            for part in entry.get("parameters", []):
                look(part)
            for text in (entry.get("type"), entry.get("returns")):
                if text:
                    kind = self.type(text).name
                    owner = self.owner.get(kind)
                    if owner not in (None, name):
                        used.setdefault(owner, set()).add(kind)

        library = self.libraries[name]
        for struct in library["structs"]:
            for field in struct["fields"]:
                look(field)
        for entry in library["callbacks"] + library["functions"]:
            look(entry)
        return {owner: sorted(names) for owner, names in sorted(used.items())}


def in_order(structs, api):
    """Structs such that one held by value comes before its holder."""
    done, result = set(), []

    def add(struct):
        if struct["name"] in done:
            return
        done.add(struct["name"])
        for field in struct["fields"]:
            if "type" in field:
                kind = api.type(field["type"])
                if not kind.is_pointer and kind.name in api.structs:
                    for other in structs:
                        if other["name"] == kind.name:
                            add(other)
        result.append(struct)

    for struct in structs:
        add(struct)
    return result
