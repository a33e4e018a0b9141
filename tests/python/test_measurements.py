# SPDX-License-Identifier: GPL-3.0-or-later
"""From a measurement to a table and a verdict."""

import json
import os
import pickle
import tempfile
import unittest
from pathlib import Path

import numpy

import axiscomp

RUNS = Path(os.environ["AXISCOMP_SOURCE"]) / "tests/data/metrology/b02_x.csv"


def made(slope=1e-4):
    """Two runs in each direction along 0 to 40 mm, whose error is a line: the table takes all of it."""
    targets = numpy.arange(0.0, 41.0, 10.0)
    error = slope * targets
    return axiscomp.Measurement(targets, up=[error, error], down=[error, error], axis="X", compensation="off")


class Measurements(unittest.TestCase):
    def test_arrays_go_in_and_out(self):
        measurement = axiscomp.read_measurement(RUNS)
        self.assertEqual((measurement.up.shape, measurement.down.shape, measurement.unit), ((5, 9), (5, 9), "mm"))
        self.assertEqual(measurement.up[0, 0], -0.018516389956733548)
        again = axiscomp.Measurement(measurement.targets, measurement.up, measurement.down)
        numpy.testing.assert_array_equal(again.up, measurement.up)
        numpy.testing.assert_array_equal(again.down, measurement.down)

    def test_what_looks_wrong_in_a_file_is_a_warning(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "positions.csv"
            lines = "".join(f"{x},{d},1,{x + 0.001}\n" for d in "+-" for x in (0, 10, 20, 30))
            file.write_text("target [mm],direction,run,deviation [mm]\n" + lines)
            with self.assertWarnsRegex(axiscomp.FileWarning, "ValuesLookLikePositions") as warned:
                axiscomp.read_measurement(file)
            self.assertEqual(warned.filename, __file__)

    def test_what_is_left_out_is_nan(self):
        measurement = axiscomp.read_measurement(RUNS, exclude="up:1:1")
        self.assertEqual(numpy.count_nonzero(numpy.isnan(measurement.up)), 1)
        again = axiscomp.Measurement(measurement.targets, measurement.up, measurement.down)
        self.assertEqual(numpy.count_nonzero(numpy.isnan(again.up)), 1)

    def test_what_is_masked_was_not_measured(self):
        up = numpy.ma.masked_equal([[0, 1, 999], [0, 1, 2]], 999)
        measurement = axiscomp.Measurement([0, 10, 20], up=up)
        numpy.testing.assert_array_equal(measurement.up, [[0, 1, numpy.nan], [0, 1, 2]])
        with self.assertRaises(ValueError):
            axiscomp.Measurement(numpy.ma.masked_equal([0, 10, 999], 999), up=[[0, 1, 2]])

    def test_a_target_or_a_last_run_without_a_value_is_named(self):
        nan = numpy.nan
        for targets, arguments, said in (
            ([0, 10, 20.5, 30], {"up": [[0, 1, nan, 3]] * 2, "down": [[0, 1, nan, 3]]}, "target 20.5"),
            ([0, 10], {"up": [[0, 1], [nan, nan]]}, "last run of up"),
            ([0, 10], {"up": [[0, 1]], "down": [[nan, nan]]}, "last run of down"),
        ):
            with self.assertRaisesRegex(ValueError, said):
                axiscomp.Measurement(targets, **arguments)
        for exclude, said in (("target:4", "target"), ("run:up:5", "last run of up")):
            left = axiscomp.read_measurement(RUNS, exclude=exclude)
            with self.assertRaisesRegex(ValueError, said):
                axiscomp.Measurement(left.targets, left.up, left.down)
        # Here every number stays.
        kept = axiscomp.Measurement([0, 10], up=[[nan, nan], [0, nan]], down=[[nan, 1]])
        self.assertEqual((kept.targets.size, kept.up.shape, kept.down.shape), (2, (2, 2), (1, 2)))

    def test_a_statement_is_one_line(self):
        for axis in ("X\n// compensation: on", "X\r", "X\0"):
            with self.assertRaises(ValueError):
                axiscomp.Measurement([0, 10], up=[[0, 1]], axis=axis)

    def test_what_is_of_another_type_is_named(self):
        with self.assertRaisesRegex(TypeError, "^serial is a text, not 5$"):
            axiscomp.Measurement([0, 1], [[0, 0]], serial=5)
        table = axiscomp.Table([0, 1], [(0, 10, "mm", "X")], unit="um", target="X")
        with self.assertRaisesRegex(TypeError, "^turn is a number, not '360'$"):
            axiscomp.predict(made(), table, lookup_at="encoder", turn="360")

    def test_a_measurement_does_not_change(self):
        measurement = made()
        for array in (measurement.targets, measurement.up, measurement.down):
            with self.assertRaises(ValueError):
                array[0] = 5.0
        with self.assertRaises(ValueError):
            measurement.up -= 5.0
        numpy.testing.assert_array_equal(pickle.loads(pickle.dumps(measurement)).up, measurement.up)

    def test_a_measurement_is_judged_as_its_file(self):
        of_file, of_arrays = axiscomp.judge(RUNS), axiscomp.judge(axiscomp.read_measurement(RUNS))
        for document in (of_file, of_arrays):
            del document["source"], document["warnings"]
        self.assertEqual(of_file, of_arrays)

    def test_a_fit_gives_the_table_that_takes_the_error(self):
        fit = axiscomp.fit(made(), lookup_at="encoder", zero="keep")
        (table,) = fit.tables
        self.assertNotIn("/axiscomp-", "".join(table.notes))
        # What is added is reference - encoder where the encoder stands: 1e-4 of the position, the zero kept.
        numpy.testing.assert_allclose(table.lookup([0, 10, 40]), [0, 0.001, 0.004], atol=2e-6)
        self.assertLess(fit["predicted"]["E"], 1e-6)
        self.assertIsNone(fit["output"])
        self.assertNotIn("/tmp/", fit.text)

    def test_a_table_in_place_of_a_file_leaves_no_folder_behind(self):
        targets = numpy.arange(0.0, 41.0, 10.0)
        measurement = axiscomp.Measurement(targets, up=[1e-4 * targets] * 2, axis="X", compensation="on")
        active = axiscomp.Table([0, 0.002], [(0, 40, "mm", "X")], name="X error", unit="mm", target="X")
        with tempfile.TemporaryDirectory() as folder:
            options = {"lookup_at": "encoder", "measured_with": "on", "onto": active, "zero": "keep"}
            first, second = (
                axiscomp.fit(measurement, **options, record=Path(folder) / f"{n}.axcal").tables[0] for n in range(2)
            )
            self.assertIn("measured with table.csv active", "".join(first.notes))
            self.assertEqual(first.notes, second.notes)
            axiscomp.fit(measurement, **options, output=Path(folder) / "x.csv")
            for name in ("0.axcal", "x.csv"):
                self.assertNotIn("/axiscomp-", (Path(folder) / name).read_text(), name)

    def test_a_fit_says_what_was_filled(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "points.csv"
            places = [(x, y) for x in range(0, 101, 10) for y in (0, 10, 20) if x <= 40 or x == 100]
            file.write_text("X [mm],Y [mm],dX [um],dY [um]\n" + "".join(f"{x},{y},1,2\n" for x, y in places))
            fit = axiscomp.fit(
                file, points=[11, 3], smoothness=1, fill="smooth", lookup_at="encoder", measured_with="off"
            )
        for table, column in zip(fit.tables, fit["columns"]):
            self.assertEqual(len(table.filled), column["nodes"]["filled"])
            # Beyond 40 mm, where nothing is beside a point.
            numpy.testing.assert_array_less(45, table.positions(1)[numpy.array(table.filled) % 11])
            self.assertIn(f"{len(table.filled)} of 33 points of {table.name} are filled, not measured", table.notes)

    def test_a_prediction_takes_what_the_table_adds(self):
        # Twice the error: half of it is left. Looked up at the encoder, which is 1e-4 beside the target.
        table = axiscomp.Table([0, 0.002], [(0, 40, "mm", "X")], unit="mm")
        foretold = axiscomp.predict(made(), table, lookup_at="encoder")
        numpy.testing.assert_allclose(foretold.up[0], 0.5e-4 * made().targets, atol=1e-6)
        self.assertAlmostEqual(foretold.figures["E"], 0.002, places=6)
        with self.assertRaises(TypeError):
            axiscomp.judge(foretold)

    def test_a_prediction_agrees_with_that_of_the_fit(self):
        measurement = axiscomp.read_measurement(RUNS)
        fit = axiscomp.fit(measurement, lookup_at="encoder", measured_with="off")
        foretold = axiscomp.predict(measurement, fit.tables[0], lookup_at="encoder", measured_with="off")
        self.assertEqual(foretold.figures, {**foretold.figures, **fit["predicted"]})

    def test_a_prediction_without_the_table_is_the_measurement(self):
        # Measured with a table and foretold with the same one.
        table = axiscomp.Table([0, 0.002], [(0, 40, "mm", "X")], unit="mm")
        measurement = axiscomp.Measurement(made().targets, made().up, made().down)
        foretold = axiscomp.predict(measurement, table, lookup_at="encoder", measured_with=table)
        numpy.testing.assert_allclose(foretold.up, measurement.up, atol=1e-12)

    def test_a_turn_is_that_of_the_table(self):
        runs = [[0, 0.001, 0, -0.001]] * 2
        rotary = axiscomp.Measurement([0, 90, 180, 270], up=runs, down=runs, unit="deg", compensation="off")
        table = axiscomp.Table([0, 0.001, 0, -0.001, 0], [(0, 90, "deg", "A")], unit="deg")
        foretold = axiscomp.predict(rotary, table, lookup_at="encoder", turn=360)
        numpy.testing.assert_allclose(foretold.up, 0 * foretold.up, atol=1e-6)
        for turn in (180, 0, float("nan")):
            with self.assertRaises(axiscomp.RequestError) as raised:
                axiscomp.predict(rotary, table, lookup_at="encoder", turn=turn)
            self.assertIn("a turn of the axis", raised.exception.message)

    def test_a_prediction_does_not_guess(self):
        table = axiscomp.Table([0, 0.002], [(0, 40, "mm", "X")], unit="mm")
        unstated = axiscomp.Measurement(made().targets, made().up, made().down)
        with self.assertRaises(axiscomp.Error) as raised:
            axiscomp.predict(unstated, table, lookup_at="encoder")
        self.assertEqual(raised.exception.code, "MeasurementState")
        with self.assertRaises(axiscomp.Error) as raised:
            axiscomp.predict(made(), axiscomp.Table([0, 1], [(0, 1, "deg")], unit="deg"), lookup_at="encoder")
        self.assertEqual(raised.exception.code, "UnitMismatch")

    def test_a_prediction_needs_a_table(self):
        with self.assertRaises(TypeError):
            axiscomp.predict(made(), None, lookup_at="set")

    def test_a_prediction_needs_units(self):
        # Numbers in um without a unit would be mm.
        known = axiscomp.Table([0, 0.002], [(0, 40, "mm", "X")], unit="mm")
        measurement = axiscomp.Measurement(made().targets, made().up, made().down)
        for axis, unit in (((0, 40), ""), ((0, 40), "um"), ((0, 40, "mm"), "")):
            unknown = axiscomp.Table([0, 2], [axis], unit=unit)
            with self.assertRaises(axiscomp.Error) as raised:
                axiscomp.predict(made(), unknown, lookup_at="encoder")
            self.assertEqual(raised.exception.code, "UnitMismatch")
            self.assertIn("a unit that is not stated", raised.exception.message)
            with self.assertRaises(axiscomp.Error) as raised:
                axiscomp.predict(measurement, known, lookup_at="encoder", measured_with=unknown)
            self.assertEqual(raised.exception.code, "UnitMismatch")

    def test_a_prediction_is_made_with_tables_of_the_axis(self):
        other = axiscomp.Table([0, 0.002], [(0, 40, "mm", "Y")], unit="mm", target="Y")
        own = axiscomp.Table([0, 0.002], [(0, 40, "mm", "X")], unit="mm", target="X")
        measured = {"axis": "X", "compensation": "on"}
        on = axiscomp.Measurement(made().targets, made().up, made().down, **measured)
        axiscomp.predict(on, own, lookup_at="encoder", measured_with=own)
        for measurement, table, active in ((made(), other, None), (on, own, other)):
            with self.assertRaises(axiscomp.RequestError) as raised:
                axiscomp.predict(measurement, table, lookup_at="encoder", measured_with=active)
            self.assertIn("is a table over Y, but what was measured is over X", raised.exception.message)
        # Only the name says it, as in a file.
        named = axiscomp.Table([0, 0.002], [(0, 40, "mm", "X")], name="Y error", unit="mm")
        for measurement, table, active in ((made(), named, None), (on, own, named)):
            with self.assertRaises(axiscomp.RequestError) as raised:
                axiscomp.predict(measurement, table, lookup_at="encoder", measured_with=active)
            self.assertIn("axis X was measured, but", raised.exception.message)

    def test_a_fit_does_not_guess(self):
        with self.assertRaises(axiscomp.RequestError):
            axiscomp.fit(made())  # where the table is looked up is not said
        unstated = axiscomp.Measurement([0, 10, 20], up=[[0, 1e-3, 0]], down=[[0, 1e-3, 0]])
        with self.assertRaises(axiscomp.Error):
            axiscomp.fit(unstated, lookup_at="encoder")  # nor whether a table was active

    def test_a_record_is_begun_and_kept(self):
        with tempfile.TemporaryDirectory() as folder:
            record = Path(folder) / "x.axcal"
            axiscomp.fit(made(), lookup_at="encoder", zero="keep", record=record, tolerance="A=5um")
            kept = json.loads(record.read_text())["before"]["files"]
            self.assertEqual([file["file"] for file in kept], ["measurement.csv"])
            after = axiscomp.Measurement(
                made().targets, up=[0 * made().targets] * 2, down=[0 * made().targets] * 2, axis="X"
            )
            compared = axiscomp.compare(made(), after, record=record, measured_with="on", keep=True)
            self.assertTrue(compared.ok, compared.text)
            self.assertIn("after", record.read_text())

    def test_a_report_is_html(self):
        with tempfile.TemporaryDirectory() as folder:
            record, html, pdf = (Path(folder) / name for name in ("x.axcal", "x.html", "x.pdf"))
            axiscomp.fit(made(), lookup_at="encoder", zero="keep", record=record, tolerance="A=5um")
            axiscomp.report(record, output=html)
            self.assertIn("<html", html.read_text())
            # What draws PDF makes Qt's application object anew, under the hands of other threads.
            with self.assertRaises(axiscomp.Error) as raised:
                axiscomp.report(record, output=pdf)
            self.assertIn("only the program axiscomp draws PDF", str(raised.exception.context))
            self.assertFalse(pdf.exists())

    def test_the_arrays_are_checked(self):
        for arguments in (
            {"targets": [0, 0], "up": [[0, 0]]},
            {"targets": [0, 1], "up": [[0, 0, 0]]},
            {"targets": [0, 1], "up": [[0, float("inf")]]},
            {"targets": [0, 1]},
            {"targets": [0, 1], "up": [[0, 0]], "unit": "um"},
            {"targets": [0, 1], "up": [[0, 0]], "colour": "red"},
        ):
            with self.assertRaises(ValueError, msg=str(arguments)):
                axiscomp.Measurement(**arguments)

    def test_numbers_are_real(self):
        for arguments in ({"targets": [0, 10j], "up": [[0, 1]]}, {"targets": [0, 10], "up": [[0, 1j]]}):
            with self.assertRaises(TypeError):
                axiscomp.Measurement(**arguments)

    def test_what_is_wrong_is_named(self):
        with self.assertRaises(axiscomp.InputFileError) as raised:
            axiscomp.Measurement([5], [1])
        self.assertEqual([one["code"] for one in raised.exception.diagnostics], ["TooFewTargets"])

    def test_means_stay_means(self):
        with tempfile.TemporaryDirectory() as folder:
            files = [Path(folder) / name for name in ("a.pos", "b.pos")]
            for n, file in enumerate(files):
                lines = "".join(f"{x} {(x + n) * 1e-4}\n" for x in (0, 100, 200))
                file.write_text("".join(f"Position {d} Directional Avg Error\n{lines}\n" for d in ("Forward", "Reverse")))
            means = list(map(axiscomp.read_measurement, files))
            self.assertEqual([axiscomp.runs(one)["kind"] for one in (*files, *means)], ["averages"] * 4)
            self.assertEqual(means[0].kind, "averages")
            for together in (files, means):
                with self.assertRaisesRegex(axiscomp.RequestError, "only runs over targets can be joined"):
                    axiscomp.judge(together)
        again = axiscomp.Measurement(means[0].targets, means[0].up, means[0].down, kind=means[0].kind)
        self.assertIsNone(axiscomp.judge(again)["axis"]["A"])
        with self.assertRaises(axiscomp.InputFileError) as raised:
            axiscomp.Measurement([0, 10], up=[[0, 1], [0, 1]], kind="averages")
        self.assertEqual(raised.exception.diagnostics[0]["code"], "DuplicateValue")
        with self.assertRaises(ValueError):
            axiscomp.Measurement([0, 10], up=[[0, 1]], kind="means")

    def test_a_measurement_goes_through_pickle(self):
        self.assertEqual(pickle.loads(pickle.dumps(made())), made())


if __name__ == "__main__":
    unittest.main()
