#!/usr/bin/python3
"""Threads, Ctrl-C and callbacks while the Python module works."""
import os
import signal
import threading
import time
import unittest

import drystone

from scene import CHEAP, InFolder, LONG, QUICK, run, STUDY, WALL


class PythonGoesOnMeanwhile(InFolder):
    def interrupted(self, work):
        """Seconds from Ctrl-C to its exception."""
        sent = []

        def interrupt():
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)
        timer = threading.Timer(0.5, interrupt)
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            work()
        return time.monotonic() - sent[0]

    def test_interrupt_a_push(self):
        self.assertLess(self.interrupted(lambda: drystone.push(WALL, set=LONG)), 5.0)
        self.assertFalse(drystone.push(WALL, set=CHEAP).failed)

    def test_interrupt_a_study(self):
        study = drystone.Study(QUICK, set={**CHEAP, "uq.samples": 5000, "uq.design": "monte_carlo"})
        file = self.folder / "study.h5"
        self.interrupted(lambda: study.run(file))
        results = drystone.open(file)
        self.assertEqual(results.missing, 15000 - len(results))
        self.assertTrue(0 < len(results) < 15000)

    def test_other_threads_run(self):
        turns, over = 0, threading.Event()

        def push():
            try:
                drystone.push(WALL, set={**CHEAP, "solver.steps_per_mm": 2000})
            finally:
                over.set()
        worker = threading.Thread(target=push)
        worker.start()
        while not over.wait(1e-3):
            turns += 1
        worker.join()
        self.assertGreater(turns, 20)

    def test_one_thread_uses_hdf5(self):
        study, file = drystone.Study(QUICK, set=STUDY), self.folder / "study.h5"
        refused = []

        def look(done, failed, all):
            def other():
                try:
                    drystone.open(file)
                except RuntimeError as error:
                    refused.append(str(error))
            if done == 3:
                self.assertEqual(drystone.open(file).missing + len(drystone.open(file)), 18)
                thread = threading.Thread(target=other)
                thread.start()
                thread.join()
        study.run(file, progress=look)
        self.assertEqual(len(refused), 1)
        self.assertIn("HDF5 serves one thread", refused[0])


unittest.main()
