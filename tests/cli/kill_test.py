#!/usr/bin/env python3
"""A command that is killed at any of its steps to write a file leaves the old file or the whole new one.

    kill_test.py COMMAND

A library that is loaded before the C library counts the calls that create, write, flush and rename files, and kills the
process in the middle of the one that it is given: no moment depends on how fast the machine is.
"""
import os
import subprocess
import unittest

from command import COMMAND, SANITIZED, InFolder, main, read_obj, run

OLD = b"what was here before\n"
KILLER = r"""
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <unistd.h>

/* The number of steps so far; the one that was named is the last. */
static int strikes(void) {
  static int step;
  const char *last = getenv("KILL_AT");
  return last != NULL && step++ == atoi(last);
}
static void strike(void) { kill(getpid(), SIGKILL); }

#define OPEN(NAME, DECLARED, GIVEN) \
  int NAME DECLARED { \
    mode_t mode = 0; \
    if (flags & O_CREAT) { va_list rest; va_start(rest, flags); mode = va_arg(rest, mode_t); va_end(rest); } \
    int (*real) DECLARED = (int (*) DECLARED)dlsym(RTLD_NEXT, #NAME); \
    const int dies = (flags & O_CREAT) && strikes(); \
    const int made = real GIVEN; \
    if (dies) strike(); \
    return made; \
  }
OPEN(open, (const char *path, int flags, ...), (path, flags, mode))
OPEN(open64, (const char *path, int flags, ...), (path, flags, mode))
OPEN(openat, (int folder, const char *path, int flags, ...), (folder, path, flags, mode))
OPEN(openat64, (int folder, const char *path, int flags, ...), (folder, path, flags, mode))

ssize_t write(int file, const void *bytes, size_t size) {
  ssize_t (*real)(int, const void *, size_t) = (ssize_t(*)(int, const void *, size_t))dlsym(RTLD_NEXT, "write");
  if (file > 2 && strikes()) { real(file, bytes, size / 2); strike(); }
  return real(file, bytes, size);
}
int fsync(int file) {
  int (*real)(int) = (int (*)(int))dlsym(RTLD_NEXT, "fsync");
  if (strikes()) strike();
  return real(file);
}
#define RENAME(NAME, DECLARED, GIVEN) \
  int NAME DECLARED { \
    int (*real) DECLARED = (int (*) DECLARED)dlsym(RTLD_NEXT, #NAME); \
    if (strikes()) strike(); \
    const int done = real GIVEN; \
    if (strikes()) strike(); \
    return done; \
  }
RENAME(rename, (const char *from, const char *to), (from, to))
RENAME(renameat, (int a, const char *from, int b, const char *to), (a, from, b, to))
"""


class Kills(InFolder):
    @unittest.skipIf(SANITIZED, "the sanitizer must be loaded first")
    def test_a_kill_at_any_step_leaves_the_old_file_or_the_whole_new_one(self):
        shape, out, killer = self.made("creature", 2000), self.path("out.obj"), self.path("killer.so")
        with open(self.path("killer.c"), "w", encoding="ascii") as file:
            file.write(KILLER)
        subprocess.run(["cc", "-shared", "-fPIC", self.path("killer.c"), "-o", killer, "-ldl"], check=True)
        self.assertEqual(run("sphere", shape, "-o", out).returncode, 0)
        with open(out, "rb") as file:
            whole = file.read()
        found = []
        for step in range(1000):
            with open(out, "wb") as file:
                file.write(OLD)
            done = subprocess.run([COMMAND, "sphere", shape, "-o", out], capture_output=True, timeout=240, check=False,
                                  env=dict(os.environ, LD_PRELOAD=killer, KILL_AT=str(step)))
            with open(out, "rb") as file:
                content = file.read()
            if done.returncode == 0:
                self.assertEqual(content, whole)
                break
            self.assertEqual(done.returncode, -9, done.stderr)
            self.assertIn(content, (OLD, whole), f"step {step}")
            found.append(content == whole)
        else:
            self.fail("killed a thousand times without an end")
        # Created, written, flushed, renamed: the old file before the renaming, the new one after it.
        self.assertGreaterEqual(found.count(False), 4, found)
        self.assertEqual(found.count(True), 1, found)
        self.assertEqual(read_obj(out)[1], read_obj(shape)[1])


if __name__ == "__main__":
    main()
