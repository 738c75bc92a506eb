#include "app/cli/arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/cli/streams.h"
#include "core/base/near_name.h"

namespace alhazen {
namespace {

// The part of a number that from_chars reads, all of it or nothing.
template <class T>
std::optional<T> to_exactly(const std::string& text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, value);
  if (failure != std::errc{} || stop != end) return std::nullopt;
  return value;
}

}  // namespace

CommandLine::CommandLine(std::string_view verb, std::string description, std::string examples)
    : CLI::App(std::move(description), fmt::format("alhazen {}", verb)) {
  footer("Examples:\n" + std::move(examples));
  get_formatter()->column_width(28);
  set_help_flag("-h,--help", "print this text");
}

std::optional<ExitCode> CommandLine::read(const Arguments& arguments) {
  try {
    parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::CallForHelp&) {
    return print(help());
  } catch (const CLI::ExtrasError&) {
    return complain(unknown_words());
  } catch (const CLI::ParseError& error) {
    return complain(error.what());
  }
  return std::nullopt;
}

CLI::Option* CommandLine::text_option(const std::string& names, const char* value,
                                      std::string& target, const std::string& help) {
  const auto as_it_is = [](const std::string& text) -> Result<std::string> {
    if (text.empty()) return Error{ErrorCode::usage, "expected a value, found an empty one"};
    return text;
  };
  return value_option(names, value, target, as_it_is, help);
}

CLI::Option* CommandLine::flag(const std::string& names, bool& target, const std::string& help) {
  return add_flag(names, target, help)->group(group_);
}

CLI::Option* CommandLine::scene_argument(std::string& target) {
  return add_option("SCENE", target, "the scene file")->required()->type_name("");
}

CLI::Option* CommandLine::scene_arguments(std::vector<std::string>& targets) {
  return add_option("SCENE", targets, "the scene files")->required()->type_name("");
}

std::string CommandLine::last_name(const std::string& names) {
  return names.substr(names.rfind(',') + 1);
}

ExitCode CommandLine::complain(const std::string& message) const {
  write_stderr(fmt::format("{}: error: {}\ntry: {} --help\n", get_name(), message, get_name()));
  return ExitCode::usage;
}

std::string CommandLine::unknown_words() const {
  const std::vector<std::string> words = remaining();
  const auto unknown = std::ranges::find_if(words, [](const std::string& word) {
    return word.size() > 1 && word.front() == '-' && word != "--";
  });
  if (unknown == words.end()) return fmt::format("one word too many: `{}`", words.front());
  const std::string name = unknown->substr(0, unknown->find('='));
  std::vector<std::string> known;
  for (const CLI::Option* option : get_options()) {
    for (const std::string& long_name : option->get_lnames())
      known.push_back("--" + long_name);
  }
  const std::vector<std::string_view> candidates(known.begin(), known.end());
  const auto near = near_name(name, candidates);
  return fmt::format("unknown option `{}`{}", name,
                     near ? fmt::format("; did you mean `{}`?", *near) : "");
}

Result<std::int64_t> to_whole(const std::string& text, std::int64_t low, std::int64_t high) {
  const auto value = to_exactly<std::int64_t>(text);
  if (!value || *value < low || *value > high) {
    return Error{ErrorCode::usage,
                 fmt::format("expected a whole number from {} to {}, found `{}`", low, high, text)};
  }
  return *value;
}

Result<double> to_number(const std::string& text, double low, double high) {
  const auto value = to_exactly<double>(text);
  if (!value || !(*value >= low && *value <= high)) {
    const std::string range = std::isinf(high) ? fmt::format("of at least {}", low)
                                               : fmt::format("from {} to {}", low, high);
    return Error{ErrorCode::usage, fmt::format("expected a number {}, found `{}`", range, text)};
  }
  return *value;
}

}  // namespace alhazen
