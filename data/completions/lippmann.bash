# Completes commands, flags and their values in bash. The tool itself lists them.
_lippmann() {
  local word=${COMP_WORDS[COMP_CWORD]} line IFS=$'\n'
  COMPREPLY=()
  while read -r line; do
    if [[ $line == :files ]]; then
      COMPREPLY+=($(compgen -f -- "$word"))
    else
      COMPREPLY+=("$line")
    fi
  done < <("${COMP_WORDS[0]}" complete -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
}
complete -o filenames -F _lippmann lippmann
