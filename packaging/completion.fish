# Completion for fish: the program itself knows its words; where it has none, files are offered.
function __aisle_complete
    set -l word (commandline --current-token)
    set -l found (aisle complete (commandline --tokenize --cut-at-cursor --current-process)[2..] "$word" 2>/dev/null)
    if set -q found[1]
        printf '%s\n' $found
    else
        __fish_complete_path "$word"
    end
end
complete --command aisle --no-files --arguments '(__aisle_complete)'
