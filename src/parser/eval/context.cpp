// parser/eval: limits and traces.
#include "parser/eval/context.h"

#include <algorithm>
#include <fmt/format.h>

namespace alhazen::parser {
namespace {

// Lists within lists are walked by recursion.
constexpr int kMaxListDepth = 500;
constexpr std::uint64_t kRecordFuel = 20;
// Of a long trace the innermost and the outermost steps say most.
constexpr std::size_t kInnermostShown = 8, kOutermostShown = 3;

}  // namespace

std::vector<TraceFrame> Context::trace() const {
  std::vector<TraceFrame> out;
  const std::size_t count = frames_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Frame& frame = frames_[count - 1 - i];
    if (count > kInnermostShown + kOutermostShown + 1 && i == kInnermostShown) {
      const std::size_t left_out = count - kInnermostShown - kOutermostShown;
      out.push_back({frame.site, fmt::format("... and {} more calls, from here", left_out)});
      i += left_out - 1;
    } else if (frame.callee.empty()) {
      out.push_back({frame.site, "included here"});
    } else {
      out.push_back({frame.site, fmt::format("in `{}`, called here", frame.callee)});
    }
  }
  return out;
}

bool Context::refuse_fuel(SourceSpan at) {
  if (halted()) return false;
  halt<DiagnosticKind::fuel_exhausted>(at, options_.limits.fuel)
      .hint("is there a recursion that does not end, or a loop within loops?");
  return false;
}

bool Context::spend_string(std::uint64_t bytes, SourceSpan at) {
  if (!spend_fuel(bytes / 16, at)) return false;
  if (bytes > options_.limits.string_bytes - string_bytes_) {
    halt<DiagnosticKind::memory_exhausted>(at, "strings", options_.limits.string_bytes, "bytes");
    return false;
  }
  string_bytes_ += bytes;
  return true;
}

bool Context::spend_list(std::uint64_t elements, SourceSpan at) {
  if (!spend_fuel(elements, at)) return false;
  if (elements > options_.limits.list_elements - list_elements_) {
    halt<DiagnosticKind::memory_exhausted>(at, "lists", options_.limits.list_elements, "elements");
    return false;
  }
  list_elements_ += elements;
  return true;
}

TextureId Context::add(Texture&& texture) {
  spend_fuel(kRecordFuel, texture.span);
  if (const auto* gradient = std::get_if<GradientPattern>(&texture.pattern)) {
    spend_list(gradient->stops.size(), texture.span);
  }
  return store_.add(std::move(texture));
}

MaterialId Context::add(Material&& material) {
  spend_fuel(kRecordFuel, material.span);
  return store_.add(std::move(material));
}

Value Context::make_text(std::string bytes, SourceSpan at) {
  if (!spend_string(bytes.size(), at)) return Poison{};
  return Text{std::make_shared<const std::string>(std::move(bytes))};
}

Value Context::make_list(std::vector<Value> elements, SourceSpan at) {
  if (!spend_list(elements.size(), at)) return Poison{};
  List list{std::move(elements)};
  for (const Value& element : list.elements) {
    if (element.is_poison()) return Poison{};
    std::uint64_t weight = 1;
    if (element.is(Type::list)) {
      const List& inner = *element.as<ListPtr>();
      list.depth = std::max(list.depth, inner.depth + 1);
      weight = inner.weight;
    } else if (element.is(Type::string)) {
      weight += element.text().size() / 16;
    }
    list.weight = std::min<std::uint64_t>(list.weight + weight, std::uint64_t{1} << 62);
  }
  if (list.depth > kMaxListDepth) {
    halt<DiagnosticKind::nested_too_deep>(at, "lists", kMaxListDepth);
    return Poison{};
  }
  return std::make_shared<const List>(std::move(list));
}

}  // namespace alhazen::parser
