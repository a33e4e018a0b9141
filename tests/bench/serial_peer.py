#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How long sb and rb of lrzsz take for a file over the virtual drive's serial link: serial_peer.py DEVICE BYTES

Two lines, milliseconds up and down. The slot must hold a table of so many bytes.
"""
import os
import subprocess
import sys
import tempfile
import termios
import time
import zlib

PATH = "tables/large2.TAMtbl"


class Terminal:
    def __init__(self, device):
        self.port = os.open(device, os.O_RDWR | os.O_NOCTTY)

    def ask(self, line, wanted):
        os.write(self.port, (line + "\r").encode())
        heard = b""
        while wanted not in heard:
            heard += os.read(self.port, 4096)
        return heard

    def run(self, program, folder):
        subprocess.run(["timeout", "240", *program], check=True, cwd=folder, stdin=self.port, stdout=self.port,
                       stderr=subprocess.DEVNULL)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    terminal = Terminal(sys.argv[1])
    terminal.ask("list", PATH.encode())
    time.sleep(0.5)  # the rest of the list
    termios.tcflush(terminal.port, termios.TCIFLUSH)
    with tempfile.TemporaryDirectory() as folder:
        begin = time.perf_counter()
        terminal.ask(f"take {PATH}", b"\n")
        terminal.run(["rb", "-q", "-y"], folder)
        down = time.perf_counter() - begin
        name = os.listdir(folder)[0]
        with open(os.path.join(folder, name), "rb") as file:
            table = file.read()
        assert len(table) == int(sys.argv[2]), (len(table), sys.argv[2])
        time.sleep(0.5)
        termios.tcflush(terminal.port, termios.TCIFLUSH)
        begin = time.perf_counter()
        terminal.ask(f"put {PATH} {len(table)} {zlib.crc32(table):08x}", b"ready")
        terminal.run(["sb", "-q", "-k", name], folder)
        up = time.perf_counter() - begin
    print(f"{1e3 * up:.1f}\n{1e3 * down:.1f}")


if __name__ == "__main__":
    main()
