"""Writers of the raw layers of the bindings, a file a language; scripts/bindings.py puts them together."""
