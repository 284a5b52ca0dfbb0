# bash completion for drystone: verbs and options are those that the program itself lists.
_drystone() {
    local word=${COMP_WORDS[COMP_CWORD]} verb=${COMP_WORDS[1]} before=${COMP_WORDS[COMP_CWORD - 1]}
    if ((COMP_CWORD == 1)) || [[ $verb == help ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(drystone help | awk '/^  drystone / {print $2}')" -- "$word")
    elif [[ $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(drystone help "$verb" |
            awk '/^  (-. \[ )?--/ {print $2 == "[" ? $3 : $1}')" -- "$word")
    else
        compopt -o filenames
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
    fi
}
complete -F _drystone drystone
