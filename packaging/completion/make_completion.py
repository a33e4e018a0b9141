#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the completions for bash, zsh and fish of what the programs say with --help.

Which commands and options there are is asked of the programs; which values an option takes stands here, and an
option that is not here is an error. A test compares the files with what this makes.
    packaging/completion/make_completion.py build/run/bin packaging/completion
"""

import dataclasses
import json
import os
import re
import subprocess
import sys
from pathlib import Path

PROGRAMS = ("axiscomp", "axiscomp-virtualdrive", "axis-compensation-wizard")
ROOT = Path(__file__).resolve().parents[2]
PROFILE = ROOT / "resources/profiles/generic.json"
LICENCE = "# SPDX-License-Identifier: GPL-3.0-or-later\n"
WRITTEN = "Written by make_completion.py of what the programs say with --help."


@dataclasses.dataclass
class Value:
    """What may stand somewhere. files: None for no file, else the endings of those that fit; none for any file."""

    words: tuple = ()
    files: tuple | None = None
    folders: bool = False


def words(*texts):
    return Value(tuple(" ".join(texts).split()))


def files(*endings, words=""):
    return Value(tuple(words.split()), endings)


TEXT = Value()
FOLDER = Value(folders=True)
ANY_FILE = files()
ENDPOINT = words("http:// https:// serial:/dev/ demo:")
SIDE = words("feedback command")


def profile_words(key):
    slots = json.loads(PROFILE.read_text())["slots"]
    return words(*(slot[key].lower() if key == "name" else slot[key] for slot in slots))


def languages():
    """That there is a translation for."""
    return sorted(file.stem.removeprefix("axiscomp_") for file in (ROOT / "translations").glob("axiscomp_*.ts"))


def known_values(formats, measurements):
    """By option, or by command and option where a command means something else by it."""
    values = {
        "--as": formats, "--from": formats, "--to": formats, "upload --to": profile_words("file"),
        "config --from": files("TAMcfg"), "targets --from": TEXT, "targets --to": TEXT,
        **{f"{command} --from": measurements for command in ("runs", "judge", "fit", "compare")},
        "--by": words("temperature"), "--data": files("csv", "TAMtbl"), "--dialect": words("linuxcnc fanuc siemens"),
        "--dims": words("1 2 3"), "--direction": words("mean positive negative"),
        "fit --direction": words("mean positive negative both"), "--direction-from": words("order"),
        "--drive": ENDPOINT, "--fill": words("nearest plane smooth"), "fit --fill": words("nearest smooth"),
        "--language": words("en", *languages()), "--lookup-at": words("encoder set"), "--machine": files("toml"),
        "axiscomp-virtualdrive --machine": files("json"), "--measured-with": files(words="off on"),
        "compare --measured-with": words("on"), "--method": words("linear cubic spline smooth"),
        "fit --method": words("linear cubic spline smooth harmonic"), "--onto": files(words="drive"),
        "--outliers": words("mad grubbs none"), "--output": ANY_FILE, "snapshot --output": FOLDER,
        "report --output": files("pdf", "html"), "--outside": words("hold zero wrap extrapolate error"),
        "--plan": files("csv"), "lookup --points": ANY_FILE, "--profile": files("json"), "--record": files("axcal"),
        "--reference": words("- typed serial:/dev/"), "--remove": words("rigid rigid:X scale"),
        "--remove-drift": words("offset trend"), "--remove-slope": words("lsq ends"), "--sign": SIDE, "--to-sign": SIDE,
        "--slot": profile_words("name"), "capture --unit": words("mm um m inch deg arcsec"),
        "targets --unit": words("mm deg"), "--uncertainty": ANY_FILE, "--dead-path": ANY_FILE,
        "--values": words("deviation reference"), "fit --zero": words("home first mean keep"),
        "--http": words("127.0.0.1:0 127.0.0.1:8080"), "--config": files("TAMcfg"), "--program": files("csv"),
        "--state": FOLDER, "--certificate": files("pem"), "--key": files("pem"), "--password-file": ANY_FILE,
        "--fault": words("drop-after= no-reply= garble= stores-wrong= slow= reboot-after= reject="),
    }
    nothing_to_propose = """--average --axes --axis --baud --columns --count --cycles --datum --distance --dwell
        --encoder --exclude --expansion --feed --gain --harmonics --home --instrument --jobs --map --name --network
        --offset --only --overrun --pattern --period --points --position-unit --program-after --rate
        --reference-expansion --reference-temperature --request --scale --seed --serial --set-in --set-out
        --skip-lines --smoothness --snap --source1 --source2 --source3 --spacing --speed --station --table --tables
        --target --temperature --timeout --tolerance --trust-certificate --turn --unit --user --value-unit --window
        --within --zero --zero-at"""
    return {**{option: TEXT for option in nothing_to_propose.split()}, **values}


def known_arguments(formats):
    """By the name in --help, or by command and name."""
    return {
        "FILE": ANY_FILE, "IN": ANY_FILE, "OUT": ANY_FILE, "POSITION": TEXT, "NAME": formats, "RECORD": files("axcal"),
        "PATH": profile_words("file"), "config ACTION": words("show export import"), "config FILE": files("TAMcfg"),
        "plan FILE": files("toml"), "apply FILE": files("toml"),
        "axis-compensation-wizard FILE": files("axcal", "toml", "TAMcfg", "TAMtbl", "csv"),
    }


@dataclasses.dataclass
class Option:
    names: list
    text: str  # of its value; empty: it takes none
    description: str
    value: Value | None = None


@dataclasses.dataclass
class Command:
    name: str
    description: str
    options: list
    arguments: list  # of Value; the last one may be repeated
    commands: list


def summary(text):
    """What a list has room for."""
    return re.split(r"; |\. | \(|: ", text)[0].strip()


def entries(lines):
    """Pairs of what begins a line and its description, which may go on in lines below."""
    found = []
    for line in lines:
        if not line.startswith("  ") or line.startswith("   " * 2):
            if found and line.startswith(" " * 20):
                found[-1][1] += " " + line.strip()
            continue
        begin, _, description = line.strip().partition("  ")
        found.append([begin, description.strip()])
    return found


def sections(text):
    """The lines of each section of a help text, by its heading. Examples are none."""
    found, heading = {}, None
    for line in text.splitlines():
        match = re.fullmatch(r"(\w[^:]*):", line)
        if match:
            heading = match[1]
            found[heading] = []
        elif line and not line.startswith(" "):
            heading = None
        elif heading:
            found[heading].append(line)
    return {name: lines for name, lines in found.items() if not name.startswith("Example")}


def option_of(begin, description):
    names = re.findall(r"(?<![\w-])--?[a-z][a-z0-9-]*", begin.split(" ", 2 if ", " in begin else 1)[0] + " "
                       + (begin.split(" ")[1] if ", " in begin else ""))
    text = begin.split(names[-1], 1)[1].strip()
    return Option(names, text, summary(description))


class Reader:
    def __init__(self, folder):
        self.folder = Path(folder)

    def output(self, program, *arguments):
        environment = {**os.environ, "LC_ALL": "C.UTF-8", "LANGUAGE": ""}
        return subprocess.run(
            [self.folder / program, *arguments], check=True, capture_output=True, text=True, env=environment).stdout

    def names_of(self, *arguments):
        document = json.loads(self.output("axiscomp", "formats", "--json", *arguments))
        return words(*(one["name"] for one in next(iter(document.values()))))

    def programs(self):
        formats = self.names_of()
        self.values = known_values(formats, self.names_of("--measurements"))
        self.places = known_arguments(formats)
        return [self.program(name) for name in PROGRAMS if (self.folder / name).exists()]

    def program(self, name):
        program = self.command(name, self.output(name, "--help"), "")
        for _, lines in sections(self.output(name, "--help")).items():
            for begin, description in entries(lines):
                if re.fullmatch(r"[a-z]+", begin):
                    program.commands.append(
                        self.command(begin, self.output(name, begin, "--help"), summary(description)))
        return program

    def command(self, name, text, description):
        options, arguments = [], []
        for heading, lines in sections(text).items():
            for begin, about in entries(lines):
                if heading == "Arguments":
                    arguments.append(self.places.get(f"{name} {begin}", self.places.get(begin)))
                    if arguments[-1] is None:
                        raise SystemExit(f"known_arguments() does not say what {begin} of {name} is")
                elif begin.startswith("-"):
                    options.append(self.with_value(name, option_of(begin, about)))
        return Command(name, description, options, arguments, [])

    def with_value(self, command, option):
        if option.text:
            long = option.names[-1]
            option.value = self.values.get(f"{command} {long}", self.values.get(long))
            if option.value is None:
                raise SystemExit(f"known_values() does not say what {long} of {command} takes")
        return option


def identifier(name):
    return "_" + name.replace("-", "_")


# bash: a value is said as its words, with @files, @files:ending:ending or @folders for what is on the disk.
def bash_value(value):
    marks = list(value.words)
    if value.files is not None:
        marks.append(":".join(["@files", *value.files]))
    if value.folders:
        marks.append("@folders")
    return " ".join(marks)


BASH_ENGINE = r'''
# _axiscomp_propose VALUE: words, and files where a mark says so.
_axiscomp_propose()
{
    local words="" mark endings
    for mark in $1; do
        case $mark in
            @folders) _filedir -d ;;
            @files) _filedir ;;
            @files:*)
                endings=${mark#@files:}
                _filedir "@(${endings//:/|})"
                ;;
            *) words+=" $mark" ;;
        esac
    done
    COMPREPLY+=($(compgen -W "$words" -- "$cur"))
    [[ ${COMPREPLY-} == *[/=] ]] && compopt -o nospace
    __ltrim_colon_completions "$cur"
}

# _axiscomp_complete PROGRAM: with its functions for commands, options, values and arguments.
_axiscomp_complete()
{
    local cur prev words cword
    _init_completion -n := || return
    local program=$1 command="" arguments=0 i
    local commands=" $(_axiscomp_commands_of "$program") "
    for ((i = 1; i < cword; i++)); do
        if [[ -z $command && $commands == *" ${words[i]} "* ]]; then
            command=${words[i]}
        elif [[ ${words[i]} != -* ]] && ! _axiscomp_value "$program" "$command" "${words[i - 1]}" >/dev/null; then
            arguments=$((arguments + 1))
        fi
    done
    local value
    if value=$(_axiscomp_value "$program" "$command" "$prev"); then
        _axiscomp_propose "$value"
    elif [[ $cur == -* ]]; then
        COMPREPLY=($(compgen -W "$(_axiscomp_options_of "$program" "$command")" -- "$cur"))
    elif [[ -n ${commands// /} && -z $command ]]; then
        COMPREPLY=($(compgen -W "$commands $(_axiscomp_options_of "$program" "")" -- "$cur"))
    else
        _axiscomp_propose "$(_axiscomp_argument "${command:-$program}" "$arguments")"
    fi
}
'''


def bash_case(patterns, result):
    return f"        {' | '.join(patterns)}) echo \"{result}\" ;;"


def bash_values(programs):
    """Patterns for "PROGRAM COMMAND OPTION" by what they propose: what is special of a command, then what an
    option takes mostly. None of a command's options that takes nothing is the name of one that does."""
    takes = {}
    for program in programs:
        for command in [dataclasses.replace(program, name=""), *program.commands]:
            for option in command.options:
                for name in option.names if option.value else ():
                    takes.setdefault(name, []).append((f"{program.name} {command.name}", bash_value(option.value)))
    special, usual = {}, {}
    for name, uses in takes.items():
        results = [result for _, result in uses]
        most = max(results, key=results.count)
        usual.setdefault(most, []).append(f'*" {name}"')
        for command, result in uses:
            if result != most:
                special.setdefault(result, []).append(f'"{command} {name}"')
    return [*special.items(), *usual.items()]


def bash(programs, formats, measurements):
    main = programs[0]
    lines = [LICENCE + f"# Completion of {', '.join(p.name for p in programs)} for bash.", f"# {WRITTEN}", ""]
    lines += [f'_axiscomp_commands="{" ".join(c.name for c in main.commands)}"', "",
              f'_axiscomp_formats="{" ".join(formats.words)}"', "",
              f'_axiscomp_measurements="{" ".join(measurements.words)}"', ""]
    lines += ["# The options of a command; without one, those of the program.", "_axiscomp_options()", "{", "    case $1 in"]
    for command in [dataclasses.replace(main, name='""'), *main.commands]:
        lines.append(bash_case([command.name], " ".join(o.names[-1] for o in command.options)))
    lines += ["    esac", "}", ""]
    for program in programs[1:]:
        options = " ".join(o.names[-1] for o in program.options)
        lines += [f'{identifier(program.name)}_options="{options}"', ""]
    lines += ["_axiscomp_commands_of()", "{", "    [[ $1 == axiscomp ]] && echo \"$_axiscomp_commands\"", "}", "",
              "_axiscomp_options_of()", "{", "    case $1 in", '        axiscomp) _axiscomp_options "$2" ;;']
    lines += [f'        {p.name}) echo "${identifier(p.name)}_options" ;;' for p in programs[1:]]
    lines += ["    esac", "}", "", "# _axiscomp_value PROGRAM COMMAND OPTION: fails for what takes no value.",
              "_axiscomp_value()", "{", '    case "$1 $2 $3" in']
    for result, patterns in bash_values(programs):
        lines.append(bash_case(patterns, result))
    lines += ["        *) return 1 ;;", "    esac", "}", "", "# _axiscomp_argument COMMAND NUMBER-FROM-0",
              "_axiscomp_argument()", "{", '    case "$1 $2" in']
    for command in [c for p in programs for c in (*p.commands, p)]:
        for index, argument in enumerate(command.arguments):
            more = "*" if index == len(command.arguments) - 1 else index
            lines.append(bash_case([f'"{command.name} "{more}'], bash_value(argument)))
    lines += ["    esac", "}", BASH_ENGINE.rstrip(), ""]
    for program in programs:
        name = identifier(program.name)
        lines += [f"{name}()", "{", f"    _axiscomp_complete {program.name}", "}", f"complete -F {name} {program.name}", ""]
    return "\n".join(lines).rstrip() + "\n"


# zsh: a specification of _arguments for each option.
def zsh_text(text):
    return re.sub(r"([\[\]:\\])", r"\\\1", text).replace("'", "'\\''")


def zsh_action(value):
    parts = []
    if value.words:
        parts.append("compadd -S '' -- " + " ".join(value.words) if any(w[-1] in ":/=" for w in value.words)
                     else "compadd -- " + " ".join(value.words))
    if value.folders:
        parts.append("_files -/")
    elif value.files is not None:
        parts.append(f"_files -g '*.(#i)({'|'.join(value.files)})(-.)'" if value.files else "_files")
    if not parts:
        return " "
    # A colon would begin the next part of the specification; the shell takes the backslash away.
    return "{" + "; ".join(parts).replace(":", "\\:") + "}"


def zsh_quoted(text):
    return "'" + text.replace("'", "'\\''") + "'"


def zsh_option(option):
    about = "[" + re.sub(r"([\[\]\\])", r"\\\1", option.description) + "]"
    message = re.sub(r"[^\w.,=-]", "", option.text).strip() or "value"
    value = f":{message}:{zsh_action(option.value)}" if option.value else ""
    if len(option.names) == 1:
        return zsh_quoted("*" + option.names[0] + about + value if option.value else option.names[0] + about)
    return "{" + ",".join(option.names) + "}" + zsh_quoted(about + value)


def zsh_arguments(command):
    specs = [zsh_option(o) for o in command.options]
    for index, argument in enumerate(command.arguments):
        place = "*" if index == len(command.arguments) - 1 else str(index + 1)
        specs.append(zsh_quoted(f"{place}:argument:{zsh_action(argument)}"))
    return specs


def zsh(programs):
    lines = ["#compdef " + " ".join(p.name for p in programs), LICENCE + f"# {WRITTEN}", ""]
    for program in programs:
        lines += [f"{identifier(program.name)}_arguments()", "{"]
        specs = zsh_arguments(program)
        if program.commands:
            lines += ["    local -a commands=("]
            lines += [f"        {zsh_quoted(c.name + ':' + zsh_text(c.description))}" for c in program.commands]
            lines += ["    )", "    local line state", "    _arguments -C \\"]
            lines += [f"        {spec} \\" for spec in specs]
            lines += ["        '1:command:->command' '*::argument:->argument'", "    case $state in",
                      "        command) _describe command commands ;;", "        argument)",
                      "            case $line[1] in"]
            for command in program.commands:
                lines += [f"                {command.name})", "                    _arguments \\"]
                lines += [" \\\n".join(f"                        {spec}" for spec in zsh_arguments(command)),
                          "                    ;;"]
            lines += ["            esac", "            ;;", "    esac"]
        else:
            lines += ["    _arguments \\", " \\\n".join(f"        {spec}" for spec in specs)]
        lines += ["}", ""]
    lines += ["case $service in"]
    lines += [f"    {p.name}) {identifier(p.name)}_arguments ;;" for p in programs]
    return "\n".join([*lines, "esac"]) + "\n"


# fish: a line for each option, with the command that must have been typed.
def fish_quoted(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def fish_proposals(value):
    parts = list(value.words)
    if value.folders:
        parts.append("(__fish_complete_directories)")
    if value.files:
        parts += [f"(__fish_complete_suffix .{ending})" for ending in value.files]
    return " ".join(parts)


def fish_value(value):
    if value is None:
        return ""
    proposals = fish_proposals(value)
    text = " -r -F" if value.files == () else " -x"
    return text + (f" -a {fish_quoted(proposals)}" if proposals else "")


def fish_option(program, condition, option):
    names = "".join(f" -l {n[2:]}" if n.startswith("--") else f" -s {n[1:]}" for n in option.names)
    return f"complete -c {program}{condition}{names}{fish_value(option.value)} -d {fish_quoted(option.description)}"


def fish_arguments(program, condition, arguments):
    lines = []
    for argument in arguments:
        proposals = fish_proposals(argument)
        if argument.files == ():
            lines.append(f"complete -c {program}{condition} -F")
        if proposals:
            lines.append(f"complete -c {program}{condition} -a {fish_quoted(proposals)}")
    return sorted(set(lines))


def fish(program):
    name = program.name
    lines = [LICENCE + f"# {WRITTEN}", "", f"complete -c {name} -f"]
    first = " -n __fish_use_subcommand" if program.commands else ""
    lines += [fish_option(name, first, option) for option in program.options]
    lines += fish_arguments(name, first, program.arguments)
    lines += [f"complete -c {name}{first} -a {c.name} -d {fish_quoted(c.description)}" for c in program.commands]
    for command in program.commands:
        condition = f" -n '__fish_seen_subcommand_from {command.name}'"
        lines += [fish_option(name, condition, option) for option in command.options]
        lines += fish_arguments(name, condition, command.arguments)
    return "\n".join(lines) + "\n"


def main(program_folder, output_folder):
    reader = Reader(program_folder)
    programs = reader.programs()
    texts = {"axiscomp.bash": bash(programs, reader.names_of(), reader.names_of("--measurements")),
             "_axiscomp": zsh(programs)}
    texts |= {f"{program.name}.fish": fish(program) for program in programs}
    for name, text in texts.items():
        (Path(output_folder) / name).write_text(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
