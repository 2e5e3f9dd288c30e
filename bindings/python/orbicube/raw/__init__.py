"""The C functions as they are, a module a library. Written by scripts/bindings.py."""
