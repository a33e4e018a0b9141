# SPDX-License-Identifier: GPL-3.0-or-later
"""The functions of the commands, and errors."""

import contextlib
import io
import json
import os
import shutil
import subprocess
import sys
import tempfile
import textwrap
import threading
import time
import unittest
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy

import axiscomp
from axiscomp import commands

SOURCE = Path(os.environ["AXISCOMP_SOURCE"])
RUNS = SOURCE / "tests/data/metrology/b02_x.csv"


def program(*arguments):
    environment = {key: value for key, value in os.environ.items() if key != "LD_PRELOAD"}
    return subprocess.run(
        [os.environ["AXISCOMP_PROGRAM"], *map(str, arguments)], capture_output=True, env=environment, check=False
    )


class Commands(unittest.TestCase):
    def test_the_functions_are_those_of_the_command_line(self):
        made = subprocess.run(
            [sys.executable, "-P", SOURCE / "app/python/make_commands.py"], capture_output=True, text=True, check=True
        )
        self.assertEqual(made.stdout, (SOURCE / "app/python/axiscomp/commands.py").read_text())

    def test_what_is_no_number_is_an_error_with_a_code(self):
        for option in ("home", "turn", "gain"):
            for value in (float("nan"), numpy.float64("inf")):
                with self.assertRaises(axiscomp.RequestError, msg=option) as raised:
                    axiscomp.fit(RUNS, lookup_at="encoder", measured_with="off", **{option: value})
                self.assertEqual(raised.exception.code, "InvalidArgument")

    def test_a_document_is_that_of_json(self):
        document = axiscomp.judge(RUNS, tolerance={"A": "10um"})
        said = program("judge", RUNS, "--tolerance", "A=10um", "--json")
        self.assertEqual(json.dumps(document), json.dumps(json.loads(said.stdout)))
        self.assertEqual((document.outcome, document.ok, said.returncode), ("ToleranceNotMet", False, 8))

    def test_the_example_of_the_page_runs_as_it_is_printed(self):
        page = (SOURCE / "docs/python.md").read_text()
        example = page.split("\n## Commands\n")[1].split("\n| ")[0]
        self.assertIn("axiscomp.judge(\"x.rtl\"", example)
        names = {}
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
            shutil.copy(RUNS, f"{folder}/x.csv")
            with contextlib.chdir(folder):
                exec(textwrap.dedent(example).replace("x.rtl", "x.csv"), names)
        self.assertEqual(names["judged"].outcome, "ToleranceNotMet")
        self.assertIs(names["judged"].ok, False)

    def test_the_text_is_that_of_the_command_line(self):
        self.assertEqual(axiscomp.judge(RUNS).text.encode(), program("judge", RUNS).stdout)

    def test_an_error_has_code_context_and_sentence(self):
        with self.assertRaises(axiscomp.InputFileError) as raised:
            axiscomp.judge("/nowhere/x.csv")
        error = raised.exception
        said = json.loads(program("judge", "/nowhere/x.csv", "--json").stdout)["error"]
        self.assertEqual(error.code, "FileNotReadable")
        self.assertEqual(error.message, said["message"])
        self.assertEqual(error.context, said["context"])
        self.assertIsInstance(error, ValueError)

    def test_a_misspelt_option_is_an_error_of_python(self):
        with self.assertRaises(TypeError):
            axiscomp.judge(RUNS, tolerances="A=10um")
        with self.assertRaises(axiscomp.RequestError) as raised:
            axiscomp.judge(RUNS, outliers="all")
        self.assertEqual(raised.exception.code, "InvalidArgument")

    def test_values_of_numpy_are_those_of_python(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "x.csv"
            axiscomp.example(dims=numpy.int64(1), tables=numpy.float64(1), output=numpy.str_(file))
            self.assertEqual(len(axiscomp.read_all(file, dims=1)), 1)
        words = axiscomp._call._words
        self.assertEqual(words("axis", numpy.str_("1e3"), None), ["--axis=1e3"])
        self.assertEqual(words("accept_large", numpy.bool_(True), None), ["--accept-large"])
        self.assertEqual(words("accept_large", numpy.bool_(False), None), [])
        self.assertEqual(words("points", numpy.array([9, 5]), None), ["--points=9,5"])
        for value in (b"x.csv", numpy.zeros((2, 2)), [[1, 2]]):
            with self.assertRaises(TypeError, msg=repr(value)):
                words("points", value, None)
        with self.assertRaises(ValueError):
            axiscomp.example(dims=1, output="x.csv\0.txt")

    def test_only_texts_numbers_and_paths_are_values(self):
        words = axiscomp._call._words
        for value, text in (
            ("mm", "mm"),
            (5, "5"),
            (0.1, "0.1"),
            (2.0, "2"),
            (Decimal("0.10"), "0.10"),
            (numpy.float64(0.1), "0.1"),
            (numpy.int8(3), "3"),
            (Path("a/b"), "a/b"),
        ):
            self.assertEqual(words("target", value, None), ["--target=" + text])
            self.assertEqual(words("target", [value], None), ["--target=" + text])
            self.assertEqual(words("set_in", {"key": value}, None), ["--set-in=key=" + text])
        no_values = (object(), {"#1"}, range(2), Fraction(1, 3), 1j, b"x", numpy.ma.masked, numpy.datetime64("2024-01-01"))
        for value in (*no_values, (name for name in ["#1"])):
            with self.assertRaises(TypeError, msg=repr(value)):
                words("target", value, None)
        for value in (None, True, *no_values):
            for given in ([value], {"key": value}):
                with self.assertRaises(TypeError, msg=repr(given)):
                    words("target", given, None)

    def test_what_states_nothing_decides_nothing(self):
        table = axiscomp.Table([0, 0.05, 0.02, -0.04, 0], [(0, 25, "mm", "X")], name="e", unit="mm")
        for target in ([None], (name for name in ["#1"])):
            with self.assertRaises(TypeError):
                axiscomp.read(table, target=target, to_sign="command")

    def test_none_among_files_is_no_file(self):
        with self.assertRaises(TypeError):
            axiscomp.judge(RUNS, None)
        with self.assertRaises(TypeError):
            axiscomp.read_measurement([RUNS, None])

    def test_true_and_false_are_for_options_without_a_value(self):
        with tempfile.TemporaryDirectory() as folder:
            files = [Path(folder) / name for name in ("a.csv", "b.csv")]
            for file in files:
                file.write_bytes(RUNS.read_bytes())
            for value in (True, False, numpy.bool_(True)):
                with self.assertRaisesRegex(TypeError, "output takes a value"):
                    axiscomp.runs(*files, output=value)
            self.assertEqual(files[0].read_bytes(), RUNS.read_bytes())
        with self.assertRaises(axiscomp.RequestError):  # of no command: the command line says so
            axiscomp._call.call("judge", [RUNS], {"vdj": True})

    def test_no_option_has_a_value_in_one_command_only(self):
        options = [o for command in axiscomp._axiscomp.commands() for o in command["options"] if not o["positional"]]
        with_value, without = (
            {name for o in options if o["takes_value"] is takes for name in o["names"]} for takes in (True, False)
        )
        self.assertIn("--output", with_value)
        self.assertEqual(with_value & without, set())

    def test_an_empty_list_is_no_option_and_an_empty_text_an_error(self):
        for nothing in ({"exclude": []}, {"exclude": numpy.array([])}, {"tolerance": {}}):
            self.assertEqual(axiscomp.judge(RUNS, **nothing), axiscomp.judge(RUNS), msg=repr(nothing))
        with tempfile.TemporaryDirectory() as folder:
            files = [Path(folder) / name for name in ("a.csv", "b.csv")]
            for file in files:
                file.write_bytes(RUNS.read_bytes())
            with self.assertRaisesRegex(axiscomp.RequestError, "--output has no value"):
                axiscomp.runs(files, output="")
            self.assertEqual(files[0].read_bytes(), RUNS.read_bytes())

    def test_an_empty_list_is_never_what_a_command_takes_without_it(self):
        for parameter, nothing in (
            ("only", []),
            ("only", ()),
            ("only", numpy.array([])),
            ("drive", []),
            ("axis", []),
            ("table", []),
            ("target", []),
            ("points", []),
            ("map", {}),
        ):
            with self.assertRaisesRegex(axiscomp.RequestError, f"^InvalidArgument: {parameter} is an empty") as raised:
                axiscomp._call.call("apply", ["machine.toml"], {parameter: nothing})
            self.assertEqual(raised.exception.code, "InvalidArgument")
        for act in (lambda: axiscomp.judge([]), lambda: axiscomp.compare(RUNS, [], record="x.axcal")):
            with self.assertRaisesRegex(axiscomp.RequestError, "an empty list is no file"):
                act()

    def test_a_file_named_as_an_option_is_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            there = os.getcwd()
            os.chdir(folder)
            self.addCleanup(os.chdir, there)
            for name in ("--json", "-5", "-.5", "--", "--output="):
                Path(name).write_bytes(RUNS.read_bytes())
                source = axiscomp.judge(name)["source"][0]
                self.assertEqual((source["file"], source["format"]), (name, "runs"))

    def test_a_position_is_a_number_or_its_text(self):
        table = axiscomp.Table([-0.002, 0, 0.002], [(-10, 10, "mm", "X")], unit="mm", target="X")
        for position in (-5, "-5", "-5.0", "-.5e1", Decimal("-5"), numpy.float64(-5), [-5], ["-5"]):
            (result,) = axiscomp.lookup(table, position)["results"]
            self.assertEqual(result["position"], [-5], repr(position))
        for text in ("-five", "--json", "--outside=zero", "--help"):
            with self.assertRaisesRegex(axiscomp.RequestError, f"such as -12.5, not {text} "):
                axiscomp.lookup(table, text)

    def test_a_lookup_takes_every_option(self):
        table = axiscomp.Table([0, 0.001, 0.003], [(0, 10, "mm", "X")], unit="mm", target="X")
        unstated = axiscomp.Table([0, 0.001, 0.003], [(0, 10, "mm", "X")])
        for given, options, value in (
            (table, {"zero": 10}, -0.0005),
            (table, {"zero": [10]}, -0.0005),
            (table, {"target": "#1"}, 0.0005),
            (table, {"target": ["#1"]}, 0.0005),
            (table, {"set_in": {"value-unit": "mm"}}, 0.0005),
            (unstated, {"set_in": {"value-unit": "um", "position-unit": "mm"}, "zero": 10}, -0.0005),
        ):
            (result,) = axiscomp.lookup(given, 5, **options)["results"]
            self.assertAlmostEqual(result["value"], value, places=9, msg=repr(options))

    def test_a_file_whose_name_is_not_utf8_is_read_and_written(self):
        with tempfile.TemporaryDirectory() as folder:
            name = os.fsencode(folder) + b"/Fr\xe4se.csv"
            for file in (os.fsdecode(name), Path(os.fsdecode(name))):
                axiscomp.example(dims=1, tables=1, output=file)
                self.assertEqual(len(axiscomp.read_all(file, dims=1)), 1)
                os.remove(name)  # the very bytes
        with self.assertRaisesRegex(ValueError, "half of a surrogate pair"):
            axiscomp.judge("\ud800.csv")

    def test_echo_hears_what_is_said(self):
        said = []
        document = axiscomp.judge(RUNS, echo=said.append)
        self.assertTrue(document.text in "".join(said))

    def test_ctrl_c_while_something_is_shown_is_raised(self):
        def echo(text):
            raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            axiscomp.judge(RUNS, echo=echo)

    def test_the_lock_is_released_while_it_works(self):
        count = 0
        done = threading.Event()

        def work():
            try:
                for _ in range(3):
                    axiscomp.judge(RUNS)
            finally:
                done.set()

        thread = threading.Thread(target=work)
        thread.start()
        while not done.is_set():
            count += 1
            time.sleep(0.0005)
        thread.join()
        self.assertGreater(count, 3)

    def test_every_option_has_a_keyword(self):
        for command in axiscomp._axiscomp.commands():
            if command["name"] != "monitor":
                self.assertTrue(callable(getattr(commands, command["name"])), command["name"])


if __name__ == "__main__":
    unittest.main()
