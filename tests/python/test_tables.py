# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables over numpy arrays."""

import gc
import pickle
import tempfile
import unittest
import warnings
from pathlib import Path

import numpy

import axiscomp


def plane():
    """values[i, j] = i + 10 j um, which trilinear lookup gives back everywhere."""
    values = numpy.add.outer(numpy.arange(3), 10 * numpy.arange(4)) * 1e-3
    return axiscomp.Table(
        values, [(0, 5, "mm", "X"), (-30, 20, "mm", "Y")], name="X error", unit="mm", target="X"
    )


class Tables(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_values_are_the_tables_own_memory(self):
        table = plane()
        self.assertEqual(table.values.shape, (3, 4))
        self.assertEqual(table.values.dtype, numpy.float32)
        self.assertEqual(table.values.__array_interface__["data"][0], table.values.__array_interface__["data"][0])
        self.assertFalse(table.values.flags.owndata)
        numpy.testing.assert_array_equal(table.values[2], numpy.float32([0.002, 0.012, 0.022, 0.032]))

    def test_nobody_writes_to_a_table(self):
        with self.assertRaises(ValueError):
            plane().values[0, 0] = 1

    def test_values_outlive_the_name_of_their_table(self):
        values = plane().values
        gc.collect()
        self.assertEqual(values[2, 3], numpy.float32(0.032))

    def test_lookup_takes_arrays_of_any_shape(self):
        table = plane()
        positions = numpy.array([[[0, -30], [2.5, -20]], [[10, 30], [99, 99]]])
        answer = table.lookup(positions)
        self.assertEqual(answer.shape, (2, 2))
        numpy.testing.assert_allclose(answer, [[0, 0.0055], [0.032, 0.032]], atol=1e-8)
        line = axiscomp.Table([0, 0.002], [(0, 10, "mm")], unit="mm")
        self.assertAlmostEqual(float(line.lookup(2.5)), 0.0005)
        numpy.testing.assert_allclose(line.lookup([0, 5, 10], outside="zero"), [0, 0.001, 0.002])
        self.assertTrue(numpy.isnan(line.lookup([11], outside="error"))[0])
        with self.assertRaises(ValueError):
            table.lookup([1, 2, 3])
        with self.assertRaises(ValueError):
            line.lookup([1], outside="nearest")

    def test_nothing_is_looked_up_at_a_masked_position(self):
        line = axiscomp.Table([0, 0.002], [(0, 10, "mm")], unit="mm")
        for positions in (numpy.ma.array([2.5, 5], mask=[False, True]), [numpy.ma.array([5], mask=[True])]):
            with self.assertRaisesRegex(ValueError, "masked"):
                line.lookup(positions)
        numpy.testing.assert_allclose(line.lookup(numpy.ma.array([5.0], mask=[False])), [0.001], atol=1e-8)

    def test_a_target_is_a_dimension_of_the_table(self):
        for target in ("#2", "#3"):
            with self.assertRaisesRegex(ValueError, "target " + target):
                axiscomp.Table([0, 0.002], [(0, 10, "mm")], unit="mm", target=target)
        self.assertEqual(axiscomp.Table([0, 0.002], [(0, 10, "mm")], unit="mm", target="#1").target, "#1")

    def test_a_name_says_the_target_as_in_a_file(self):
        table = axiscomp.Table([0, 0.002], [(0, 10, "mm", "X")], name="Y error", unit="mm")
        self.assertEqual(table.target, "Y")
        same = axiscomp.resample(table, points=2)
        self.assertEqual((same, same.notes), (table, []))
        self.assertEqual(axiscomp.Table([0, 1], [(0, 1, "mm")], name="Y error").target, "")

    def test_a_text_is_one_line(self):
        axes = [(0, 10, "mm", "X")]
        for words in (
            {"target": "X\n// lookup: set"},
            {"name": "X\r"},
            {"unit": "mm\t"},
            {"notes": ["a", "b\nlookup: set"]},
            {"axes": [(0, 10, "mm", "X\0")]},
            {"axes": [(0, 10, "mm\n", "X")]},
        ):
            with self.assertRaisesRegex(ValueError, "control character", msg=str(words)):
                axiscomp.Table([0, 0.002], **{"axes": axes, **words})

    def test_tables_of_one_file_are_looked_up_at_the_same_side(self):
        axes = [(0, 10, "mm", "X")]
        one, other = (
            axiscomp.Table([0, 0.002], axes, name=name, unit="mm", target="X", notes=notes)
            for name, notes in (("A", []), ("S", ["lookup: set"]))
        )
        file = self.folder / "x.csv"
        for tables in ([one, other], [other, one]):
            with self.assertRaisesRegex(ValueError, "lookup: encoder, lookup: set, or nothing"):
                axiscomp.write(tables, file)
        measured = axiscomp.Table(one.values, axes, "M", "mm", "X", notes=["drive: Mill, serial number 7"])
        with self.assertRaisesRegex(ValueError, "drive: NAME, serial number N, or nothing"):
            axiscomp.write([one, measured], file)
        self.assertFalse(file.exists())
        axiscomp.write([other, axiscomp.Table(other.values, axes, "T", "mm", "X", notes=["a", "Lookup: set"])], file)
        self.assertEqual(len(axiscomp.read_all(file, dims=1)), 2)

    def test_positions_are_those_of_the_grid(self):
        numpy.testing.assert_array_equal(plane().positions(2), [-30, -10, 10, 30])
        with self.assertRaises(IndexError):
            plane().positions(3)

    def test_a_table_is_made_over_the_axes_of_another_one(self):
        one = plane()
        other = axiscomp.Table(one.values * 2, one.axes)
        self.assertEqual(other.axes, one.axes)
        self.assertEqual(axiscomp.Table([0, 1], [axiscomp.Axis(5, 2, "mm", "X")]).axes, [(5, 2, "mm", "X", 2)])
        with self.assertRaisesRegex(ValueError, "has 3 points, and there are 2 values along it"):
            axiscomp.Table([0, 1], [axiscomp.Axis(5, 2, size=3)])

    def test_what_is_no_number_of_an_axis_is_named(self):
        for axis in (("0", 1), (0, None), (0, 1, 2), (0, 1, "mm", "X", "two")):
            with self.assertRaisesRegex(TypeError, "start and distance of an axis are numbers"):
                axiscomp.Table([0, 1], [axis])

    def test_what_was_filled_is_said_by_indices(self):
        values, axes = [0, 0.001, 0.002, 0, 0], [(0, 10, "mm", "X")]
        mask = numpy.array([True, False, False, False, True])
        for given in ([4, 0], (0, 4, 4), numpy.flatnonzero(mask.ravel("F"))):
            table = axiscomp.Table(values, axes, "E", "mm", "X", filled=given)
            self.assertEqual(table.filled, [0, 4])
            axiscomp.write(table, self.folder / "filled.csv")
            self.assertIn("// 2 of 5 points of E are filled", (self.folder / "filled.csv").read_text())
        for given in (mask, mask.tolist(), [numpy.True_], [1.0], [numpy.float32(1)], "1"):
            with self.assertRaisesRegex(TypeError, "filled has indices of points", msg=repr(given)):
                axiscomp.Table(values, axes, filled=given)
        for given in ([5], [-1], [2**70]):
            with self.assertRaisesRegex(ValueError, "beyond the table", msg=repr(given)):
                axiscomp.Table(values, axes, filled=given)

    def test_a_table_keeps_the_rules_of_a_table(self):
        for values, axes in (
            ([0, float("nan")], [(0, 1)]),
            ([0, 1], [(0, 0)]),
            ([0, 1], [(0, -1)]),
            ([0], [(0, 1)]),
        ):
            with self.assertRaises(axiscomp.Error) as raised:
                axiscomp.Table(values, axes)
            self.assertEqual(raised.exception.code, "InvalidArgument")
        for values, axes in (([0, 1], [(0, 1), (0, 1)]), ([0, 1], [(0,)]), (numpy.zeros((2, 2, 2, 2)), [(0, 1)] * 4)):
            with self.assertRaises(ValueError):
                axiscomp.Table(values, axes)

    def test_values_of_any_layout_are_taken_as_they_stand(self):
        values = numpy.arange(24.0).reshape(4, 6)
        axes = [(0, 1, "mm"), (0, 1, "mm")]
        for given in (values, numpy.asfortranarray(values), values.astype(">f8"), values.astype(int), values.tolist()):
            numpy.testing.assert_array_equal(axiscomp.Table(given, axes).values, values)
        numpy.testing.assert_array_equal(axiscomp.Table(values[::2, ::-3], axes).values, values[::2, ::-3])
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # none of numpy
            with self.assertRaisesRegex(axiscomp.RequestError, r"value 2 is 1e\+39, which is beyond .* float32"):
                axiscomp.Table([0, 1e39], [(0, 1)])
            with self.assertRaisesRegex(axiscomp.RequestError, "value 2 is inf, a finite number is needed"):
                axiscomp.Table([0, float("inf")], [(0, 1)])
        with self.assertRaises(ValueError):
            axiscomp.Table(numpy.ma.masked_equal([0, 999], 999), [(0, 1)])
        with self.assertRaises(ValueError):
            axiscomp.Table([numpy.ma.masked_equal([1, 999], 999), numpy.ma.array([2, 3])], [(0, 1), (0, 1)])
        for given in (None, [], "x", [[0, 1], [2]]):
            with self.assertRaises((ValueError, TypeError), msg=repr(given)):
                axiscomp.Table(given, [(0, 1)])

    def test_numbers_are_real(self):
        axes = [(0, 1, "mm")]
        line = axiscomp.Table([0, 1], axes)
        for given in ([0, 1j], numpy.array([0, 1 + 0j]), numpy.array(["2026-01-01", "2026-01-02"], "M8[s]")):
            with self.assertRaises(TypeError, msg=repr(given)):
                axiscomp.Table(given, axes)
            with self.assertRaises(TypeError, msg=repr(given)):
                line.lookup(given)

    def test_tables_for_two_sides_are_not_equal(self):
        (encoder, same, other, none) = (
            axiscomp.Table([0, 1], [(0, 1, "mm")], notes=notes)
            for notes in (["lookup: encoder"], ["a note", "lookup: encoder"], ["lookup: set"], [])
        )
        self.assertEqual(encoder, same)
        self.assertNotEqual(encoder, other)
        self.assertNotEqual(encoder, none)

    def test_each_position_of_a_file_has_its_result(self):
        table = axiscomp.Table([0, 0.001, 0.003], [(0, 10, "mm", "X")], unit="mm", target="X")
        positions = self.folder / "positions.txt"
        positions.write_text("5\n7\n15\n")
        for options in ({}, {"as_": "csv"}):
            results = axiscomp.lookup(table, points=positions, **options)["results"]
            self.assertEqual([result["position"] for result in results], [[5], [7], [15]])
            numpy.testing.assert_allclose(
                [result["value"] for result in results], table.lookup([5, 7, 15]), atol=1e-9
            )

    def test_what_is_written_reads_back(self):
        for name in ("plane.csv", "plane.TAMtbl"):
            file = self.folder / name
            document = axiscomp.write(plane(), file)
            self.assertEqual(document["output"], str(file))
            read = axiscomp.read(file, **({"dims": 2} if name.endswith("csv") else {}))
            numpy.testing.assert_array_equal(read.values, plane().values)
            self.assertEqual([axis[:2] for axis in read.axes], [(0.0, 5.0), (-30.0, 20.0)])
            if name.endswith("csv"):
                self.assertEqual(read, plane())

    def test_several_tables_stand_in_one_file(self):
        other = axiscomp.Table(-plane().values, plane().axes, name="Y error", unit="mm", target="Y")
        file = self.folder / "both.csv"
        axiscomp.write([plane(), other], file)
        self.assertEqual(axiscomp.read_all(file, dims=2), [plane(), other])
        self.assertEqual(axiscomp.read(file, dims=2, table="Y error"), other)
        with self.assertRaises(axiscomp.Error):
            axiscomp.read(file, dims=2)

    def test_a_large_correction_is_refused_until_it_is_accepted(self):
        table = axiscomp.Table([0, 1, 0], [(0, 10, "mm")], unit="mm")
        file = self.folder / "x.TAMtbl"
        with self.assertRaises(axiscomp.RequestError) as raised:
            axiscomp.write(table, file)
        self.assertEqual(raised.exception.code, "LargeCorrection")
        self.assertIn("reason", raised.exception.context)
        self.assertFalse(file.exists())
        document = axiscomp.write(table, file, accept_large=True)
        self.assertTrue(any("10 %" in note or "5 %" in note for note in document.notes), document.notes)

    def test_tables_of_other_controllers_are_converted(self):
        # LinuxCNC subtracts what its file says from the command: nominal, forward, reverse.
        file = self.folder / "x.comp"
        table = axiscomp.Table([0, 0.002, -0.001], [(0, 10, "mm", "X")], name="X error", unit="mm", target="X")
        axiscomp.write(table, file, to="linuxcnc")
        back = axiscomp.read(file, from_="linuxcnc", target="#1")
        numpy.testing.assert_allclose(back.lookup([0, 10, 20]), table.lookup([0, 10, 20]), atol=2e-5)

    def test_what_a_file_leaves_open_is_a_warning(self):
        file = self.folder / "x.comp"
        file.write_text("".join(f"{x} {x * 1.0001 + 0.001} {x * 1.0001 + 0.001}\n" for x in (0, 10, 20, 30)))
        for read in (axiscomp.read, axiscomp.read_all):
            with self.assertWarns(axiscomp.FileWarning) as warned:
                read(file, target="#1")
            self.assertEqual(warned.filename, __file__)
            said = "\n".join(str(one.message) for one in warned.warnings)
            for code in ("(Assumption)", "(UnitNotGiven)"):
                self.assertIn(code, said)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            plain = axiscomp.Table([0.001, 0.001], [(0, 10, "mm", "X")], unit="mm")  # of which a file would get one
            axiscomp.write(plain, self.folder / "x.csv")
            axiscomp.resample(plain, points=3)

    def test_the_unit_of_the_values_is_stated_and_not_ignored(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "x.csv"
            file.write_text("X [mm],X error\n0,1\n10,2\n")
            stated = axiscomp.read(file, dims=1, set_in={"value-unit": "um"})
            self.assertEqual((stated.unit, list(stated.values)), ("um", [1, 2]))
            for act in (
                lambda: axiscomp.read(file, dims=1, value_unit="um"),
                lambda: axiscomp.read_all(file, dims=1, value_unit="um"),
                lambda: axiscomp.resample(stated, points=3, value_unit="mm"),
            ):
                with self.assertRaisesRegex(axiscomp.RequestError, "--set-in value-unit"):
                    act()

    def test_a_table_is_resampled(self):
        table = axiscomp.Table([0, 0.002, -0.001], [(0, 10, "mm", "X")], name="X error", unit="mm")
        dense = axiscomp.resample(table, points=5)
        numpy.testing.assert_allclose(dense.values, [0, 0.001, 0.002, 0.0005, -0.001], atol=1e-9)
        with self.assertRaises(axiscomp.Error):
            axiscomp.resample(table, points=5, distance=2)

    def test_a_unit_that_a_file_does_not_say_is_a_warning(self):
        files = {
            "open.csv": "X,X error\n0,0.001\n10,0.002\n20,0\n",
            "values.csv": "X [mm],X error\n0,0.001\n10,0.002\n20,0\n",
            "stated.csv": "X [mm],X error [um]\n0,1\n10,2\n20,0\n",
        }
        for name, content in files.items():
            (self.folder / name).write_text(content)
        axiscomp.convert(self.folder / "stated.csv", self.folder / "x.TAMtbl", dims=1)
        units = {"position-unit": "mm", "value-unit": "mm"}
        for name, options, count in (
            ("open.csv", {"dims": 1}, 2),
            ("open.csv", {"dims": 1, "points": 5}, 2),
            ("open.csv", {"dims": 1, "set_in": units}, 0),
            ("values.csv", {"dims": 1}, 1),
            ("stated.csv", {"dims": 1}, 0),
            ("x.TAMtbl", {}, 2),
            ("x.TAMtbl", {"set_in": units}, 0),
        ):
            with warnings.catch_warnings(record=True) as warned:
                warnings.simplefilter("always")
                table = axiscomp.read(self.folder / name, **options)
            said = [str(one.message) for one in warned if one.category is axiscomp.FileWarning]
            self.assertEqual(len(said), count, (name, options, said))
            self.assertTrue(all(name in one and "(UnitNotGiven)" in one for one in said), said)
            self.assertEqual(count, [table.unit, table.axes[0].unit].count(""))
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # a table that Python has made is of no file
            axiscomp.resample(axiscomp.Table([0, 0.001, 0], [(0, 10)]), points=5)

    def test_the_end_of_a_table_that_is_lost_is_a_warning(self):
        table = axiscomp.Table([0, 0.001, 0.005], [(-5, 10, "mm", "X")], name="X error", unit="mm", target="X")
        file = self.folder / "x.csv"
        axiscomp.write(table, file)
        said = "the grid ends at 13 mm, 2 mm before its end"
        for act in (
            lambda: axiscomp.resample(table, distance=3),
            lambda: axiscomp.read(file, dims=1, distance=3),
            lambda: axiscomp.read_all([table], distance=3)[0],
        ):
            with self.assertWarnsRegex(axiscomp.FileWarning, said) as warned:
                self.assertEqual(act().axes[0].last, 13)
            self.assertEqual((warned.filename, len(warned.warnings)), (__file__, 1))
        document = axiscomp.write(table, self.folder / "y.csv", distance=3)
        self.assertTrue(any(note.startswith("warning: ") and said in note for note in document.notes), document.notes)
        self.assertNotIn(said, document.text)
        self.assertTrue(any(said in line for line in document["report"]))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(axiscomp.resample(table, distance=3, hold=True).axes[0].last, 16)
            axiscomp.resample(table, distance=5)
            axiscomp.resample(table, within=0.001)

    def test_all_tables_are_read_whatever_is_changed(self):
        file = self.folder / "two.csv"
        file.write_text("// lookup: set\nX [mm],X error [um],Y error [um]\n0,0,0\n10,1,100\n20,2,200\n")
        for options in (
            {"points": 5},
            {"distance": 5},
            {"within": 1},
            {"offset": 1},
            {"zero": 10},
            {"scale": 2},
            {"target": ["#1", "Y"]},
            {"sign": "command", "target": ["#1", "Y"]},
        ):
            tables = axiscomp.read_all(file, dims=1, **options)
            self.assertEqual([table.name for table in tables], ["X error", "Y error"], options)
            with self.assertRaisesRegex(axiscomp.RequestError, "there are 2 tables", msg=repr(options)):
                axiscomp.read(file, dims=1, **options)
        with self.assertRaisesRegex(axiscomp.RequestError, "there are 2 tables"):
            axiscomp.resample(axiscomp.read_all(file, dims=1), points=5)
        second = axiscomp.read(file, dims=1, scale=2, table="Y error")
        numpy.testing.assert_allclose(second.values, [0, 200, 400])

    def test_all_tables_of_a_file_of_another_controller_are_read(self):
        axes = [(0, 10, "mm", "X"), (0, 10, "mm", "Y")]
        tables = [
            axiscomp.Table([[0, size], [size, 0]], axes, name=f"{axis} error", unit="mm", target=axis)
            for axis, size in (("X", 0.001), ("Y", 0.002), ("Z", 0.003))
        ]
        file = self.folder / "x.kgeo"
        axiscomp.write(tables, file, to="kmotion-geo")
        read = axiscomp.read_all(file, from_="kmotion-geo")
        self.assertEqual([(table.name, table.unit) for table in read], [(axis, "inch") for axis in "XYZ"])
        numpy.testing.assert_allclose(25.4 * read[2].values, tables[2].values, atol=1e-6)

    def test_tables_over_different_positions_are_read_one_after_the_other(self):
        file = self.folder / "x.mpf"
        lines = []
        for axis, distance, values in (("X1", 50, [0, 0.001, 0.002]), ("Y1", 30, [0, 0.003]), ("A1", 90, [0, 0.004, 0])):
            lines += [f"$AA_ENC_COMP[0,{n},{axis}]={value}\n" for n, value in enumerate(values)]
            end = distance * (len(values) - 1)
            for name, number in (("STEP", distance), ("MIN", 0), ("MAX", end), ("IS_MODULO", 0)):
                lines.append(f"$AA_ENC_COMP_{name}[0,{axis}]={number}\n")
        file.write_text("%_N_AX_EEC_INI\nCHANDATA(1)\n" + "".join(lines) + "M17\n")
        options = {"from_": "siemens-eec", "sign": "feedback"}
        with warnings.catch_warnings(record=True) as warned:
            warnings.simplefilter("always")
            tables = axiscomp.read_all(file, **options)
        said = [str(one.message) for one in warned]
        self.assertEqual(len(said), len(set(said)), said)
        self.assertEqual([len(table.values) for table in tables], [3, 2, 3])
        self.assertEqual([table.axes[0].last for table in tables], [100, 30, 180])
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", axiscomp.FileWarning)
            self.assertEqual(axiscomp.read_all(file, table=[3, 1], **options), [tables[2], tables[0]])
            self.assertEqual(axiscomp.read(file, table=2, **options), tables[1])
            with self.assertRaisesRegex(axiscomp.RequestError, "has 3 tables: choose one with --table: 1 ") as raised:
                axiscomp.read(file, **options)
            self.assertEqual(raised.exception.context["tables"], 3)
            with self.assertRaisesRegex(axiscomp.RequestError, "choose one"):
                axiscomp.read_all(file, name="E", **options)
            with self.assertRaisesRegex(axiscomp.Error, "TableNotFound"):
                axiscomp.read_all(file, table=[1, 4], **options)

    def test_what_was_filled_is_known_while_the_points_stay(self):
        file = self.folder / "gaps.csv"
        file.write_text("X [mm],a [um],b [um]\n0,1,1\n10,,2\n20,3,\n30,4,4\n")
        for options in ({}, {"scale": 2}, {"points": 4}, {"target": "#1"}):
            tables = axiscomp.read_all(file, dims=1, fill="nearest", **options)
            self.assertEqual([table.filled for table in tables], [[1], [2]], options)
        tables = axiscomp.read_all(file, dims=1, fill="nearest", points=7)
        self.assertEqual([table.filled for table in tables], [[], []])

    def test_what_was_filled_of_a_table_is_known_while_the_points_stay(self):
        table = axiscomp.Table([0, 0.002, 0.001], [(0, 10, "mm", "X")], name="E", unit="mm", filled=[1])
        other = axiscomp.Table([0, 0.001, 0.001], [(0, 10, "mm", "X")], name="F", unit="mm")
        for options, filled in (({}, [1]), ({"points": 3}, [1]), ({"scale": 2}, [1]), ({"points": 5}, [])):
            self.assertEqual(axiscomp.resample(table, **options).filled, filled, options)
        self.assertEqual([one.filled for one in axiscomp.read_all([other, table], scale=2)], [[], [1]])
        self.assertEqual(axiscomp.read([other, table], scale=2, table="E").filled, [1])
        self.assertEqual([one.filled for one in axiscomp.read_all([other, table], table=["E", 1])], [[1], []])
        file = self.folder / "filled.csv"
        axiscomp.write([other, table], file)
        note = "1 of 3 points of E are filled, not measured"
        self.assertIn(f"// {note}\n", file.read_text())
        (_, again) = axiscomp.read_all(file, dims=1)
        self.assertEqual(again.notes, [note])
        axiscomp.write(axiscomp.Table(again.values, [(0, 10, "mm", "X")], "E", "mm", filled=[1], notes=again.notes), file)
        self.assertEqual(file.read_text().count(note), 1)

    def test_missing_points_are_filled_only_on_demand(self):
        file = self.folder / "gap.csv"
        file.write_text("X [mm],E [mm]\n0,0.001\n10,\n20,0.003\n")
        with self.assertRaises(axiscomp.InputFileError) as raised:
            axiscomp.read(file, dims=1)
        self.assertEqual(raised.exception.code, "InvalidCalibration")
        self.assertEqual(raised.exception.diagnostics[0]["line"], 3)
        table = axiscomp.read(file, dims=1, fill="plane")
        self.assertEqual(table.filled, [1])
        self.assertAlmostEqual(float(table.values[1]), 0.002, places=6)

    def test_what_was_never_made_is_an_error(self):
        names = ("values", "axes", "name", "unit", "target", "dimensions", "filled", "notes", "crc")
        acts = [lambda given, name=name: getattr(axiscomp.Table, name).fget(given) for name in names]
        acts += [
            axiscomp.Table.positions,
            lambda given: axiscomp.Table.lookup(given, [0]),
            axiscomp.Table.__repr__,
            axiscomp.Table.__reduce__,
            lambda given: axiscomp._axiscomp.csv_of_tables([given]),
            lambda given: axiscomp._axiscomp.csv_of_tables([plane(), given]),
            lambda given: axiscomp.write([plane(), given], self.folder / "x.csv"),
        ]
        for given in (axiscomp.Table.__new__(axiscomp.Table), None, 5):
            for act in acts:
                with self.assertRaises((TypeError, RuntimeError), msg=repr(type(given))):
                    act(given)
        with self.assertRaisesRegex(TypeError, "never initialised"):
            plane() == axiscomp.Table.__new__(axiscomp.Table)
        readings = axiscomp._axiscomp.Readings.__new__(axiscomp._axiscomp.Readings)
        for act in (readings.next, readings.stop, lambda: readings.missed):
            with self.assertRaisesRegex(TypeError, "never initialised"):
                act()
        for dimensions in (0, 4, -1):
            with self.assertRaises(ValueError):
                axiscomp._axiscomp.tables_of_csv(b"X,e\n0,1\n1,2\n", dimensions)

    def test_a_table_goes_through_pickle(self):
        table = plane()
        self.assertEqual(pickle.loads(pickle.dumps(table)), table)
        self.assertEqual(table.crc, pickle.loads(pickle.dumps(table)).crc)


if __name__ == "__main__":
    unittest.main()
