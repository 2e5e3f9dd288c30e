#!/usr/bin/env python3
"""Writes what bash, zsh and fish need to complete command lines, from what `orbicube --describe` prints.

    completions.py DESCRIPTION.json FOLDER

Verbs, options, words that options choose from, and files: with the ending that the option names where it names one.
"""
import json
import os
import re
import sys

HEAD = "orbicube: verbs, options and files. Made from `orbicube --describe`."


def takes_value(option):
    return option["max_values"] > 0


def is_file(option):
    """Whether the value is a file, as far as its name says: FILE, OUT, POLYCUBE, ..."""
    return option["positional"] or re.match(r"(FILE|FOLDER|OUT|MAP|COEFFS|POLYCUBE|SOLID|REST|matrix)", option["value"]) is not None


def ending(option):
    """The one ending of a file, as .json, or nothing."""
    found = re.fullmatch(r"FILE(\.\w+)", option["value"])
    return found.group(1) if found else ""


def flags_of(verb):
    return [option for option in verb["options"] if not option["positional"]]


def positionals_of(verb):
    return [option for option in verb["options"] if option["positional"]]


def bash(command):
    verbs = [verb["name"] for verb in command["verbs"]]
    rows, option_rows, positional_rows, with_value = {}, [], [], set()
    for verb in [{**command, "name": ""}, *command["verbs"]]:
        names = [name for option in flags_of(verb) for name in option["names"]]
        option_rows.append(f"    {verb['name'] or chr(39) * 2}) words='{' '.join(names)}' ;;")
        for option in flags_of(verb):
            if not takes_value(option):
                continue
            with_value.update(option["names"])
            if option["choices"]:
                action = f"words='{' '.join(option['choices'])}'"
            elif is_file(option):
                action = f"files='{ending(option) or '.'}'"
            else:
                action = ":"
            for name in option["names"]:
                rows.setdefault(action, []).append(f"{verb['name']}:{name}")
        for option in positionals_of(verb):
            if option["choices"]:
                positional_rows.append(f"    {verb['name']}) words='{' '.join(option['choices'])}' files= ;;")
    value_rows = [f"    {'|'.join(where)}) {action} ;;" for action, where in rows.items()]
    return f"""# {HEAD}
_orbicube() {{
  local IFS=$' \\t\\n' cur=${{COMP_WORDS[COMP_CWORD]}} before= verb= word last= words= files= value= i
  # Bash divides words at "=": --option=value is three of them.
  for ((i = 1; i < COMP_CWORD; ++i)); do
    word=${{COMP_WORDS[i]}}
    [[ $word == "=" ]] && continue
    case $last in
      {'|'.join(sorted(with_value))}) last= && continue ;;
    esac
    last=$word
    [[ -z $verb ]] && case $word in
      {'|'.join(verbs)}) verb=$word ;;
    esac
  done
  before=${{COMP_WORDS[COMP_CWORD - 1]}}
  if [[ $cur == "=" ]]; then
    cur=
  elif [[ $before == "=" ]]; then
    before=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  value=1
  case $verb:$before in
{os.linesep.join(value_rows)}
    *) value= ;;
  esac
  if [[ -z $value ]]; then
    if [[ $cur == -* ]]; then
      case $verb in
{os.linesep.join('  ' + row for row in option_rows)}
      esac
    elif [[ -z $verb ]]; then
      words='{' '.join(verbs)}'
    else
      files=.
      case $verb in
{os.linesep.join('  ' + row for row in positional_rows)}
        *) ;;
      esac
    fi
  fi
  COMPREPLY=()
  if [[ -n $words ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$cur")
  elif [[ $files == . ]]; then
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -f -- "$cur")
  elif [[ -n $files ]]; then
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -d -- "$cur"; compgen -f -X "!*$files" -- "$cur")
  fi
}}
complete -F _orbicube orbicube
"""


def in_single_quotes(text):
    return "'" + text.replace("'", "'\\''") + "'"


def zsh_value(option):
    """What follows the description of an option, or describes an argument."""
    name = option["value"].rstrip(".") or option["names"][0]
    if option["choices"]:
        action = "(" + " ".join(option["choices"]) + ")"
    elif is_file(option):
        action = f'_files -g "*{ending(option)}"' if ending(option) else "_files"
    else:
        action = " "
    return ":" + name.replace(":", "\\:") + ":" + action


def zsh_specs(verb):
    specs = []
    for option in flags_of(verb):
        text = option["text"].replace("\\", "\\\\").replace("[", "\\[").replace("]", "\\]").replace(":", "\\:")
        group = " ".join(option["names"])
        for name in option["names"]:
            value = zsh_value(option) if takes_value(option) else ""
            if value and option["min_values"] == 0:
                value = ":" + value
            several = "*" if option["max_values"] > 1 else f"({group})"
            specs.append(in_single_quotes(f"{several}{name}[{text}]{value}"))
    for option in positionals_of(verb):
        specs.append(in_single_quotes(("*" if option["max_values"] > 1 else "") + zsh_value(option)))
    return specs


def zsh(command):
    verbs = "\n".join("    " + in_single_quotes(verb["name"] + ":" + verb["text"].replace(":", "\\:")) for verb in command["verbs"])
    cases = "\n".join(f"    {verb['name']})\n      _arguments -s -S \\\n        " + " \\\n        ".join(zsh_specs(verb)) + "\n      ;;"
                      for verb in command["verbs"])
    general = " \\\n    ".join(zsh_specs(command))
    return f"""#compdef orbicube
# {HEAD}
_orbicube() {{
  local curcontext=$curcontext state line
  typeset -A opt_args
  local -a verbs
  verbs=(
{verbs}
  )
  _arguments -C -S \\
    {general} \\
    '1: :->verb' '*:: :->rest'
  case $state in
    verb) _describe verb verbs ;;
    rest)
      case $line[1] in
{cases}
      esac
      ;;
  esac
}}
if [[ $funcstack[1] == _orbicube ]]; then
  _orbicube "$@"
else
  compdef _orbicube orbicube
fi
"""


def fish_line(option, condition):
    words = ["complete -c orbicube", f"-n {in_single_quotes(condition)}"]
    for name in option["names"]:
        words.append(f"-l {name[2:]}" if name.startswith("--") else f"-s {name[1:]}")
    if takes_value(option):
        if option["choices"]:
            words.append("-x -a " + in_single_quotes(" ".join(option["choices"])))
        elif ending(option):
            words.append(f"-r -F -k -a '(__fish_complete_suffix {ending(option)})'")
        else:
            words.append("-r -F" if is_file(option) else "-x")
    return " ".join(words) + " -d " + fish_quotes(option["text"])


def fish_quotes(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def fish(command):
    lines = ["# " + HEAD]
    for option in flags_of(command):
        lines.append(fish_line(option, "__fish_use_subcommand"))
    for verb in command["verbs"]:
        lines.append(f"complete -c orbicube -n __fish_use_subcommand -f -a {verb['name']} -d {fish_quotes(verb['text'])}")
    for verb in command["verbs"]:
        condition = "__fish_seen_subcommand_from " + verb["name"]
        for option in positionals_of(verb):
            if option["choices"]:
                lines.append(f"complete -c orbicube -n '{condition}' -f -a '{' '.join(option['choices'])}'")
        lines += [fish_line(option, condition) for option in flags_of(verb)]
    return "\n".join(lines) + "\n"


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        command = json.load(file)
    for name, content in (("orbicube", bash(command)), ("_orbicube", zsh(command)), ("orbicube.fish", fish(command))):
        with open(os.path.join(sys.argv[2], name), "w", encoding="utf-8") as file:
            file.write(content)


if __name__ == "__main__":
    main()
