"""Long work can be ended, tells how far it is, and leaves Python's lock to others."""
import os
import signal
import threading
import time
import unittest

import documents
import numpy as np
import sturm

# Minutes of work.
LONG = documents.changed(documents.changed(documents.view(), "/method/samples_per_pixel", 2000), "/camera/resolution", [200, 200])
SOON_S = 5.0  # a tile takes about 1 s, and a loaded machine more


class Interrupts(unittest.TestCase):
    def test_ctrl_c_ends_a_rendering(self):
        timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        started = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            sturm.render(LONG)
        self.assertLess(time.monotonic() - started, 0.5 + SOON_S)
        sturm.ellipses(sturm.Eye("oblique_astigmat"), 1.0)  # the module goes on working

    def test_an_exception_of_progress_ends_a_rendering(self):
        class Enough(Exception):
            pass

        def progress(fraction):
            self.assertEqual(threading.current_thread(), threading.main_thread())
            raise Enough(fraction)

        started = time.monotonic()
        with self.assertRaises(Enough):
            sturm.render(LONG, progress=progress)
        self.assertLess(time.monotonic() - started, SOON_S)

    def test_progress_rises_to_one(self):
        told = []
        sturm.render(documents.changed(documents.view(), "/method/samples_per_pixel", 512), progress=told.append)
        self.assertEqual((told, told[-1]), (sorted(told), 1.0))

    def count_meanwhile(self, work):
        """How often another thread came round while `work` was done."""
        count, done = 0, threading.Event()

        def counting():
            nonlocal count
            while not done.is_set():
                count += 1
                time.sleep(1e-3)

        thread = threading.Thread(target=counting)
        thread.start()
        work()
        done.set()
        thread.join()
        return count

    def test_the_lock_is_released(self):
        eye = sturm.Eye("oblique_astigmat")
        distances_m = np.linspace(0.2, 5, 3_000_000)
        self.assertGreater(self.count_meanwhile(lambda: sturm.ellipses(eye, distances_m)), 20)
        view = documents.changed(documents.view(), "/method/samples_per_pixel", 256)
        self.assertGreater(self.count_meanwhile(lambda: sturm.render(view)), 20)


if __name__ == "__main__":
    unittest.main()
