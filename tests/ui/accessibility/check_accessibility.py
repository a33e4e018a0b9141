#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a screen reader is told: starts the window on the demo drive, walks its AT-SPI tree, and
switches the compensation. Needs a display server and a session bus of its own:

    xvfb-run -a dbus-run-session -- check_accessibility.py PROGRAM
"""
import os
import subprocess
import sys
import tempfile
import time

try:
    import gi

    gi.require_version("Atspi", "2.0")
    from gi.repository import Atspi, GLib
except (ImportError, ValueError):
    print("gir1.2-atspi-2.0 and python3-gi are not installed")
    sys.exit(77)

PATIENCE = 120  # seconds, used up only where something never happens

# Everything that takes a value or does something.
CONTROLS = {"push button", "check box", "combo box", "text", "slider", "spin button", "toggle button",
            "page tab", "page tab list", "table", "tree", "tree table", "list box", "menu item"}
# What the page has with the demo drive; the name of a combo box is its label.
EXPECTED = [("combo box", "Drive"), ("push button", "Connections…"), ("push button", "Refresh"),
            ("push button", "Menu"), ("combo box", "Axis"), ("combo box", "Dimensionality"),
            ("combo box", "Dim1 Source"), ("push button", "Open…"), ("combo box", "Table"),
            ("check box", "Persistency"), ("push button", "Write Compensation"),
            ("push button", "Revert All"), ("push button", "Activate"),
            ("push button", "Deactivate"), ("check box", "Log")]


def wait_for(condition, what):
    """Its value, as soon as that is true; AT-SPI fails while widgets come and go."""
    context = GLib.MainContext.default()
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        while context.iteration(False):
            pass
        try:
            found = condition()
        except GLib.Error:
            found = None
        if found:
            return found
        time.sleep(0.05)
    sys.exit("waited in vain for " + what)


def shown(node):
    """The node and everything below it that is on the screen."""
    if not node or node.get_role_name() not in ("application",) \
            and not node.get_state_set().contains(Atspi.StateType.SHOWING):
        return
    yield node
    if node.get_role_name() in ("table", "tree", "tree table"):
        return  # cells have their own tests
    for index in range(node.get_child_count()):
        yield from shown(node.get_child_at_index(index))


def label_of(node):
    for relation in node.get_relation_set():
        if relation.get_relation_type() == Atspi.RelationType.LABELLED_BY:
            return relation.get_target(0).get_name()
    return ""


def name_of(node):
    return label_of(node) or node.get_name()


def program_of(process):
    desktop = Atspi.get_desktop(0)
    for index in range(desktop.get_child_count()):
        program = desktop.get_child_at_index(index)
        if program and program.get_process_id() == process.pid:
            return program
    return None


def control(program, role, name):
    for node in shown(program):
        if node.get_role_name() == role and name_of(node) == name:
            return node
    return None


def press(program, name):
    button = wait_for(
        lambda: (lambda node: node if node and node.get_state_set().contains(
            Atspi.StateType.ENABLED) else None)(control(program, "push button", name)),
        f"the button {name}")
    button.do_action(0)


def check_tree(program):
    faults = []
    for role, name in EXPECTED:
        if not control(program, role, name):
            faults.append(f"there is no {role} \"{name}\"")
    for node in shown(program):
        is_part = node.get_parent() and node.get_parent().get_role_name() == "combo box"
        if node.get_role_name() in CONTROLS and not is_part and not name_of(node):
            faults.append(f"a {node.get_role_name()} has no name: \"{node.get_description()}\"")
    return faults


def check_changes(program):
    """Each change of the state is said, once."""
    said = []
    listener = Atspi.EventListener.new(
        lambda event: said.append(event.source.get_name())
        if event.source and event.source.get_role_name() == "status bar" else None)
    listener.register("object:property-change:accessible-name")
    state = wait_for(
        lambda: next((node for node in shown(program)
                      if node.get_role_name() == "status bar"), None), "the state field")
    faults = []
    for button, word in (("Deactivate", "OFF"), ("Activate", "ACTIVE")):
        said.clear()
        press(program, button)
        wait_for(lambda: state.get_name() == f"Compensation: {word}", f"the state {word}")
        wait_for(lambda: f"Compensation: {word}" in said, f"the announcement of {word}")
        if said.count(f"Compensation: {word}") > 1:
            faults.append(f"{word} is said more than once")
    if not state.get_description():
        faults.append("the state field does not say since when and by which table")
    wait_for(
        lambda: any(node.get_role_name() in ("alert", "notification") and "active" in node.get_name()
                    for node in shown(program)), "the message that it is active")
    listener.deregister("object:property-change:accessible-name")
    return faults


def main():
    with tempfile.TemporaryDirectory() as home:
        environment = dict(
            os.environ, QT_QPA_PLATFORM="xcb", QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1", HOME=home,
            XDG_STATE_HOME=home + "/state", XDG_CONFIG_HOME=home + "/config", LC_ALL="C.UTF-8")
        process = subprocess.Popen([sys.argv[1], "--drive", "demo:"], env=environment)
        try:
            program = wait_for(lambda: program_of(process), "the program on the AT-SPI bus")
            wait_for(lambda: control(program, "push button", "Deactivate"), "the page")
            faults = check_tree(program) + check_changes(program)
        finally:
            process.terminate()
            process.wait(PATIENCE)
    if faults:
        sys.exit("\n".join(faults))
    print("the tree of the page is complete, and its changes are said")


main()
