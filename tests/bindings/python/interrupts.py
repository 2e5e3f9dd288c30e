"""Control-C while a C function works."""

import contextlib
import os
import signal
import threading
import time


@contextlib.contextmanager
def interrupted_after(seconds):
    """Sends this process SIGINT some time after the block has begun; the block must work for longer. Gives a list that gets the time of
    the process at the signal. The thread waits before the block, whose start takes a while on a busy machine."""
    begun, sent = threading.Event(), []

    def send():
        begun.wait()
        time.sleep(seconds)
        sent.append(time.process_time())
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=send)
    thread.start()
    try:
        begun.set()
        yield sent
    finally:
        thread.join()
