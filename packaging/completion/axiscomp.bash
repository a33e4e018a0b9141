# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of axiscomp, axiscomp-virtualdrive, axis-compensation-wizard for bash.
# Written by make_completion.py of what the programs say with --help.

_axiscomp_commands="example inspect convert lookup formats targets runs judge fit compare report capture axes status write persist unpersist delete evaluate activate deactivate read files upload download monitor backup restore recover config plan apply snapshot metrics doctor"

_axiscomp_formats="csv tamtbl acs-1d acs-2d aerotech-1d aerotech-2d fanuc heidenhain-com heidenhain-com-530 icube isg-crosscomp isg-crosscomp2 isg-ssfk klipper klipper-twist kmotion-geo kmotion-linear linuxcnc pmac-1d pmac-2d power-pmac rapidcode rapidcode-header siemens-cec siemens-eec reprap softmc softmc-basic twincat-nc weihong"

_axiscomp_measurements="runs wide track points renishaw api-pos ecmc ecmc-report"

# The options of a command; without one, those of the program.
_axiscomp_options()
{
    case $1 in
        "") echo "--help --version" ;;
        example) echo "--help --json --dims --tables --output" ;;
        inspect) echo "--help --json --dims --from --set-in --profile --fill --crop --snap" ;;
        convert) echo "--help --json --dims --table --from --set-in --to --accept-large --persistent --volatile --name --profile --fill --crop --snap --value-unit --target --sign --direction --scale --offset --zero --no-wrap --lookup-at --points --distance --within --method --speed --hold --to-sign --set-out" ;;
        lookup) echo "--help --json --dims --table --points --outside --as --from --set-in --profile --fill --crop --snap --target --sign --direction --scale --offset --zero --no-wrap --lookup-at --to-sign --set-out" ;;
        formats) echo "--help --json --markdown --measurements" ;;
        targets) echo "--help --json --from --to --count --spacing --period --cycles --seed --overrun --feed --dwell --axis --unit --dialect --output" ;;
        runs) echo "--help --json --from --exclude --swap-directions --output --columns --skip-lines --unit --value-unit --values --direction-from --invert-reference --overrun" ;;
        judge) echo "--help --json --from --exclude --swap-directions --tolerance --uncertainty --outliers --period --vdi --columns --skip-lines --unit --value-unit --values --direction-from --invert-reference --overrun --temperature --expansion --reference-temperature --reference-expansion --datum --not-corrected --dead-path" ;;
        fit) echo "--help --json --from --exclude --swap-directions --output --record --to --table --accept-large --tolerance --uncertainty --drive --profile --trust-certificate --timeout --axis --columns --skip-lines --unit --value-unit --values --direction-from --invert-reference --overrun --target --to-sign --set-out --method --smoothness --period --harmonics --turn --direction --by --points --distance --within --hold --speed --zero --home --remove-slope --remove-drift --lookup-at --measured-with --onto --gain --remove --fill --robust --temperature --expansion --reference-temperature --reference-expansion --datum --not-corrected --dead-path" ;;
        compare) echo "--help --json --from --exclude --swap-directions --record --measured-with --keep --tolerance --uncertainty --columns --skip-lines --unit --value-unit --values --direction-from --invert-reference --overrun --temperature --expansion --reference-temperature --reference-expansion --datum --not-corrected --dead-path" ;;
        report) echo "--help --json --output --language --lists" ;;
        capture) echo "--help --json --drive --profile --trust-certificate --timeout --axis --plan --output --reference --unit --invert-reference --zero-at --pattern --request --encoder --window --dwell --average --rate" ;;
        axes) echo "--help --json --drive --profile --trust-certificate --timeout --find --any-baud --network" ;;
        status) echo "--help --json --drive --profile --trust-certificate --timeout --axis --reset-flash-count" ;;
        write) echo "--help --json --drive --profile --trust-certificate --timeout --axis --data --record --dims --table --from --set-in --source1 --source2 --source3 --own-position --persistent --volatile --slot --map --accept-large --dry-run --fill --crop --snap --target --sign --direction --scale --offset --zero --no-wrap --points --distance --within --method --speed --hold --value-unit --position-unit" ;;
        persist) echo "--help --json --drive --profile --trust-certificate --timeout --axis" ;;
        unpersist) echo "--help --json --drive --profile --trust-certificate --timeout --axis" ;;
        delete) echo "--help --json --drive --profile --trust-certificate --timeout --axis --slot --dry-run" ;;
        evaluate) echo "--help --json --drive --profile --trust-certificate --timeout --axis" ;;
        activate) echo "--help --json --drive --profile --trust-certificate --timeout --axis --record" ;;
        deactivate) echo "--help --json --drive --profile --trust-certificate --timeout --axis" ;;
        read) echo "--help --json --drive --profile --trust-certificate --timeout --axis --output --to --target --points --distance --within --method --speed --hold --to-sign --set-out" ;;
        files) echo "--help --json --drive --profile --trust-certificate --timeout" ;;
        upload) echo "--help --json --to --drive --profile --trust-certificate --timeout" ;;
        download) echo "--help --json --output --drive --profile --trust-certificate --timeout" ;;
        monitor) echo "--help --json --drive --profile --trust-certificate --timeout --axis --rate --count" ;;
        backup) echo "--help --json --drive --profile --trust-certificate --timeout --output" ;;
        restore) echo "--help --json --drive --profile --trust-certificate --timeout --force --dry-run" ;;
        recover) echo "--help --json --drive --profile --trust-certificate --timeout --axis --finish --undo" ;;
        config) echo "--help --json --drive --profile --trust-certificate --timeout --from --output --station --force --dry-run" ;;
        plan) echo "--help --json --profile --trust-certificate --timeout --only --jobs --allow-missing" ;;
        apply) echo "--help --json --profile --trust-certificate --timeout --only --jobs --allow-missing --activate" ;;
        snapshot) echo "--help --json --drive --profile --trust-certificate --timeout --output --name" ;;
        metrics) echo "--help --json --drive --profile --trust-certificate --timeout --machine --prove --output" ;;
        doctor) echo "--help --json --drive --profile --timeout" ;;
    esac
}

_axiscomp_virtualdrive_options="--help --version --http --serial --baud --name --axes --config --machine --program --program-after --instrument --state --fault --speed --unhomed --user --password-file --certificate --key --profile"

_axis_compensation_wizard_options="--help --version --drive --profile --data --timeout"

_axiscomp_commands_of()
{
    [[ $1 == axiscomp ]] && echo "$_axiscomp_commands"
}

_axiscomp_options_of()
{
    case $1 in
        axiscomp) _axiscomp_options "$2" ;;
        axiscomp-virtualdrive) echo "$_axiscomp_virtualdrive_options" ;;
        axis-compensation-wizard) echo "$_axis_compensation_wizard_options" ;;
    esac
}

# _axiscomp_value PROGRAM COMMAND OPTION: fails for what takes no value.
_axiscomp_value()
{
    case "$1 $2 $3" in
        "axiscomp report -o" | "axiscomp report --output") echo "@files:pdf:html" ;;
        "axiscomp snapshot -o" | "axiscomp snapshot --output") echo "@folders" ;;
        "axiscomp targets --from" | "axiscomp targets --to") echo "" ;;
        "axiscomp runs --from" | "axiscomp judge --from" | "axiscomp fit --from" | "axiscomp compare --from") echo "runs wide track points renishaw api-pos ecmc ecmc-report" ;;
        "axiscomp config --from") echo "@files:TAMcfg" ;;
        "axiscomp fit --fill") echo "nearest smooth" ;;
        "axiscomp upload --to") echo "tables/small1.TAMtbl tables/small2.TAMtbl tables/small3.TAMtbl tables/small4.TAMtbl tables/small5.TAMtbl tables/small6.TAMtbl tables/small7.TAMtbl tables/small8.TAMtbl tables/large1.TAMtbl tables/large2.TAMtbl" ;;
        "axiscomp fit --direction") echo "mean positive negative both" ;;
        "axiscomp fit --zero") echo "home first mean keep" ;;
        "axiscomp lookup --points") echo "@files" ;;
        "axiscomp fit --method") echo "linear cubic spline smooth harmonic" ;;
        "axiscomp targets --unit") echo "mm deg" ;;
        "axiscomp capture --unit") echo "mm um m inch deg arcsec" ;;
        "axiscomp compare --measured-with") echo "on" ;;
        "axiscomp-virtualdrive  --machine") echo "@files:json" ;;
        *" --dims") echo "1 2 3" ;;
        *" --tables" | *" --set-in" | *" --snap" | *" --table" | *" --name" | *" --value-unit" | *" --target" | *" --scale" | *" --offset" | *" --zero" | *" --points" | *" --distance" | *" --within" | *" --speed" | *" --set-out" | *" --count" | *" --spacing" | *" --period" | *" --cycles" | *" --seed" | *" --overrun" | *" --feed" | *" --dwell" | *" --axis" | *" --unit" | *" --exclude" | *" --columns" | *" --skip-lines" | *" --tolerance" | *" --temperature" | *" --expansion" | *" --reference-temperature" | *" --reference-expansion" | *" --datum" | *" --trust-certificate" | *" --timeout" | *" --smoothness" | *" --harmonics" | *" --turn" | *" --home" | *" --gain" | *" --zero-at" | *" --pattern" | *" --request" | *" --encoder" | *" --window" | *" --average" | *" --rate" | *" --network" | *" --source1" | *" --source2" | *" --source3" | *" --map" | *" --position-unit" | *" --station" | *" --only" | *" --jobs" | *" --serial" | *" --baud" | *" --axes" | *" --program-after" | *" --instrument" | *" --user") echo "" ;;
        *" -o" | *" --output" | *" --uncertainty" | *" --dead-path" | *" --password-file") echo "@files" ;;
        *" --from" | *" --to" | *" --as") echo "csv tamtbl acs-1d acs-2d aerotech-1d aerotech-2d fanuc heidenhain-com heidenhain-com-530 icube isg-crosscomp isg-crosscomp2 isg-ssfk klipper klipper-twist kmotion-geo kmotion-linear linuxcnc pmac-1d pmac-2d power-pmac rapidcode rapidcode-header siemens-cec siemens-eec reprap softmc softmc-basic twincat-nc weihong" ;;
        *" --profile") echo "@files:json" ;;
        *" --fill") echo "nearest plane smooth" ;;
        *" --sign" | *" --to-sign") echo "feedback command" ;;
        *" --direction") echo "mean positive negative" ;;
        *" --lookup-at") echo "encoder set" ;;
        *" --method") echo "linear cubic spline smooth" ;;
        *" --outside") echo "hold zero wrap extrapolate error" ;;
        *" --dialect") echo "linuxcnc fanuc siemens" ;;
        *" --values") echo "deviation reference" ;;
        *" --direction-from") echo "order" ;;
        *" --outliers") echo "mad grubbs none" ;;
        *" --record") echo "@files:axcal" ;;
        *" --drive") echo "http:// https:// serial:/dev/ demo:" ;;
        *" --by") echo "temperature" ;;
        *" --remove-slope") echo "lsq ends" ;;
        *" --remove-drift") echo "offset trend" ;;
        *" --measured-with") echo "off on @files" ;;
        *" --onto") echo "drive @files" ;;
        *" --remove") echo "rigid rigid:X scale" ;;
        *" --language") echo "en de fr ja zh" ;;
        *" --plan" | *" --program") echo "@files:csv" ;;
        *" --reference") echo "- typed serial:/dev/" ;;
        *" --data") echo "@files:csv:TAMtbl" ;;
        *" --slot") echo "small1 small2 small3 small4 small5 small6 small7 small8 large1 large2" ;;
        *" --machine") echo "@files:toml" ;;
        *" --http") echo "127.0.0.1:0 127.0.0.1:8080" ;;
        *" --config") echo "@files:TAMcfg" ;;
        *" --state") echo "@folders" ;;
        *" --fault") echo "drop-after= no-reply= garble= stores-wrong= slow= reboot-after= reject=" ;;
        *" --certificate" | *" --key") echo "@files:pem" ;;
        *) return 1 ;;
    esac
}

# _axiscomp_argument COMMAND NUMBER-FROM-0
_axiscomp_argument()
{
    case "$1 $2" in
        "inspect "*) echo "@files" ;;
        "convert "0) echo "@files" ;;
        "convert "*) echo "@files" ;;
        "lookup "0) echo "@files" ;;
        "lookup "*) echo "" ;;
        "formats "*) echo "csv tamtbl acs-1d acs-2d aerotech-1d aerotech-2d fanuc heidenhain-com heidenhain-com-530 icube isg-crosscomp isg-crosscomp2 isg-ssfk klipper klipper-twist kmotion-geo kmotion-linear linuxcnc pmac-1d pmac-2d power-pmac rapidcode rapidcode-header siemens-cec siemens-eec reprap softmc softmc-basic twincat-nc weihong" ;;
        "runs "*) echo "@files" ;;
        "judge "*) echo "@files" ;;
        "fit "*) echo "@files" ;;
        "compare "*) echo "@files" ;;
        "report "*) echo "@files:axcal" ;;
        "upload "*) echo "@files" ;;
        "download "*) echo "tables/small1.TAMtbl tables/small2.TAMtbl tables/small3.TAMtbl tables/small4.TAMtbl tables/small5.TAMtbl tables/small6.TAMtbl tables/small7.TAMtbl tables/small8.TAMtbl tables/large1.TAMtbl tables/large2.TAMtbl" ;;
        "restore "*) echo "@files" ;;
        "config "0) echo "show export import" ;;
        "config "*) echo "@files:TAMcfg" ;;
        "plan "*) echo "@files:toml" ;;
        "apply "*) echo "@files:toml" ;;
        "axis-compensation-wizard "*) echo "@files:axcal:toml:TAMcfg:TAMtbl:csv" ;;
    esac
}

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

_axiscomp()
{
    _axiscomp_complete axiscomp
}
complete -F _axiscomp axiscomp

_axiscomp_virtualdrive()
{
    _axiscomp_complete axiscomp-virtualdrive
}
complete -F _axiscomp_virtualdrive axiscomp-virtualdrive

_axis_compensation_wizard()
{
    _axiscomp_complete axis-compensation-wizard
}
complete -F _axis_compensation_wizard axis-compensation-wizard
