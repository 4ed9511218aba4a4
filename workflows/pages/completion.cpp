#include "workflows/pages/completion.hpp"
#include "workflows/nearest.hpp"
#include <algorithm>
#include <fmt/ranges.h>

namespace mesobridge::workflows {
namespace {

bool is_for_users(OptionPage const& option) {
  return !option.group.empty() && !option.positional;
}

std::string option_words(CommandPage const& page) {
  std::vector<std::string> words;
  for (auto const& option : page.options)
    if (is_for_users(option))
      words.insert(words.end(), option.names.begin(), option.names.end());
  return fmt::format("{}", fmt::join(words, " "));
}

/// The first words of all commands: groups and single ones, each once.
std::vector<std::string> first_words(std::vector<CommandPage> const& pages) {
  std::vector<std::string> words{"help"};
  for (auto const& page : pages)
    words.push_back(page.name.substr(0, page.name.find(' ')));
  std::ranges::sort(words);
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

std::vector<std::string> second_words(std::vector<CommandPage> const& pages, std::string const& group) {
  std::vector<std::string> words;
  for (auto const& page : pages)
    if (page.name.starts_with(group + " "))
      words.push_back(page.name.substr(group.size() + 1));
  return words;
}

/// A word list of the shell for each command, group or option: "'md lj-grid') words='--json ...' ;;".
std::string branch(std::string const& of, std::string const& words) {
  return fmt::format("    '{}') words='{}' ;;\n", of, words);
}

std::string bash_script(std::vector<CommandPage> const& pages) {
  std::string groups, options, choices;
  for (auto const& word : first_words(pages))
    if (auto const second = second_words(pages, word); !second.empty())
      groups += branch(word, fmt::format("{}", fmt::join(second, " ")));
  for (auto const& page : pages) {
    options += branch(page.name, option_words(page));
    for (auto const& option : page.options)
      for (auto const& name : option.names)
        if (!option.choices.empty())
          choices += branch(page.name + " " + name, fmt::format("{}", fmt::join(option.choices, " ")));
  }
  return fmt::format(R"(# Completion of mesobridge for bash; made by `mesobridge completion bash`.
_mesobridge() {{
  local current="${{COMP_WORDS[COMP_CWORD]}}" before="${{COMP_WORDS[COMP_CWORD-1]}}" words='' command
  local first="${{COMP_WORDS[1]-}}" second="${{COMP_WORDS[2]-}}"
  [[ "$before" == '=' ]] && before="${{COMP_WORDS[COMP_CWORD-2]}}" # --preset=quick is three words to bash
  COMPREPLY=()
  if (( COMP_CWORD == 1 )); then
    COMPREPLY=($(compgen -W '{0} --help --version' -- "$current"))
    return
  fi
  case "$first" in
{1}  esac
  command="$first"
  if [[ -n "$words" ]]; then
    if (( COMP_CWORD == 2 )); then
      COMPREPLY=($(compgen -W "$words --help" -- "$current"))
      return
    fi
    command="$first $second"
  fi
  words=''
  case "$command $before" in
{2}  esac
  if [[ -n "$words" ]]; then
    COMPREPLY=($(compgen -W "$words" -- "$current"))
    return
  fi
  if [[ "$current" == -* ]]; then
    case "$command" in
{3}    esac
    COMPREPLY=($(compgen -W "$words" -- "$current"))
  fi
}}
complete -o default -F _mesobridge mesobridge
)",
                     fmt::join(first_words(pages), " "), groups, choices, options);
}

std::string zsh_script(std::vector<CommandPage> const& pages) {
  return "#compdef mesobridge\nautoload -U +X bashcompinit && bashcompinit\n" + bash_script(pages);
}

std::string quoted_for_fish(std::string const& text) {
  std::string quoted = "'";
  for (char const c : text)
    quoted += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return quoted + "'";
}

/// When fish offers what follows: behind these words of a command.
std::string behind(std::string const& name) {
  auto const space = name.find(' ');
  std::string text = "__fish_seen_subcommand_from " + name.substr(0, space);
  if (space != std::string::npos)
    text += "; and __fish_seen_subcommand_from " + name.substr(space + 1);
  return quoted_for_fish(text);
}

std::string fish_option(CommandPage const& page, OptionPage const& option) {
  std::string line = "complete -c mesobridge -n " + behind(page.name);
  for (auto const& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.value.empty())
    line += " -r";
  if (!option.choices.empty())
    line += " -f -a " + quoted_for_fish(fmt::format("{}", fmt::join(option.choices, " ")));
  return line + " -d " + quoted_for_fish(option.meaning) + "\n";
}

std::string fish_script(std::vector<CommandPage> const& pages) {
  std::string script = "# Completion of mesobridge for fish; made by `mesobridge completion fish`.\n";
  for (auto const& word : first_words(pages)) {
    script += fmt::format("complete -c mesobridge -n __fish_use_subcommand -f -a {}\n", word);
    for (auto const& second : second_words(pages, word)) {
      auto const page = std::ranges::find(pages, word + " " + second, &CommandPage::name);
      script += fmt::format("complete -c mesobridge -n 'test (count (commandline -opc)) -eq 2; and test "
                            "(commandline -opc)[2] = {}' -f -a {} -d {}\n",
                            word, second, quoted_for_fish(page->summary));
    }
  }
  for (auto const& page : pages)
    for (auto const& option : page.options)
      if (is_for_users(option))
        script += fish_option(page, option);
  return script;
}

} // namespace

std::vector<std::string> const& known_shells() {
  static std::vector<std::string> const shells{"bash", "zsh", "fish"};
  return shells;
}

std::string completion_script(std::string const& shell, std::vector<CommandPage> const& pages) {
  if (shell == "bash")
    return bash_script(pages);
  if (shell == "zsh")
    return zsh_script(pages);
  if (shell == "fish")
    return fish_script(pages);
  refuse_unknown("shell", shell, known_shells());
}

} // namespace mesobridge::workflows
