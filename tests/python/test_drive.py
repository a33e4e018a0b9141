# SPDX-License-Identifier: GPL-3.0-or-later
"""A drive, against a virtual drive on loopback."""

import os
import pickle
import signal
import tempfile
import threading
import time
import unittest
from unittest import mock

import numpy

import axiscomp
from axiscomp import commands
from virtual_drive import VirtualDrive

SOURCE = "Axes[0]/Signals/PathPlanner/Position"


def table(largest=0.01, unit="mm", notes=()):
    values = [0, largest, 0, -largest, 0]
    return axiscomp.Table(values, [(-100, 50, "mm", "X")], name="X error", unit=unit, target="X", notes=list(notes))


class Drives(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        # What this computer remembers of drives must not outlive the test.
        os.environ["XDG_DATA_HOME"] = os.environ["XDG_STATE_HOME"] = folder.name

    def setUp(self):
        virtual = VirtualDrive()
        self.drive = axiscomp.Drive(virtual.__enter__())
        self.addCleanup(virtual.__exit__)

    def test_a_table_is_planned_written_activated_watched_and_read(self):
        drive = self.drive
        plan = drive.plan(table(), axis="X", source1=SOURCE)
        self.assertIsNone(plan["report"])
        self.assertIsNone(drive.status("X")["table"])
        written = drive.write(table(), axis="X", source1=SOURCE)
        self.assertEqual(written["plan"], plan["plan"])
        self.assertIn("CRC", written.text)
        status = drive.status("X")
        self.assertEqual(status["table"]["crc"], table().crc)
        read = drive.read("X")
        numpy.testing.assert_array_equal(read.values, table().values)
        activated = drive.activate("X")
        self.assertEqual(activated["status"]["state"], "Active")
        with drive.monitor("X", rate=50, count=3) as readings:
            seen = list(readings)
        self.assertEqual(len(seen), 3)
        for reading in seen:
            self.assertAlmostEqual(reading["output"], float(read.lookup(reading["source1"])), places=6)
        self.assertNotEqual(drive.deactivate("X")["status"]["state"], "Active")

    def test_nothing_is_written_that_is_not_stated(self):
        with self.assertRaises(axiscomp.Error) as raised:
            self.drive.write(table(), axis="X")
        self.assertEqual(raised.exception.code, "SourceMissing")
        self.assertTrue(any("source1" in note for note in raised.exception.notes), raised.exception.notes)
        with self.assertRaises(axiscomp.Error) as raised:
            self.drive.write(table(unit="deg"), axis="X", source1=SOURCE)
        self.assertEqual(raised.exception.code, "UnitMismatch")
        other = axiscomp.Table([0, 0.01], [(0, 10, "mm", "Y")], name="E", unit="mm", target="Y")
        with self.assertRaises(axiscomp.Error) as raised:
            self.drive.write(other, axis="X", source1=SOURCE)
        self.assertEqual(raised.exception.code, "TargetMismatch")
        self.assertIsNone(self.drive.status("X")["table"])

    def test_data_without_a_table_is_an_error(self):
        for data in ([], (), numpy.array([]), numpy.array([0, 0.01]), [table(), None]):
            with self.assertRaisesRegex(axiscomp.RequestError, "without a table", msg=repr(data)) as raised:
                self.drive.write(data, axis="X", source1=SOURCE)
            self.assertEqual(raised.exception.code, "InvalidArgument")
        self.assertFalse(any(self.drive.status("X")["sources"]))

    def test_a_table_is_not_written_for_the_other_side_of_the_compensation(self):
        line = axiscomp.Measurement(
            [0, 20, 40], up=[[0, 1e-3, 2e-3]] * 2, down=[[0, 1e-3, 2e-3]] * 2, axis="X", compensation="off"
        )
        (made,) = axiscomp.fit(line, lookup_at="set", zero="keep").tables
        for given in (made, pickle.loads(pickle.dumps(made)), axiscomp.resample(made, points=9)):
            self.assertIn("lookup: set", given.notes)
            with self.assertRaises(axiscomp.RequestError) as raised:
                self.drive.write(given, axis="X", source1="Axes[0]/Signals/PositionController/MasterPosition")
            self.assertIn("made for a position after the compensation", raised.exception.message)
        self.assertIsNone(self.drive.status("X")["table"])

    def test_a_table_is_not_written_to_another_drive_than_the_one_that_was_measured(self):
        other = table(notes=["drive: Mill, serial number 850618"])
        for given in (other, pickle.loads(pickle.dumps(other)), axiscomp.resample(other, points=9)):
            self.assertIn("drive: Mill, serial number 850618", given.notes)
            for way in (self.drive.write, self.drive.plan):
                with self.assertRaises(axiscomp.RefusedError) as raised:
                    way(given, axis="X", source1=SOURCE)
                self.assertEqual(raised.exception.code, "OtherDrive")
        self.assertIsNone(self.drive.status("X")["table"])

    def test_a_plan_writes_nothing_whatever_its_options_are(self):
        for options in ({"target": True}, {"slot": False}):
            with self.assertRaisesRegex(TypeError, "takes a value"):
                self.drive.plan(table(), axis="X", source1=SOURCE, **options)
        self.drive.plan(table(), axis="X", source1=SOURCE, dry_run=False)
        self.assertIsNone(self.drive.status("X")["table"])

    def test_a_plan_warns_of_an_end_that_is_lost(self):
        plan = self.drive.plan(table(), axis="X", source1=SOURCE, distance=30)
        self.assertTrue(any(": warning: " in note and "ends at 80 mm" in note for note in plan.notes), plan.notes)

    def test_a_plan_says_first_that_it_is_one(self):
        with mock.patch.object(axiscomp._call._axiscomp, "run", side_effect=KeyboardInterrupt) as run:
            with self.assertRaises(KeyboardInterrupt):
                self.drive.plan(table(), axis="X", source1=SOURCE)
        self.assertEqual(run.call_args.args[0][:2], [b"write", b"--dry-run"])

    def test_what_is_not_written_to_a_machine_is_an_error_with_the_document(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        serial = self.drive.axes()["drives"][0]["serialNumber"]
        axiscomp.write(table(), f"{folder.name}/x.csv")

        def machine(more=""):
            file = f"{folder.name}/machine.toml"
            with open(file, "w", encoding="utf-8") as stream:
                stream.write(
                    f'version = 1\n[[drive]]\nendpoint = "{self.drive.endpoint}"\nserial = {serial}\n'
                    f'[[drive.axis]]\naxis = "X"\nfile = "x.csv"\nsources = ["{SOURCE}"]\n{more}'
                )
            return file

        gone = '[[drive]]\nendpoint = "http://127.0.0.1:9"\nserial = 5\n[[drive.axis]]\naxis = 0\nfile = "x.csv"\n'
        file = machine(gone + f'sources = ["{SOURCE}"]\n')
        for act in (commands.apply, commands.plan):
            with self.assertRaises(axiscomp.NotConnectedError) as raised:
                act(file)
            error = pickle.loads(pickle.dumps(raised.exception))
            self.assertTrue(any("serial number 5" in note for note in error.notes), error.notes)
            self.assertEqual((error.document.outcome, error.document.ok), ("NoConnection", False))
            self.assertEqual([drive["problem"] is None for drive in error.document["drives"]], [True, False])
        self.assertIsNone(self.drive.status("X")["table"])

        for act in (commands.apply, commands.plan):  # a program has found no axis that needs its table
            with self.assertRaisesRegex(axiscomp.RequestError, "only is an empty list"):
                act(machine(), only=[])
        self.assertIsNone(self.drive.status("X")["table"])

        machine(gone + f'sources = ["{SOURCE}"]\n')
        self.assertEqual(commands.plan(file, allow_missing=True).outcome, "Differs")
        self.assertTrue(commands.apply(machine()).ok)
        self.assertTrue(commands.plan(machine()).ok)

        applied = commands.apply(machine("active = true\n"), activate=True)
        proof = applied["drives"][0]["axes"][0]["outcome"]["proof"]
        self.assertEqual(proof["proved"], not any("nothing is proved: " in note for note in applied.notes))

    def test_a_drive_that_does_not_answer_among_others_is_an_error_with_the_document(self):
        with self.assertRaises(axiscomp.NotConnectedError) as raised:
            commands.axes(drive=[self.drive.endpoint, "http://127.0.0.1:9"])
        self.assertEqual(["error" in drive for drive in raised.exception.document["drives"]], [False, True])

    def test_a_large_correction_needs_a_word(self):
        with self.assertRaises(axiscomp.RequestError) as raised:
            self.drive.write(table(10), axis="X", source1=SOURCE)
        self.assertEqual(raised.exception.code, "LargeCorrection")
        self.assertIsNone(self.drive.status("X")["table"])
        self.drive.write(table(10), axis="X", source1=SOURCE, accept_large=True)
        self.assertEqual(self.drive.status("X")["table"]["crc"], table(10).crc)

    def test_a_drive_that_is_not_there_is_an_error_of_connection(self):
        with self.assertRaises(axiscomp.NotConnectedError) as raised:
            axiscomp.Drive("http://127.0.0.1:9", timeout=2).status()
        self.assertIsInstance(raised.exception, ConnectionError)
        self.assertEqual(raised.exception.context["endpoint"], "http://127.0.0.1:9")
        with self.assertRaises(axiscomp.AddressError):
            axiscomp.Drive("nonsense:1:2").status()

    def test_a_drive_is_never_that_of_the_environment(self):
        for endpoint in (None, "", 5, ["http://127.0.0.1:9"]):
            with self.assertRaises(TypeError, msg=repr(endpoint)):
                axiscomp.Drive(endpoint)
        environment = mock.patch.dict(os.environ, {"AXISCOMP_DRIVE": self.drive.endpoint})
        environment.start()
        self.addCleanup(environment.stop)
        away = axiscomp.Drive("http://127.0.0.1:9", timeout=2)
        for ask in (
            lambda: away.status("X", drive=None),
            lambda: away.run("status", axis="X", drive=None, timeout=None),
            lambda: away.plan(table(), axis="X", source1=SOURCE, drive=None),
        ):
            with self.assertRaises(axiscomp.NotConnectedError):
                ask()
        for ask in (lambda: away.status("X", drive=[]), lambda: commands.status(axis="X", drive=[])):
            with self.assertRaisesRegex(axiscomp.RequestError, "drive is an empty list"):
                ask()

    def test_a_password_is_not_shown(self):
        for address, shown in (
            ("http://anna:geheim@127.0.0.1:21290", "http://127.0.0.1:21290"),
            ("https://anna:ge@he/im://x y@mill", "https://mill"),
            ("anna:geheim@mill", "mill"),
            ("http://mill:8080", "http://mill:8080"),
        ):
            self.assertEqual(repr(axiscomp.Drive(address)), f"<axiscomp.Drive {shown}>")
        for given in (["http://anna:geheim@mill"], {"http://anna:geheim@mill"}):
            with self.assertRaises(TypeError) as raised:
                axiscomp.Drive(given)
            self.assertNotIn("geheim", str(raised.exception))
        guarded = axiscomp.Drive("http://anna:geheim@127.0.0.1:9", timeout=2)
        for act in (
            lambda: guarded.write("k\udcff.csv", axis="X"),  # a name that is not UTF-8
            lambda: guarded.status("\ud800"),
            lambda: next(guarded.monitor("\ud800")),
            lambda: guarded.status("\udcff"),
        ):
            with self.assertRaises((axiscomp.Error, ValueError)) as raised:
                act()
            self.assertNotIn("geheim", repr(raised.exception))

    def test_the_lock_is_released_while_a_drive_is_waited_for(self):
        longest = 0.0
        done = threading.Event()

        def work():
            try:
                self.drive.write(table(), axis="X", source1=SOURCE)
            finally:
                done.set()

        thread = threading.Thread(target=work)
        began = last = time.monotonic()
        thread.start()
        while not done.is_set():
            time.sleep(0.0005)
            longest, last = max(longest, time.monotonic() - last), time.monotonic()
        thread.join()
        self.assertLess(longest, (last - began) / 2)

    def test_a_monitor_ends_with_its_block_and_is_dropped_without(self):
        with self.drive.monitor("X", rate=100) as readings:
            self.assertIn("time", next(readings))
        self.assertLess(len(list(readings)), 1000)
        forgotten = self.drive.monitor("X", rate=100)
        next(forgotten)
        del forgotten

    def test_several_threads_may_stop_a_monitor(self):
        with self.drive.monitor("X", rate=100) as readings:
            next(readings)
            threads = [threading.Thread(target=readings._readings.stop) for _ in range(4)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
        self.assertLess(len(list(readings)), 1000)

    def test_readings_are_handed_out_and_not_dropped(self):
        with self.assertRaisesRegex(axiscomp.RequestError, r"drive\.monitor\(\) gives its readings"):
            self.drive.run("monitor", axis="X", count=2)

    def test_an_error_ends_a_monitor(self):
        with self.assertRaises(axiscomp.Error) as raised:
            list(self.drive.monitor("Z"))
        self.assertEqual(raised.exception.code, "AxisNotFound")

    def test_two_drives_are_used_at_the_same_time(self):
        virtual = VirtualDrive("--name", "Other")
        other = axiscomp.Drive(virtual.__enter__())
        self.addCleanup(virtual.__exit__)
        with self.drive.monitor("X", rate=50) as first, other.monitor("X", rate=50) as second:
            for _ in range(5):
                self.assertEqual(next(first).keys(), next(second).keys())

    def test_ctrl_c_stops_and_is_raised(self):
        timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            for _ in self.drive.monitor("X", rate=10):
                pass
        timer.join()


if __name__ == "__main__":
    unittest.main()
