# Completion for bash: the program itself knows its words; where it has none, files are offered.
_aisle() {
  local IFS=$'\n'
  COMPREPLY=($(aisle complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null | cut -f 1))
}
complete -o default -F _aisle aisle
