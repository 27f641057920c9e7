#include "studies/commands/completion.hpp"

#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>

#include "studies/commands/commands.hpp"

namespace brouwer {
namespace {

std::vector<std::string> options_of(CLI::App const& command) {
  std::vector<std::string> names;
  for (auto const* option : command.get_options()) {
    for (auto const& name : option->get_snames()) names.push_back("-" + name);
    for (auto const& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// One branch of a case statement a subcommand: its options.
std::string branches(CLI::App const& app, std::string const& pattern) {
  std::string text;
  for (auto const* command : app.get_subcommands({}))
    text += fmt::format(fmt::runtime(pattern), command->get_name(), fmt::join(options_of(*command), " "));
  return text;
}

std::string names_of(CLI::App const& app) {
  std::string names;
  for (auto const* command : app.get_subcommands({})) names += " " + command->get_name();
  return names.substr(1);
}

std::string bash_script(CLI::App const& app) {
  return fmt::format(R"(_brouwer() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} options
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W "{0} --help --version" -- "$word"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{1}  esac
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  elif [[ ${{COMP_WORDS[1]}} == list ]]; then
    COMPREPLY=($(compgen -W "{2}" -- "$word"))
  fi
}}
complete -o default -F _brouwer brouwer
)",
                     names_of(app), branches(app, "    {}) options='{}' ;;\n"), fmt::join(listing_names(), " "));
}

std::string zsh_script(CLI::App const& app) {
  return fmt::format(R"(#compdef brouwer
_brouwer() {{
  local -a options
  if ((CURRENT == 2)); then
    compadd -- {0} --help --version
    return
  fi
  case ${{words[2]}} in
{1}  esac
  if [[ $PREFIX == -* ]]; then
    compadd -- $options
  elif [[ ${{words[2]}} == list ]]; then
    compadd -- {2}
  else
    _files
  fi
}}
_brouwer "$@"
)",
                     names_of(app), branches(app, "    {}) options=({}) ;;\n"), fmt::join(listing_names(), " "));
}

}  // namespace

std::string completion_script(std::string const& shell, CLI::App const& app) {
  if (shell == "bash") return bash_script(app);
  if (shell == "zsh") return zsh_script(app);
  throw InputError(fmt::format("there is no completion for '{}'{}", shell, suggestion(shell, {"bash", "zsh"})));
}

}  // namespace brouwer
