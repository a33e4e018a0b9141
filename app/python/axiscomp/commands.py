# SPDX-License-Identifier: GPL-3.0-or-later
# Written by make_commands.py of the options of axiscomp.
"""Every command of axiscomp but monitor (Drive.monitor) as a function: the same words, options as keywords.

A hyphen is an underline; from and as are from_ and as_. Where a file is read, a Table (or a list of tables over the
same axes) or a Measurement may stand in its place. Options with several values take a list, KEY=VALUE a dictionary.
echo: is called with what the command says while it works, such as print. Each function raises Error, and releases the
interpreter's lock while it works.
"""

from __future__ import annotations

import os
from typing import Any, Mapping, Sequence, Union

from ._axiscomp import Table
from ._call import Document, Echo, call, call_fit, flat
from .measurements import Measurement

Value = Union[str, int, float, "os.PathLike[str]", None]
Values = Union[Value, Sequence[Any], Mapping[str, Any]]
Source = Union[str, "os.PathLike[str]", Table, Sequence[Table], Measurement]

__all__ = ["example", "inspect", "convert", "lookup", "formats", "targets", "capture", "runs", "judge", "fit",
    "compare", "report", "axes", "status", "write", "persist", "unpersist", "delete", "evaluate", "activate",
    "deactivate", "read", "files", "upload", "download", "backup", "restore", "recover", "config", "plan",
    "apply", "snapshot", "metrics", "doctor"]


def example(
    *,
    dims: Value = None,
    tables: Value = None,
    output: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Write an example calibration file (CSV).

    dims: D (required). Number of dimensions: 1, 2 or 3
    tables: N. Number of tables (2 unless given)
    output: FILE. File to write; standard output without it, or with -
    """
    return call(
        "example",
        [],
        {
            "dims": dims,
            "tables": tables,
            "output": output,
        },
        echo,
    )


def inspect(
    file: Source,
    *,
    dims: Value = None,
    from_: Value = None,
    set_in: Values = None,
    fill: Value = None,
    crop: bool = False,
    snap: Value = None,
    profile: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Check a file and report its format, grid, tables and problems.

    file: Calibration file or table; - for standard input
    dims: D. Number of dimensions of a CSV file: its first D columns are positions
    from_: FORMAT. Format of the input, if content and name leave it open
    set_in: KEY=VALUE. Setting that the file leaves open; `axiscomp formats NAME` lists them
    fill: METHOD. Give points without a value that of the nearest measured point (nearest), of the plane
        through all of them (plane), or the values that bend least (smooth)
    crop: Cut the grid to the largest part in which every point has a value
    snap: TOLERANCE. Take positions of a calibration file that are this close to the grid for grid positions,
        in their unit
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    """
    return call(
        "inspect",
        [file],
        {
            "dims": dims,
            "from_": from_,
            "set_in": set_in,
            "fill": fill,
            "crop": crop,
            "snap": snap,
            "profile": profile,
        },
        echo,
    )


def convert(
    input: Source,
    out: Value,
    *,
    dims: Value = None,
    table: Value = None,
    from_: Value = None,
    set_in: Values = None,
    fill: Value = None,
    crop: bool = False,
    snap: Value = None,
    to: Value = None,
    value_unit: Value = None,
    accept_large: bool = False,
    persistent: bool = False,
    volatile: bool = False,
    name: Value = None,
    target: Values = None,
    sign: Value = None,
    direction: Value = None,
    scale: Value = None,
    offset: Value = None,
    zero: Values = None,
    no_wrap: bool = False,
    lookup_at: Value = None,
    points: Values = None,
    distance: Values = None,
    within: Value = None,
    method: Value = None,
    speed: Value = None,
    hold: bool = False,
    to_sign: Value = None,
    set_out: Values = None,
    profile: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Convert a table file to another format.

    input: File to read; - for standard input
    out: File to write, replaced if it exists; - for standard output
    dims: D. Number of dimensions of a CSV file: its first D columns are positions
    table: TABLE. Table of the file, by name or by number from 1 (name:TEXT, #N where that could be either);
        not needed if there is only one
    from_: FORMAT. Format of the input, if content and name leave it open
    set_in: KEY=VALUE. Setting that the file leaves open; `axiscomp formats NAME` lists them
    fill: METHOD. Give points without a value that of the nearest measured point (nearest), of the plane
        through all of them (plane), or the values that bend least (smooth)
    crop: Cut the grid to the largest part in which every point has a value
    snap: TOLERANCE. Take positions of a calibration file that are this close to the grid for grid positions,
        in their unit
    to: FORMAT. Format of the output, if its name leaves it open
    value_unit: UNIT. Unit of the values in a .TAMtbl, which does not say it; by default that of the positions
    accept_large: Put corrections above 1 % of the range, or with a slope above 0.1, into a .TAMtbl
    persistent: Mark the table persistent: the drive stores it
    volatile: Mark the table volatile (without either: as the input is)
    name: TEXT. Name of the table
    target: AXIS[,AXIS]. Axis that the values correct, for each column or for all: its name, #1 for the first
        source, or other for an axis that is no source; by default as the file says
    sign: SIDE. Convention of the input: feedback (added to the encoder position) or command (added to the
        commanded position); by default that of its format, needed where that is assumed
    direction: CHOICE. Which values to use if the file has both directions of motion: mean, positive or
        negative
    scale: FACTOR. Multiply the values by this number, before anything else
    offset: VALUE. Add this to the values, in their unit
    zero: P[,P[,P]]. Shift the values so that they are 0 at this position
    no_wrap: Treat a modulo axis as a linear one
    lookup_at: WHERE. Where the drive looks its table up (the input or the output, whichever is the drive's):
        encoder (before the compensation) or set (after it); by default as the file says, or encoder
    points: N[,N[,N]]. Resample onto an even grid with N points, for each source or for all
    distance: D[,D[,D]]. Resample onto an even grid with spacing D, for each source or for all
    within: DEVIATION. Resample onto the coarsest even grid within this deviation, in the unit of the values
    method: METHOD. Between the points of the source: linear (the default), cubic (monotone), spline (natural
        cubic) or smooth (smoothing spline)
    speed: SPEED. Speed of the axis in positions per second: says the steps of the velocity that are left with
        spline and smooth
    hold: Let the even grid extend beyond the data, where the end values are held
    to_sign: SIDE. Convention of the output: feedback or command; by default that of its format, needed where
        that is assumed
    set_out: KEY=VALUE. Setting that the output format needs; `axiscomp formats NAME` lists them
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    """
    return call(
        "convert",
        [input, out],
        {
            "dims": dims,
            "table": table,
            "from_": from_,
            "set_in": set_in,
            "fill": fill,
            "crop": crop,
            "snap": snap,
            "to": to,
            "value_unit": value_unit,
            "accept_large": accept_large,
            "persistent": persistent,
            "volatile": volatile,
            "name": name,
            "target": target,
            "sign": sign,
            "direction": direction,
            "scale": scale,
            "offset": offset,
            "zero": zero,
            "no_wrap": no_wrap,
            "lookup_at": lookup_at,
            "points": points,
            "distance": distance,
            "within": within,
            "method": method,
            "speed": speed,
            "hold": hold,
            "to_sign": to_sign,
            "set_out": set_out,
            "profile": profile,
        },
        echo,
    )


def lookup(
    file: Source,
    *position: Value | Sequence[Value],
    dims: Value = None,
    table: Value = None,
    points: Value = None,
    outside: Value = None,
    as_: Value = None,
    from_: Value = None,
    set_in: Values = None,
    fill: Value = None,
    crop: bool = False,
    snap: Value = None,
    target: Values = None,
    sign: Value = None,
    direction: Value = None,
    scale: Value = None,
    offset: Value = None,
    zero: Values = None,
    no_wrap: bool = False,
    lookup_at: Value = None,
    to_sign: Value = None,
    set_out: Values = None,
    profile: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Print the interpolated value at a position, as the drive or the controller of the file computes it.

    file: Calibration file or table
    position: [X [Y [Z]]]. X [Y [Z]], one number per dimension; may be negative
    dims: D. Number of dimensions of a CSV file: its first D columns are positions
    table: TABLE. Table of the file, by name or by number from 1 (name:TEXT, #N where that could be either);
        not needed if there is only one
    points: FILE. File with one position per line, - for standard input; prints one result per line
    outside: RULE. Value outside the table: hold (as the drive does; the default), zero, wrap, extrapolate or
        error
    as_: FORMAT. Print the value that the controller of this format would apply, after conversion
    from_: FORMAT. Format of the input, if content and name leave it open
    set_in: KEY=VALUE. Setting that the file leaves open; `axiscomp formats NAME` lists them
    fill: METHOD. Give points without a value that of the nearest measured point (nearest), of the plane
        through all of them (plane), or the values that bend least (smooth)
    crop: Cut the grid to the largest part in which every point has a value
    snap: TOLERANCE. Take positions of a calibration file that are this close to the grid for grid positions,
        in their unit
    target: AXIS[,AXIS]. Axis that the values correct, for each column or for all: its name, #1 for the first
        source, or other for an axis that is no source; by default as the file says
    sign: SIDE. Convention of the input: feedback (added to the encoder position) or command (added to the
        commanded position); by default that of its format, needed where that is assumed
    direction: CHOICE. Which values to use if the file has both directions of motion: mean, positive or
        negative
    scale: FACTOR. Multiply the values by this number, before anything else
    offset: VALUE. Add this to the values, in their unit
    zero: P[,P[,P]]. Shift the values so that they are 0 at this position
    no_wrap: Treat a modulo axis as a linear one
    lookup_at: WHERE. Where the drive looks its table up (the input or the output, whichever is the drive's):
        encoder (before the compensation) or set (after it); by default as the file says, or encoder
    to_sign: SIDE. Convention of the output: feedback or command; by default that of its format, needed where
        that is assumed
    set_out: KEY=VALUE. Setting that the output format needs; `axiscomp formats NAME` lists them
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    """
    return call(
        "lookup",
        [file, *flat(position)],
        {
            "dims": dims,
            "table": table,
            "points": points,
            "outside": outside,
            "as_": as_,
            "from_": from_,
            "set_in": set_in,
            "fill": fill,
            "crop": crop,
            "snap": snap,
            "target": target,
            "sign": sign,
            "direction": direction,
            "scale": scale,
            "offset": offset,
            "zero": zero,
            "no_wrap": no_wrap,
            "lookup_at": lookup_at,
            "to_sign": to_sign,
            "set_out": set_out,
            "profile": profile,
        },
        echo,
    )


def formats(
    name: Value | None = None,
    *,
    markdown: bool = False,
    measurements: bool = False,
    echo: Echo | None = None,
) -> Document:
    """List the table formats, or describe one: its limits, rules and settings.

    name: One format: its rules, limits and settings
    markdown: All of them, as the page docs/formats.md
    measurements: The formats of measurements instead of those of tables
    """
    return call(
        "formats",
        [name],
        {
            "markdown": markdown,
            "measurements": measurements,
        },
        echo,
    )


def targets(
    *,
    from_: Value = None,
    to: Value = None,
    count: Value = None,
    spacing: Value = None,
    period: Value = None,
    cycles: Value = None,
    seed: Value = None,
    overrun: Value = None,
    feed: Value = None,
    dwell: Value = None,
    axis: Value = None,
    unit: Value = None,
    dialect: Value = None,
    output: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Choose the targets of a measurement: a plan, or a program for the machine's control.

    from_: A (required). First target
    to: B (required). Last target, above the first
    count: M. Number of targets
    spacing: P. Mean distance of targets, instead of --count
    period: P. Known period of the axis, such as the lead of its screw: targets are spread over it
    cycles: N. Runs in each direction (5 unless given)
    seed: N. Another number gives other targets, the same number the same (1 unless given)
    overrun: D. How far the axis moves in the direction of a run before its first target (1 % of the range
        unless given, at most a third of the spacing)
    feed: F. Feed in mm or deg per minute (1000 unless given)
    dwell: S. Seconds at each target (5 unless given): time to stand still and be measured
    axis: AXIS. Name of the axis (X unless given)
    unit: UNIT. Unit of all positions: mm (the default) or deg
    dialect: DIALECT. Write G-code for this control: linuxcnc, fanuc or siemens
    output: FILE. File to write; standard output without it, or with -
    """
    return call(
        "targets",
        [],
        {
            "from_": from_,
            "to": to,
            "count": count,
            "spacing": spacing,
            "period": period,
            "cycles": cycles,
            "seed": seed,
            "overrun": overrun,
            "feed": feed,
            "dwell": dwell,
            "axis": axis,
            "unit": unit,
            "dialect": dialect,
            "output": output,
        },
        echo,
    )


def capture(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    axis: Value = None,
    plan: Value = None,
    output: Value = None,
    reference: Value = None,
    unit: Value = None,
    invert_reference: bool = False,
    zero_at: Value = None,
    pattern: Value = None,
    request: Value = None,
    encoder: Value = None,
    window: Value = None,
    dwell: Value = None,
    average: Value = None,
    rate: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Take the values of a measuring plan while something else moves the axis.

    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    axis: AXIS. Index or name of the axis; not needed if the drive has only one
    plan: FILE (required). Plan as axiscomp targets writes it
    output: FILE (required). File of the values; one that is there goes on where it ends
    reference: REF (required). Where the axis really is: a register of the drive,
        serial:/dev/ttyUSB1?baud=9600, - for lines on standard input, or typed
    unit: UNIT. Unit of the instrument; of a register it is that of the axis, of lines the one behind the
        number unless given
    invert_reference: The instrument counts the other way
    zero_at: P. Position of the axis where the instrument says 0 (0 unless given)
    pattern: REGEX. Regular expression for the number in a line, its first group or all of it; the first
        number of the line unless given
    request: TEXT. Send this to the serial instrument before each reading, with \\r and \\n for line ends
    encoder: REG. Register of the raw position; the profile's unless given
    window: W. The axis stands while its encoder stays within so many mm or deg, and readings may differ by as
        much (0.001 unless given)
    dwell: S. So many seconds, before anything is taken (1 unless given)
    average: N. Readings that make a value (10 unless given)
    rate: HZ. Readings per second, 10 to 50 (20 unless given)
    """
    return call(
        "capture",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "axis": axis,
            "plan": plan,
            "output": output,
            "reference": reference,
            "unit": unit,
            "invert_reference": invert_reference,
            "zero_at": zero_at,
            "pattern": pattern,
            "request": request,
            "encoder": encoder,
            "window": window,
            "dwell": dwell,
            "average": average,
            "rate": rate,
        },
        echo,
    )


def runs(
    *file: Source | Sequence[Source],
    from_: Value = None,
    exclude: Value = None,
    swap_directions: bool = False,
    columns: Values = None,
    skip_lines: Value = None,
    unit: Value = None,
    value_unit: Value = None,
    values: Value = None,
    direction_from: Value = None,
    invert_reference: bool = False,
    overrun: Value = None,
    output: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Show what is in measurement files, join them, and write them as one CSV.

    file: Measurement files, joined when there are several; - for standard input
    from_: FORMAT. Format of the files, if their content leaves it open
    exclude: WHAT. Leave values out: down:1:1 (direction, target, run), run:up:3 or target:7, with commas
        between them
    swap_directions: Exchange up and down
    columns: MAPPING. Which column of a CSV file is what, by number or name:
        'target=1,direction=3,deviation=5'
    skip_lines: N. Lines before the header of a CSV file
    unit: UNIT. Unit of targets and encoder
    value_unit: UNIT. Unit of deviations and reference
    values: KIND. What the values are: deviation (reference minus target) or reference (positions)
    direction_from: order. order: the direction of a run follows from the order of its targets
    invert_reference: The instrument counts the other way
    overrun: DISTANCE. How far a track moves after a turn before its samples count, in mm or deg; 1 % of the
        range unless given
    output: FILE. CSV file to write, replaced if it exists; - for standard output
    """
    return call(
        "runs",
        [*flat(file)],
        {
            "from_": from_,
            "exclude": exclude,
            "swap_directions": swap_directions,
            "columns": columns,
            "skip_lines": skip_lines,
            "unit": unit,
            "value_unit": value_unit,
            "values": values,
            "direction_from": direction_from,
            "invert_reference": invert_reference,
            "overrun": overrun,
            "output": output,
        },
        echo,
    )


def judge(
    *file: Source | Sequence[Source],
    from_: Value = None,
    exclude: Value = None,
    swap_directions: bool = False,
    columns: Values = None,
    skip_lines: Value = None,
    unit: Value = None,
    value_unit: Value = None,
    values: Value = None,
    direction_from: Value = None,
    invert_reference: bool = False,
    overrun: Value = None,
    tolerance: Values = None,
    uncertainty: Value = None,
    outliers: Value = None,
    period: Value = None,
    vdi: bool = False,
    temperature: Value = None,
    expansion: Value = None,
    reference_temperature: Value = None,
    reference_expansion: Value = None,
    datum: Value = None,
    not_corrected: bool = False,
    dead_path: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Judge a measurement: figures of ISO 230-2, drift, outliers, tolerances.

    file: Measurement files, joined when there are several; - for standard input
    from_: FORMAT. Format of the files, if their content leaves it open
    exclude: WHAT. Leave values out: down:1:1 (direction, target, run), run:up:3 or target:7, with commas
        between them
    swap_directions: Exchange up and down
    columns: MAPPING. Which column of a CSV file is what, by number or name:
        'target=1,direction=3,deviation=5'
    skip_lines: N. Lines before the header of a CSV file
    unit: UNIT. Unit of targets and encoder
    value_unit: UNIT. Unit of deviations and reference
    values: KIND. What the values are: deviation (reference minus target) or reference (positions)
    direction_from: order. order: the direction of a run follows from the order of its targets
    invert_reference: The instrument counts the other way
    overrun: DISTANCE. How far a track moves after a turn before its samples count, in mm or deg; 1 % of the
        range unless given
    tolerance: FIGURE=LIMIT,.... Limits, such as A=10um,R=4um; exit code 8 when one is not met
    uncertainty: U. Uncertainty of the measurement with k = 2: U=2.1um, or a JSON file with its terms
    outliers: RULE. Rule that proposes outliers: mad (the default), grubbs or none
    period: P. Known period of the axis, such as the lead of its screw, in mm or deg
    vdi: Show the figures of VDI/DGQ 3441 as well
    temperature: C. Temperature of the axis's scale in C
    expansion: PER_K. Coefficient of expansion of the axis's scale in 1/K, such as 11.5e-6
    reference_temperature: C. Temperature of the reference in C
    reference_expansion: PER_K. Coefficient of the reference in 1/K; 0 for a laser with wavelength
        compensation
    datum: POSITION. Position in mm that does not move with temperature; the first target unless given
    not_corrected: The values are not corrected to 20 C, where the file does not say it
    dead_path: FILE. Dead path of the interferometer: a JSON file with its length and the air of each run
    """
    return call(
        "judge",
        [*flat(file)],
        {
            "from_": from_,
            "exclude": exclude,
            "swap_directions": swap_directions,
            "columns": columns,
            "skip_lines": skip_lines,
            "unit": unit,
            "value_unit": value_unit,
            "values": values,
            "direction_from": direction_from,
            "invert_reference": invert_reference,
            "overrun": overrun,
            "tolerance": tolerance,
            "uncertainty": uncertainty,
            "outliers": outliers,
            "period": period,
            "vdi": vdi,
            "temperature": temperature,
            "expansion": expansion,
            "reference_temperature": reference_temperature,
            "reference_expansion": reference_expansion,
            "datum": datum,
            "not_corrected": not_corrected,
            "dead_path": dead_path,
        },
        echo,
    )


def fit(
    *file: Source | Sequence[Source],
    from_: Value = None,
    exclude: Value = None,
    swap_directions: bool = False,
    columns: Values = None,
    skip_lines: Value = None,
    unit: Value = None,
    value_unit: Value = None,
    values: Value = None,
    direction_from: Value = None,
    invert_reference: bool = False,
    overrun: Value = None,
    output: Value = None,
    record: Value = None,
    to: Value = None,
    table: Value = None,
    accept_large: bool = False,
    target: Values = None,
    to_sign: Value = None,
    set_out: Values = None,
    tolerance: Values = None,
    uncertainty: Value = None,
    method: Value = None,
    smoothness: Value = None,
    period: Values = None,
    harmonics: Value = None,
    turn: Value = None,
    direction: Value = None,
    by: Value = None,
    points: Values = None,
    distance: Values = None,
    within: Value = None,
    hold: bool = False,
    speed: Value = None,
    zero: Value = None,
    home: Value = None,
    remove_slope: Value = None,
    remove_drift: Value = None,
    lookup_at: Value = None,
    measured_with: Source | None = None,
    onto: Source | None = None,
    gain: Value = None,
    remove: Value = None,
    fill: Value = None,
    robust: bool = False,
    temperature: Value = None,
    expansion: Value = None,
    reference_temperature: Value = None,
    reference_expansion: Value = None,
    datum: Value = None,
    not_corrected: bool = False,
    dead_path: Value = None,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    axis: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Make a compensation table of a measurement, and foretell what it does.

    file: Measurement files, joined when there are several; - for standard input
    from_: FORMAT. Format of the files, if their content leaves it open
    exclude: WHAT. Leave values out: down:1:1 (direction, target, run), run:up:3 or target:7, with commas
        between them
    swap_directions: Exchange up and down
    columns: MAPPING. Which column of a CSV file is what, by number or name:
        'target=1,direction=3,deviation=5'
    skip_lines: N. Lines before the header of a CSV file
    unit: UNIT. Unit of targets and encoder
    value_unit: UNIT. Unit of deviations and reference
    values: KIND. What the values are: deviation (reference minus target) or reference (positions)
    direction_from: order. order: the direction of a run follows from the order of its targets
    invert_reference: The instrument counts the other way
    overrun: DISTANCE. How far a track moves after a turn before its samples count, in mm or deg; 1 % of the
        range unless given
    output: FILE. Table file to write, replaced if it exists; - for standard output. Without it nothing is
        written
    record: FILE.axcal. Begin a record of the compensation (.axcal): measurement, table and what it promises,
        for compare and report
    to: FORMAT. Format of the output, if its name leaves it open
    table: NAME. Write this column of points only, where the format holds one table
    accept_large: Put corrections above 1 % of the range, or with a slope above 0.1, into a .TAMtbl
    target: AXIS[,AXIS]. Axis that the values correct, for each column or for all: its name, #1 for the first
        source, or other for an axis that is no source; by default as the file says
    to_sign: SIDE. Convention of the output: feedback or command; by default that of its format, needed where
        that is assumed
    set_out: KEY=VALUE. Setting that the output format needs; `axiscomp formats NAME` lists them
    tolerance: FIGURE=LIMIT,.... Limits, such as A=10um,R=4um; exit code 8 when one is not met
    uncertainty: U. Uncertainty of the measurement with k = 2: U=2.1um, or a JSON file with its terms
    method: METHOD. Curve through the means: linear (the default), cubic, spline, smooth or harmonic
    smoothness: S. Of the method smooth, and of points and tracks; by cross-validation unless given
    period: P[,P]. Known periods, such as the lead of the screw, fitted by the method smooth
    harmonics: K. Harmonics of each period, and of the method harmonic, the fundamental counted (1 unless
        given)
    turn: LENGTH. Length of a turn of a modulo axis, such as 360: the table ends as it begins
    direction: CHOICE. Which runs the table is made of: mean of both (the default), positive or negative; both
        makes a table for each, for controllers that keep two
    by: WHAT. temperature: a table over position and temperature, from runs in several thermal states;
        --points and --distance take a second number for it
    points: N[,N[,N]]. Even grid with N points, for each axis or for all; unless given, that of the targets,
        where they are even
    distance: D[,D[,D]]. Even grid with spacing D, for each axis or for all
    within: DEVIATION. The fewest points that leave no more than this to the curve, in mm or deg
    hold: Let the grid extend beyond the targets, where the end values are held
    speed: V. Speed of the axis in mm/s or deg/s, for the steps of the velocity that are told
    zero: WHERE. Where the table is 0: home, first (the first target), mean, keep, or a position; home where
        it is known and measured, else first, unless given
    home: POSITION. Home position of the axis
    remove_slope: HOW. Take the slope out, for straightness: lsq (least squares) or ends
    remove_drift: HOW. Take the drift of the runs out before they are averaged: offset or trend
    lookup_at: WHERE. Where the drive looks the table up: encoder (before the compensation) or set (after it);
        with --onto drive by its source
    measured_with: STATE. What was active while it was measured, where the file does not say it: off, on, or
        the file of the table
    onto: TABLE. Merge residuals onto the table that was active: its file, or drive for the one that the axis
        uses (--drive, --axis)
    gain: GAIN. Factor for the residuals before they are merged (1); below 1, such as 0.7, where the machine
        responds sluggishly
    remove: WHAT. Remove the alignment of the artefact: rigid (position and rotation), rigid:X (rotated so
        that lines along X have no slope), or scale (its scale as well)
    fill: HOW. Points of the grid that are far from any measured one: smooth or nearest; refused unless given
    robust: Give values that do not fit the others less weight
    temperature: C. Temperature of the axis's scale in C
    expansion: PER_K. Coefficient of expansion of the axis's scale in 1/K, such as 11.5e-6
    reference_temperature: C. Temperature of the reference in C
    reference_expansion: PER_K. Coefficient of the reference in 1/K; 0 for a laser with wavelength
        compensation
    datum: POSITION. Position in mm that does not move with temperature; the first target unless given
    not_corrected: The values are not corrected to 20 C, where the file does not say it
    dead_path: FILE. Dead path of the interferometer: a JSON file with its length and the air of each run
    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    axis: AXIS. Index or name of the axis; not needed if the drive has only one
    """
    return call_fit(
        "fit",
        [*flat(file)],
        {
            "from_": from_,
            "exclude": exclude,
            "swap_directions": swap_directions,
            "columns": columns,
            "skip_lines": skip_lines,
            "unit": unit,
            "value_unit": value_unit,
            "values": values,
            "direction_from": direction_from,
            "invert_reference": invert_reference,
            "overrun": overrun,
            "output": output,
            "record": record,
            "to": to,
            "table": table,
            "accept_large": accept_large,
            "target": target,
            "to_sign": to_sign,
            "set_out": set_out,
            "tolerance": tolerance,
            "uncertainty": uncertainty,
            "method": method,
            "smoothness": smoothness,
            "period": period,
            "harmonics": harmonics,
            "turn": turn,
            "direction": direction,
            "by": by,
            "points": points,
            "distance": distance,
            "within": within,
            "hold": hold,
            "speed": speed,
            "zero": zero,
            "home": home,
            "remove_slope": remove_slope,
            "remove_drift": remove_drift,
            "lookup_at": lookup_at,
            "measured_with": measured_with,
            "onto": onto,
            "gain": gain,
            "remove": remove,
            "fill": fill,
            "robust": robust,
            "temperature": temperature,
            "expansion": expansion,
            "reference_temperature": reference_temperature,
            "reference_expansion": reference_expansion,
            "datum": datum,
            "not_corrected": not_corrected,
            "dead_path": dead_path,
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "axis": axis,
        },
        echo,
    )


def compare(
    *file: Source | Sequence[Source],
    from_: Value = None,
    exclude: Value = None,
    swap_directions: bool = False,
    columns: Values = None,
    skip_lines: Value = None,
    unit: Value = None,
    value_unit: Value = None,
    values: Value = None,
    direction_from: Value = None,
    invert_reference: bool = False,
    overrun: Value = None,
    record: Value = None,
    measured_with: Source | None = None,
    keep: bool = False,
    tolerance: Values = None,
    uncertainty: Value = None,
    temperature: Value = None,
    expansion: Value = None,
    reference_temperature: Value = None,
    reference_expansion: Value = None,
    datum: Value = None,
    not_corrected: bool = False,
    dead_path: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Compare measurements before and after a compensation, and with what was promised.

    file: [BEFORE] AFTER. Measurement before and measurement after; with a record, which has the first, the
        second alone is enough
    from_: FORMAT. Format of the files, if their content leaves it open
    exclude: WHAT. Leave values of the second measurement out: down:1:1 (direction, target, run), run:up:3 or
        target:7, with commas between them
    swap_directions: Exchange up and down
    columns: MAPPING. Which column of a CSV file is what, by number or name:
        'target=1,direction=3,deviation=5'
    skip_lines: N. Lines before the header of a CSV file
    unit: UNIT. Unit of targets and encoder
    value_unit: UNIT. Unit of deviations and reference
    values: KIND. What the values are: deviation (reference minus target) or reference (positions)
    direction_from: order. order: the direction of a run follows from the order of its targets
    invert_reference: The instrument counts the other way
    overrun: DISTANCE. How far a track moves after a turn before its samples count, in mm or deg; 1 % of the
        range unless given
    record: FILE.axcal. Record of the compensation: the first measurement with its exclusions and corrections,
        prediction, table and tolerances
    measured_with: on. on: the second measurement was made with the table of the record active, where its file
        does not say it
    keep: Add the second measurement and the verdict to the record
    tolerance: FIGURE=LIMIT,.... Limits, such as A=10um,R=4um; exit code 8 when one is not met
    uncertainty: U. Uncertainty of the measurement with k = 2: U=2.1um, or a JSON file with its terms
    temperature: C. Temperature of the axis's scale in C
    expansion: PER_K. Coefficient of expansion of the axis's scale in 1/K, such as 11.5e-6
    reference_temperature: C. Temperature of the reference in C
    reference_expansion: PER_K. Coefficient of the reference in 1/K; 0 for a laser with wavelength
        compensation
    datum: POSITION. Position in mm that does not move with temperature; the first target unless given
    not_corrected: The values are not corrected to 20 C, where the file does not say it
    dead_path: FILE. Dead path of the interferometer: a JSON file with its length and the air of each run
    """
    return call(
        "compare",
        [*flat(file)],
        {
            "from_": from_,
            "exclude": exclude,
            "swap_directions": swap_directions,
            "columns": columns,
            "skip_lines": skip_lines,
            "unit": unit,
            "value_unit": value_unit,
            "values": values,
            "direction_from": direction_from,
            "invert_reference": invert_reference,
            "overrun": overrun,
            "record": record,
            "measured_with": measured_with,
            "keep": keep,
            "tolerance": tolerance,
            "uncertainty": uncertainty,
            "temperature": temperature,
            "expansion": expansion,
            "reference_temperature": reference_temperature,
            "reference_expansion": reference_expansion,
            "datum": datum,
            "not_corrected": not_corrected,
            "dead_path": dead_path,
        },
        echo,
    )


def report(
    record: Value,
    *,
    output: Value = None,
    language: Value = None,
    lists: bool = False,
    echo: Echo | None = None,
) -> Document:
    """Write the report of a record: by how much an axis became better, on one page.

    record: Record of the compensation (.axcal)
    output: FILE. The report; its extension says whether it is PDF or HTML
    language: LANGUAGE. Language of the report: en, de, fr, ja or zh
    lists: Add pages with every target and every value that is left out
    """
    return call(
        "report",
        [record],
        {
            "output": output,
            "language": language,
            "lists": lists,
        },
        echo,
    )


def axes(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    find: bool = False,
    any_baud: bool = False,
    network: Value = None,
    echo: Echo | None = None,
) -> Document:
    """List the axes of one or several drives.

    drive: ENDPOINT. Address of the drive, may be given several times; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    find: Also try all serial ports of this computer; without --drive, the connections of the window too
    any_baud: Try the usual baud rates at every serial port
    network: RANGE. Also ask these addresses over http: 192.168.1.0/24, 192.168.1.10-40 or one address, at
        most 1024, with :PORT for another port than 80
    """
    return call(
        "axes",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "find": find,
            "any_baud": any_baud,
            "network": network,
        },
        echo,
    )


def status(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    axis: Value = None,
    reset_flash_count: bool = False,
    echo: Echo | None = None,
) -> Document:
    """Show the compensation of an axis, and the outcome of an interrupted write.

    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    axis: AXIS. Index or name of the axis; not needed if the drive has only one
    reset_flash_count: Count the drive's flash operations again after their record was damaged; first wait as
        long as the drive counts them
    """
    return call(
        "status",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "axis": axis,
            "reset_flash_count": reset_flash_count,
        },
        echo,
    )


def write(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    axis: Value = None,
    data: Source | None = None,
    record: Value = None,
    dims: Value = None,
    table: Value = None,
    from_: Value = None,
    set_in: Values = None,
    fill: Value = None,
    crop: bool = False,
    snap: Value = None,
    target: Values = None,
    sign: Value = None,
    direction: Value = None,
    scale: Value = None,
    offset: Value = None,
    zero: Values = None,
    no_wrap: bool = False,
    points: Values = None,
    distance: Values = None,
    within: Value = None,
    method: Value = None,
    speed: Value = None,
    hold: bool = False,
    source1: Value = None,
    source2: Value = None,
    source3: Value = None,
    own_position: bool = False,
    persistent: bool = False,
    volatile: bool = False,
    value_unit: Value = None,
    position_unit: Value = None,
    slot: Value = None,
    map: Values = None,
    accept_large: bool = False,
    dry_run: bool = False,
    echo: Echo | None = None,
) -> Document:
    """Write a compensation table to an axis in the safe order, and verify it.

    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    axis: AXIS. Index or name of the axis; not needed if the drive has only one
    data: FILE. Calibration file (.csv), table (.TAMtbl), or file of another controller; without it the axis
        keeps its table
    record: FILE.axcal. Record of a compensation in place of --data: its table is written, and it notes drive,
        slot and CRC
    dims: D. Number of dimensions of a CSV file: its first D columns are positions
    table: TABLE. Table of the file, by name or by number from 1 (name:TEXT, #N where that could be either);
        not needed if there is only one
    from_: FORMAT. Format of the input, if content and name leave it open
    set_in: KEY=VALUE. Setting that the file leaves open; `axiscomp formats NAME` lists them
    fill: METHOD. Give points without a value that of the nearest measured point (nearest), of the plane
        through all of them (plane), or the values that bend least (smooth)
    crop: Cut the grid to the largest part in which every point has a value
    snap: TOLERANCE. Take positions of a calibration file that are this close to the grid for grid positions,
        in their unit
    target: AXIS[,AXIS]. Axis that the values correct, for each column or for all: its name, #1 for the first
        source, or other for an axis that is no source; by default as the file says
    sign: SIDE. Convention of the input: feedback (added to the encoder position) or command (added to the
        commanded position); by default that of its format, needed where that is assumed
    direction: CHOICE. Which values to use if the file has both directions of motion: mean, positive or
        negative
    scale: FACTOR. Multiply the values by this number, before anything else
    offset: VALUE. Add this to the values, in their unit
    zero: P[,P[,P]]. Shift the values so that they are 0 at this position
    no_wrap: Treat a modulo axis as a linear one
    points: N[,N[,N]]. Resample onto an even grid with N points, for each source or for all
    distance: D[,D[,D]]. Resample onto an even grid with spacing D, for each source or for all
    within: DEVIATION. Resample onto the coarsest even grid within this deviation, in the unit of the values
    method: METHOD. Between the points of the source: linear (the default), cubic (monotone), spline (natural
        cubic) or smooth (smoothing spline)
    speed: SPEED. Speed of the axis in positions per second: says the steps of the velocity that are left with
        spline and smooth
    hold: Let the even grid extend beyond the data, where the end values are held
    source1: REG. Register that supplies the position of dimension 1: path, tam:// URI or address (0x1234)
    source2: REG. The same for dimension 2
    source3: REG. The same for dimension 3
    own_position: The source is the axis's own position, for tables of one dimension; with --map each axis's
        own
    persistent: Store the table in the drive's flash, so that it survives a reboot
    volatile: Keep the table in memory until the next reboot (the default for a new table)
    value_unit: UNIT. Unit of the values in place of what the file says, such as um; drive for the drive's own
    position_unit: UNIT. The same for the positions
    slot: SLOT. Slot to use, small1 to small8, large1 or large2; chosen unless given
    map: COLUMN=AXIS. Write this column of the file (name or number) to this axis; AXIS alone is the column
        that is named as the axis. May be given several times. Nothing is written unless all of the writes are
        possible
    accept_large: Write corrections above 1 % of the range, or with a slope above 0.1, which without this are
        taken for a wrong unit
    dry_run: Show what would be written without writing it
    """
    return call(
        "write",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "axis": axis,
            "data": data,
            "record": record,
            "dims": dims,
            "table": table,
            "from_": from_,
            "set_in": set_in,
            "fill": fill,
            "crop": crop,
            "snap": snap,
            "target": target,
            "sign": sign,
            "direction": direction,
            "scale": scale,
            "offset": offset,
            "zero": zero,
            "no_wrap": no_wrap,
            "points": points,
            "distance": distance,
            "within": within,
            "method": method,
            "speed": speed,
            "hold": hold,
            "source1": source1,
            "source2": source2,
            "source3": source3,
            "own_position": own_position,
            "persistent": persistent,
            "volatile": volatile,
            "value_unit": value_unit,
            "position_unit": position_unit,
            "slot": slot,
            "map": map,
            "accept_large": accept_large,
            "dry_run": dry_run,
        },
        echo,
    )


def persist(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    axis: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Store the axis's table in the drive's flash, so that it survives a reboot.

    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    axis: AXIS. Index or name of the axis; not needed if the drive has only one
    """
    return call(
        "persist",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "axis": axis,
        },
        echo,
    )


def unpersist(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    axis: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Make the axis's table volatile, so that it is lost at the next reboot.

    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    axis: AXIS. Index or name of the axis; not needed if the drive has only one
    """
    return call(
        "unpersist",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "axis": axis,
        },
        echo,
    )


def delete(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    axis: Value = None,
    slot: Value = None,
    dry_run: bool = False,
    echo: Echo | None = None,
) -> Document:
    """Delete the table of an axis, or one that no axis uses, and free its slot.

    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    axis: AXIS. Index or name of the axis; not needed if the drive has only one
    slot: SLOT. Delete the table in this slot, small1 to small8, large1 or large2, which no axis uses
    dry_run: Show what would be deleted without deleting it
    """
    return call(
        "delete",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "axis": axis,
            "slot": slot,
            "dry_run": dry_run,
        },
        echo,
    )


def evaluate(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    axis: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Let the drive look up the table without adding its values.

    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    axis: AXIS. Index or name of the axis; not needed if the drive has only one
    """
    return call(
        "evaluate",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "axis": axis,
        },
        echo,
    )


def activate(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    axis: Value = None,
    record: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Activate the compensation, and compare the drive's output with the table.

    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    axis: AXIS. Index or name of the axis; not needed if the drive has only one
    record: FILE.axcal. Record of the compensation (axiscomp write --record), which notes the proof
    """
    return call(
        "activate",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "axis": axis,
            "record": record,
        },
        echo,
    )


def deactivate(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    axis: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Deactivate the compensation.

    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    axis: AXIS. Index or name of the axis; not needed if the drive has only one
    """
    return call(
        "deactivate",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "axis": axis,
        },
        echo,
    )


def read(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    axis: Value = None,
    output: Value = None,
    to: Value = None,
    target: Values = None,
    points: Values = None,
    distance: Values = None,
    within: Value = None,
    method: Value = None,
    speed: Value = None,
    hold: bool = False,
    to_sign: Value = None,
    set_out: Values = None,
    echo: Echo | None = None,
) -> Document:
    """Download the table that an axis uses.

    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    axis: AXIS. Index or name of the axis; not needed if the drive has only one
    output: FILE. File to write, .csv, .TAMtbl or that of another controller; CSV on standard output without
        it
    to: FORMAT. Format of the output, if its name leaves it open
    target: AXIS[,AXIS]. Axis that the values correct, for each column or for all: its name, #1 for the first
        source, or other for an axis that is no source; by default as the file says
    points: N[,N[,N]]. Resample onto an even grid with N points, for each source or for all
    distance: D[,D[,D]]. Resample onto an even grid with spacing D, for each source or for all
    within: DEVIATION. Resample onto the coarsest even grid within this deviation, in the unit of the values
    method: METHOD. Between the points of the source: linear (the default), cubic (monotone), spline (natural
        cubic) or smooth (smoothing spline)
    speed: SPEED. Speed of the axis in positions per second: says the steps of the velocity that are left with
        spline and smooth
    hold: Let the even grid extend beyond the data, where the end values are held
    to_sign: SIDE. Convention of the output: feedback or command; by default that of its format, needed where
        that is assumed
    set_out: KEY=VALUE. Setting that the output format needs; `axiscomp formats NAME` lists them
    """
    return call(
        "read",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "axis": axis,
            "output": output,
            "to": to,
            "target": target,
            "points": points,
            "distance": distance,
            "within": within,
            "method": method,
            "speed": speed,
            "hold": hold,
            "to_sign": to_sign,
            "set_out": set_out,
        },
        echo,
    )


def files(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    echo: Echo | None = None,
) -> Document:
    """List the table files of a drive.

    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    """
    return call(
        "files",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
        },
        echo,
    )


def upload(
    file: Source,
    *,
    to: Value = None,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Upload a file unchanged and verify it, for drive programs that use tables.

    file: File on this computer
    to: PATH (required). Path in the drive, such as tables/small1.TAMtbl
    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    """
    return call(
        "upload",
        [file],
        {
            "to": to,
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
        },
        echo,
    )


def download(
    path: Value,
    *,
    output: Value = None,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Download a file unchanged.

    path: Path in the drive, such as tables/small1.TAMtbl
    output: FILE. File to write; standard output without it, or with -
    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    """
    return call(
        "download",
        [path],
        {
            "output": output,
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
        },
        echo,
    )


def backup(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    output: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Save everything that this program can change on a whole drive, all axes, to one file.

    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    output: FILE. File to write; standard output without it, or with -
    """
    return call(
        "backup",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "output": output,
        },
        echo,
    )


def restore(
    file: Source,
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    force: bool = False,
    dry_run: bool = False,
    echo: Echo | None = None,
) -> Document:
    """Restore a whole drive from a backup file, with verified writes; all of them are planned first.

    file: File that `axiscomp backup` wrote; - for standard input
    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    force: Restore to a drive with another serial number, such as a replacement
    dry_run: Show what would be written without writing it
    """
    return call(
        "restore",
        [file],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "force": force,
            "dry_run": dry_run,
        },
        echo,
    )


def recover(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    axis: Value = None,
    finish: bool = False,
    undo: bool = False,
    echo: Echo | None = None,
) -> Document:
    """Finish or undo an interrupted write; without an option, say which is possible.

    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    axis: AXIS. Index or name of the axis; not needed if the drive has only one
    finish: Bring the complete new state about, from whatever there is now
    undo: Bring back the complete state before the write
    """
    return call(
        "recover",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "axis": axis,
            "finish": finish,
            "undo": undo,
        },
        echo,
    )


def config(
    action: Value,
    file: Source,
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    from_: Value = None,
    output: Value = None,
    station: Value = None,
    force: bool = False,
    dry_run: bool = False,
    echo: Echo | None = None,
) -> Document:
    """Compensation parameters of a TAM configuration: show them, take them from a drive, or bring them to
    one.

    action: show, export (to the file) or import (from it)
    file: TAM configuration (.TAMcfg)
    drive: ENDPOINT. Address of the drive; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    from_: FILE. export: take the parameters from this configuration in place of a drive
    output: FILE. export: write this file instead, and leave the other one as it is
    station: STATION. Name or serial number of the station in the file; without it the one with the drive's
        serial number
    force: Accept a station with another serial number than the drive's
    dry_run: Show what would be written without writing it
    """
    return call(
        "config",
        [action, file],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "from_": from_,
            "output": output,
            "station": station,
            "force": force,
            "dry_run": dry_run,
        },
        echo,
    )


def plan(
    file: Source,
    *,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    only: Values = None,
    jobs: Value = None,
    allow_missing: bool = False,
    echo: Echo | None = None,
) -> Document:
    """Compare the drives of a machine with its machine file, and change nothing.

    file: Machine file (.toml)
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    only: AXIS. Only this axis, as the file names it, or SERIAL/AXIS for that of one drive; may be given
        several times
    jobs: N. Drives at the same time (16 unless given)
    allow_missing: Leave drives out that do not answer, which is an error otherwise
    """
    return call(
        "plan",
        [file],
        {
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "only": only,
            "jobs": jobs,
            "allow_missing": allow_missing,
        },
        echo,
    )


def apply(
    file: Source,
    *,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    only: Values = None,
    jobs: Value = None,
    allow_missing: bool = False,
    activate: bool = False,
    echo: Echo | None = None,
) -> Document:
    """Write what a machine file says to the drives of the machine, where they differ.

    file: Machine file (.toml)
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    only: AXIS. Only this axis, as the file names it, or SERIAL/AXIS for that of one drive; may be given
        several times
    jobs: N. Drives at the same time (16 unless given)
    allow_missing: Leave drives out that do not answer, which is an error otherwise
    activate: Switch the compensation of axes on and off where the file says so (active), and prove it
    """
    return call(
        "apply",
        [file],
        {
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "only": only,
            "jobs": jobs,
            "allow_missing": allow_missing,
            "activate": activate,
        },
        echo,
    )


def snapshot(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    output: Value = None,
    name: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Write a machine file with all tables from running drives.

    drive: ENDPOINT. Address of the drive, may be given several times; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    output: FOLDER. Folder for machine.toml and the tables; files of the same names are replaced
    name: TEXT. Name of the machine
    """
    return call(
        "snapshot",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "output": output,
            "name": name,
        },
        echo,
    )


def metrics(
    *,
    drive: Values = None,
    profile: Value = None,
    trust_certificate: Value = None,
    timeout: Value = None,
    machine: Value = None,
    prove: bool = False,
    output: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Print the states of drives as OpenMetrics text, for a collector.

    drive: ENDPOINT. Address of the drive, may be given several times; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    trust_certificate: SHA256. Trust the https certificate with this fingerprint from now on; any other one is
        refused
    timeout: SECONDS. Time limit for one exchange with the drive (5 unless given)
    machine: FILE. Machine file: its drives, and whether they differ from it
    prove: Compare the outputs of active compensations with their tables now
    output: FILE. File to write, whole or not at all; standard output without it
    """
    return call(
        "metrics",
        [],
        {
            "drive": drive,
            "profile": profile,
            "trust_certificate": trust_certificate,
            "timeout": timeout,
            "machine": machine,
            "prove": prove,
            "output": output,
        },
        echo,
    )


def doctor(
    *,
    drive: Values = None,
    profile: Value = None,
    timeout: Value = None,
    echo: Echo | None = None,
) -> Document:
    """Show what this computer has and lacks, and what each known drive answers.

    drive: ENDPOINT. Address of the drive, may be given several times; $AXISCOMP_DRIVE unless given
    profile: FILE. Drive profile (JSON) in place of the built-in one, generic
    timeout: SECONDS. Time limit for all that a drive is asked (5 unless given)
    """
    return call(
        "doctor",
        [],
        {
            "drive": drive,
            "profile": profile,
            "timeout": timeout,
        },
        echo,
    )
