# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of axiscomp, axiscomp-virtualdrive and axis-compensation-wizard for bash.

# The options of each command. tests/app compares them with --help.
_axiscomp_options()
{
    local drive="--drive --profile --trust-certificate --timeout"
    local conversion="--target --sign --direction --no-wrap --scale --offset --zero"
    local connection="--profile --trust-certificate --timeout"
    local incomplete="--fill --crop --snap"
    local grid="--points --distance --within --method --speed --hold"
    local measurement="--from --exclude --swap-directions --columns --skip-lines --unit --value-unit --values --direction-from --invert-reference --overrun"
    local correction="--temperature --expansion --reference-temperature --reference-expansion --datum --not-corrected --dead-path"
    case $1 in
        "") echo "--help --version" ;;
        example) echo "--help --json --dims --tables --output" ;;
        inspect) echo "--help --json --dims --from --set-in --profile $incomplete" ;;
        convert) echo "--help --json --value-unit --accept-large --dims --table --from --set-in --to --set-out --persistent --volatile --name --profile --to-sign $incomplete $conversion $grid" ;;
        lookup) echo "--help --json --dims --table --points --outside --as --from --set-in --set-out --profile --to-sign $incomplete $conversion" ;;
        formats) echo "--help --json --markdown --measurements" ;;
        targets) echo "--help --json --from --to --count --spacing --period --cycles --seed --overrun --feed --dwell --axis --unit --dialect --output" ;;
        runs) echo "--help --json --output $measurement" ;;
        judge) echo "--help --json --tolerance --uncertainty --outliers --period --vdi $correction $measurement" ;;
        fit) echo "--help --json $drive --axis --output --record --to --table --accept-large --target --to-sign --set-out $grid --by --smoothness --period --harmonics --turn --direction --speed --zero --home --remove-slope --remove-drift --lookup-at --measured-with --onto --gain --remove --fill --robust --tolerance --uncertainty $correction $measurement" ;;
        compare) echo "--help --json --record --measured-with --keep --tolerance --uncertainty ${measurement/--exclude /}" ;;
        report) echo "--help --json --output --language --lists" ;;
        axes) echo "--help --json --find --any-baud --network $drive" ;;
        files) echo "--help --json $drive" ;;
        status) echo "--help --json $drive --axis --reset-flash-count" ;;
        persist | unpersist | evaluate | deactivate) echo "--help --json $drive --axis" ;;
        activate) echo "--help --json $drive --axis --record" ;;
        write) echo "--help --json $drive --axis --data --record --dims --table --from --set-in --map --source1 --source2 --source3 --own-position --persistent --volatile --slot --accept-large --dry-run --value-unit --position-unit $incomplete $conversion $grid" ;;
        delete) echo "--help --json $drive --axis --slot --dry-run" ;;
        read) echo "--help --json $drive --axis --output --to --target --to-sign --set-out $grid" ;;
        upload) echo "--help --json $drive --to" ;;
        download) echo "--help --json $drive --output" ;;
        capture) echo "--help --json $drive --axis --plan --output --reference --unit --invert-reference --zero-at --pattern --request --encoder --window --dwell --average --rate" ;;
        monitor) echo "--help --json $drive --axis --rate --count" ;;
        backup) echo "--help --json $drive --output" ;;
        restore) echo "--help --json $drive --force --dry-run" ;;
        recover) echo "--help --json $drive --axis --finish --undo" ;;
        plan) echo "--help --json $connection --only --jobs --allow-missing" ;;
        apply) echo "--help --json $connection --only --jobs --allow-missing --activate" ;;
        snapshot) echo "--help --json $drive --output --name" ;;
        metrics) echo "--help --json $drive --machine --prove --output" ;;
        doctor) echo "--help --json --drive --profile --timeout" ;;
        config) echo "--help --json $drive --from --output --station --force --dry-run" ;;
    esac
}

_axiscomp_commands="example inspect convert lookup formats targets capture runs judge fit compare report axes status write persist unpersist delete evaluate activate deactivate read files upload download monitor backup restore recover config plan apply snapshot metrics doctor"

_axiscomp_formats="csv tamtbl acs-1d acs-2d aerotech-1d aerotech-2d heidenhain-com heidenhain-com-530 icube isg-crosscomp isg-crosscomp2 isg-ssfk klipper klipper-twist kmotion-geo kmotion-linear linuxcnc pmac-1d pmac-2d power-pmac rapidcode rapidcode-header siemens-cec siemens-eec reprap softmc softmc-basic twincat-nc weihong"

_axiscomp_measurements="runs wide track points renishaw api-pos ecmc ecmc-report"

_axiscomp_slots="small1 small2 small3 small4 small5 small6 small7 small8 large1 large2"

_axiscomp_paths()
{
    local slot
    for slot in $_axiscomp_slots; do
        echo "tables/$slot.TAMtbl"
    done
}

_axiscomp()
{
    local cur prev words cword
    _init_completion -n : || return

    local command="" i
    for ((i = 1; i < cword; i++)); do
        if [[ " $_axiscomp_commands " == *" ${words[i]} "* ]]; then
            command=${words[i]}
            break
        fi
    done

    if [[ $command == targets ]]; then
        case $prev in
            --unit) COMPREPLY=($(compgen -W "mm deg" -- "$cur")); return ;;
            --dialect) COMPREPLY=($(compgen -W "linuxcnc fanuc siemens" -- "$cur")); return ;;
            --from | --to | --count | --spacing | --cycles | --seed | --feed | --dwell) return ;;
        esac
    fi
    if [[ $command == capture ]]; then
        case $prev in
            --plan) _filedir csv; return ;;
            --reference)
                COMPREPLY=($(compgen -W "- typed serial:/dev/" -- "$cur"))
                [[ ${COMPREPLY-} == serial:* ]] && compopt -o nospace
                __ltrim_colon_completions "$cur"
                return ;;
            --unit) COMPREPLY=($(compgen -W "mm um m inch deg arcsec" -- "$cur")); return ;;
            --zero-at | --pattern | --request | --encoder | --window | --dwell | --average) return ;;
        esac
    fi
    case $prev in
        --dims) COMPREPLY=($(compgen -W "1 2 3" -- "$cur")); return ;;
        --from | --as)
            if [[ $command == config ]]; then
                _filedir TAMcfg
                return
            fi
            if [[ $command == runs || $command == judge || $command == fit || $command == compare ]]; then
                COMPREPLY=($(compgen -W "$_axiscomp_measurements" -- "$cur"))
                return
            fi
            COMPREPLY=($(compgen -W "$_axiscomp_formats" -- "$cur"))
            return ;;
        --sign | --to-sign) COMPREPLY=($(compgen -W "feedback command" -- "$cur")); return ;;
        --by) COMPREPLY=($(compgen -W "temperature" -- "$cur")); return ;;
        --direction)
            if [[ $command == fit ]]; then
                COMPREPLY=($(compgen -W "mean positive negative both" -- "$cur"))
            else
                COMPREPLY=($(compgen -W "mean positive negative" -- "$cur"))
            fi
            return ;;
        --outliers) COMPREPLY=($(compgen -W "mad grubbs none" -- "$cur")); return ;;
        --values) COMPREPLY=($(compgen -W "deviation reference" -- "$cur")); return ;;
        --direction-from) COMPREPLY=($(compgen -W "order" -- "$cur")); return ;;
        --fill)
            if [[ $command == fit ]]; then
                COMPREPLY=($(compgen -W "nearest smooth" -- "$cur"))
            else
                COMPREPLY=($(compgen -W "nearest plane smooth" -- "$cur"))
            fi
            return ;;
        --method)
            if [[ $command == fit ]]; then
                COMPREPLY=($(compgen -W "linear cubic spline smooth harmonic" -- "$cur"))
            else
                COMPREPLY=($(compgen -W "linear cubic spline smooth" -- "$cur"))
            fi
            return ;;
        --remove) COMPREPLY=($(compgen -W "rigid rigid:X scale" -- "$cur")); return ;;
        --remove-slope) COMPREPLY=($(compgen -W "lsq ends" -- "$cur")); return ;;
        --remove-drift) COMPREPLY=($(compgen -W "offset trend" -- "$cur")); return ;;
        --lookup-at) COMPREPLY=($(compgen -W "encoder set" -- "$cur")); return ;;
        --zero)
            [[ $command == fit ]] && COMPREPLY=($(compgen -W "home first mean keep" -- "$cur"))
            return ;;
        --measured-with)
            if [[ $command == compare ]]; then
                COMPREPLY=($(compgen -W "on" -- "$cur"))
            else
                COMPREPLY=($(compgen -W "off on" -- "$cur"))
                _filedir
            fi
            return ;;
        --record) _filedir axcal; return ;;
        --onto) COMPREPLY=($(compgen -W "drive" -- "$cur")); _filedir; return ;;
        --to)
            if [[ $command == upload ]]; then
                COMPREPLY=($(compgen -W "$(_axiscomp_paths)" -- "$cur"))
            else
                COMPREPLY=($(compgen -W "$_axiscomp_formats" -- "$cur"))
            fi
            return ;;
        --language) COMPREPLY=($(compgen -W "en de" -- "$cur")); return ;;
        --outside) COMPREPLY=($(compgen -W "hold zero wrap extrapolate error" -- "$cur")); return ;;
        --slot) COMPREPLY=($(compgen -W "$_axiscomp_slots" -- "$cur")); return ;;
        --drive)
            COMPREPLY=($(compgen -W "http:// https:// demo:" -- "$cur"))
            [[ ${COMPREPLY-} == *// ]] && compopt -o nospace
            __ltrim_colon_completions "$cur"
            return ;;
        --profile) _filedir json; return ;;
        --machine) _filedir toml; return ;;
        --data) _filedir '@(csv|CSV|TAMtbl)'; return ;;
        --points)
            [[ $command == lookup ]] && _filedir
            return ;;
        -o | --output | --uncertainty | --dead-path) _filedir; return ;;
        --axis | --only | --jobs | --station | --table | --target | --value-unit | --position-unit | --tables | --timeout | --trust-certificate | --name | --rate | --count | --source[123] | --exclude | --columns | --skip-lines | --unit | --overrun | --tolerance | --period | --temperature | --expansion | --reference-temperature | --reference-expansion | --datum | --smoothness | --harmonics | --turn | --speed | --home | --gain) return ;;
    esac

    if [[ -z $command ]]; then
        COMPREPLY=($(compgen -W "$_axiscomp_commands $(_axiscomp_options "")" -- "$cur"))
    elif [[ $cur == -* ]]; then
        COMPREPLY=($(compgen -W "$(_axiscomp_options "$command")" -- "$cur"))
    elif [[ $command == download ]]; then
        COMPREPLY=($(compgen -W "$(_axiscomp_paths)" -- "$cur"))
    else
        case $command in
            inspect | convert | lookup | runs | judge | fit | compare | upload | restore) _filedir ;;
            report) _filedir axcal ;;
            plan | apply) _filedir toml ;;
            config)
                _filedir TAMcfg
                [[ $prev == config ]] && COMPREPLY=($(compgen -W "show export import" -- "$cur"))
                ;;
        esac
    fi
}

_axiscomp_virtualdrive_options="--help --version --http --serial --baud --name --axes --config --machine --program --program-after --instrument --state --fault --speed --unhomed --user --password-file --certificate --key --profile"

_axiscomp_virtualdrive()
{
    local cur prev words cword
    _init_completion -n := || return

    case $prev in
        --http) COMPREPLY=($(compgen -W "127.0.0.1:0 127.0.0.1:8080" -- "$cur")); __ltrim_colon_completions "$cur"; return ;;
        --config) _filedir TAMcfg; return ;;
        --machine) _filedir json; return ;;
        --program) _filedir csv; return ;;
        --state) _filedir -d; return ;;
        --certificate | --key) _filedir pem; return ;;
        --password-file) _filedir; return ;;
        --profile) _filedir json; return ;;
        --fault)
            COMPREPLY=($(compgen -W "drop-after= no-reply= garble= stores-wrong= slow= reboot-after= reject=" -- "$cur"))
            compopt -o nospace
            return ;;
        --serial | --instrument | --baud | --name | --axes | --speed | --user) return ;;
    esac
    COMPREPLY=($(compgen -W "$_axiscomp_virtualdrive_options" -- "$cur"))
}

_axis_compensation_wizard_options="--help --version --drive --profile --data --timeout"

_axis_compensation_wizard()
{
    local cur prev words cword
    _init_completion -n : || return

    case $prev in
        --drive)
            COMPREPLY=($(compgen -W "http:// https:// demo:" -- "$cur"))
            [[ ${COMPREPLY-} == *// ]] && compopt -o nospace
            __ltrim_colon_completions "$cur"
            return ;;
        --profile) _filedir json; return ;;
        --data) _filedir '@(csv|CSV|TAMtbl)'; return ;;
        --timeout) return ;;
    esac
    if [[ $cur == -* ]]; then
        COMPREPLY=($(compgen -W "$_axis_compensation_wizard_options" -- "$cur"))
    else
        _filedir axcal
    fi
}

complete -F _axiscomp axiscomp
complete -F _axis_compensation_wizard axis-compensation-wizard
complete -F _axiscomp_virtualdrive axiscomp-virtualdrive
