// app/cli: what the verbs' command lines have in common. Each value is checked where it is read,
// and every complaint names the option, what it expects and what it found.
#pragma once

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>

#include "app/cli/verb.h"

namespace alhazen {

// The command line of one verb. `examples` ends the help text.
class CommandLine : public CLI::App {
 public:
  CommandLine(std::string_view verb, std::string description, std::string examples);

  // Reads the words. A code means that the verb is over: help was printed, or a complaint.
  std::optional<ExitCode> read(const Arguments& arguments);

  // A usage error of this verb, on stderr.
  ExitCode complain(const std::string& message) const;

  // An option with one value that `convert` turns into a Result<T>; without the option, `target`
  // stays as it is. `value` is how the help names the value: N, WxH.
  template <class T, class Convert>
  CLI::Option* value_option(const std::string& names, const char* value, T& target,
                            const Convert& convert, const std::string& help) {
    const auto read_value = [this, names, &target, convert](const std::string& text) {
      auto converted = convert(text);
      if (!converted) throw CLI::ValidationError(last_name(names), converted.error().message);
      target = std::move(converted).value();
    };
    CLI::Option* option = add_option_function<std::string>(names, read_value, help);
    return option->type_name(value)->group(group_);
  }
  // The same for an option that may be repeated: `targets` gets one value from each.
  template <class T, class Convert>
  CLI::Option* list_option(const std::string& names, const char* value, std::vector<T>& targets,
                           const Convert& convert, const std::string& help) {
    const auto read_values = [this, names, &targets,
                              convert](const std::vector<std::string>& texts) {
      for (const std::string& text : texts) {
        auto converted = convert(text);
        if (!converted) throw CLI::ValidationError(last_name(names), converted.error().message);
        targets.push_back(std::move(converted).value());
      }
    };
    CLI::Option* option = add_option_function<std::vector<std::string>>(names, read_values, help);
    return option->type_name(value)->allow_extra_args(false)->group(group_);
  }
  CLI::Option* text_option(const std::string& names, const char* value, std::string& target,
                           const std::string& help);
  CLI::Option* flag(const std::string& names, bool& target, const std::string& help);
  CLI::Option* scene_argument(std::string& target);
  CLI::Option* scene_arguments(std::vector<std::string>& targets);

  // The heading in the help under which the options from now on stand.
  void begin_group(std::string heading) { group_ = std::move(heading); }

 private:
  static std::string last_name(const std::string& names);
  std::string unknown_words() const;

  std::string group_ = "Options";
};

// Values, as value_option wants them.
Result<std::int64_t> to_whole(const std::string& text, std::int64_t low, std::int64_t high);
Result<double> to_number(const std::string& text, double low, double high);

}  // namespace alhazen
