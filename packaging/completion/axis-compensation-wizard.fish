# SPDX-License-Identifier: GPL-3.0-or-later
# Written by make_completion.py of what the programs say with --help.

complete -c axis-compensation-wizard -f
complete -c axis-compensation-wizard -s h -l help -d 'Show this help'
complete -c axis-compensation-wizard -l version -d 'Show the version'
complete -c axis-compensation-wizard -l drive -x -a 'http:// https:// serial:/dev/ demo:' -d 'Use this drive in place of the remembered ones'
complete -c axis-compensation-wizard -l profile -x -a '(__fish_complete_suffix .json)' -d 'Drive profile'
complete -c axis-compensation-wizard -l data -x -a '(__fish_complete_suffix .csv) (__fish_complete_suffix .TAMtbl)' -d 'Open this file of compensation data'
complete -c axis-compensation-wizard -l timeout -x -d 'How long one exchange with a drive may take'
complete -c axis-compensation-wizard -a '(__fish_complete_suffix .axcal) (__fish_complete_suffix .toml) (__fish_complete_suffix .TAMcfg) (__fish_complete_suffix .TAMtbl) (__fish_complete_suffix .csv)'
