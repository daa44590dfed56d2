#compdef aisle
# Completion for zsh: the program itself knows its words; where it has none, files are offered.
local -a found
found=(${(f)"$(aisle complete "${(@)words[2,CURRENT]}" 2>/dev/null)"})
if (( $#found )); then
  found=("${(@)found//:/\\:}")
  found=("${(@)found/$'\t'/:}")
  _describe aisle found
else
  _files
fi
