#include "app/nff/read.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/nff/reader.h"

namespace alhazen {

const std::array<NffReader::Entity, 8> NffReader::kEntities = {{
    {"v", "its parts once each", &NffReader::view},
    {"b", "3 numbers", &NffReader::background},
    {"l", "3 or 6 numbers", &NffReader::light},
    {"f", "8 numbers", &NffReader::fill},
    {"s", "4 numbers", &NffReader::sphere},
    {"c", "8 numbers", &NffReader::cone},
    {"p", "3 numbers for each vertex", &NffReader::polygon},
    {"pp", "6 numbers for each vertex", &NffReader::patch},
}};

const NffReader::Entity* NffReader::find_entity(std::string_view word) {
  const auto* found = std::ranges::find(kEntities, word, &Entity::keyword);
  return found == kEntities.end() ? nullptr : found;
}

std::optional<NffScene> read_nff(FileId file, const SourceManager& sources, DiagnosticSink& sink,
                                 const NffLimits& limits) {
  return NffReader(file, sources, sink, limits).read();
}

std::optional<NffScene> NffReader::read() {
  const std::size_t errors_before = sink_.error_count();
  const std::size_t zero_byte = sources_.text(file_).find('\0');
  if (zero_byte != std::string_view::npos) {
    const auto begin = static_cast<std::uint32_t>(zero_byte);
    sink_.report<DiagnosticKind::binary_file>({file_, begin, begin + 1});
    return std::nullopt;
  }
  while (!tokens_.peek().is_end() && !sink_.full() && !too_many_)
    read_entity();
  if (sink_.full()) {
    if (!tokens_.peek().is_end()) sink_.note_truncated();
    return std::nullopt;
  }
  check_whole();
  if (sink_.error_count() > errors_before) return std::nullopt;
  report_left_out();
  return std::move(scene_);
}

void NffReader::read_entity() {
  const Entity* entity = find_entity(tokens_.peek().text);
  if (entity == nullptr) {
    report_not_an_entity();
    skip_to_entity();
    return;
  }
  keyword_ = tokens_.take();
  if (!(this->*entity->production)()) skip_to_entity();
}

void NffReader::report_not_an_entity() {
  const NffToken& token = tokens_.peek();
  const Entity* last = find_entity(keyword_.text);
  const bool is_number = read_nff_number(token.text).state != NffNumberState::not_a_number;
  if (is_number && last != nullptr) {
    Diagnostic& error =
        sink_.report<DiagnosticKind::import_extra_number>(token.span, last->keyword, last->takes);
    error.label(keyword_.span, "this entity");
    if (last->keyword == "f") error.hint("the 12 numbers of the enhanced NFF are not understood");
    return;
  }
  const std::string shown = alhazen::describe(token);
  Diagnostic& error = sink_.report<DiagnosticKind::import_unknown_entity>(
      token.span, shown.substr(1, shown.size() - 2));
  if (keyword_.is_end() && (token.text == "nff" || token.text == "NFF")) {
    error.hint("this seems to be the NFF of WorldToolKit, another format of the same name");
  } else {
    error.hint("the entities are v, b, l, f, s, c, p and pp");
  }
}

void NffReader::skip_to_entity() {
  while (!tokens_.peek().is_end() && find_entity(tokens_.peek().text) == nullptr)
    tokens_.take();
}

void NffReader::check_whole() {
  const SourceSpan beginning{file_, 0, 0};
  if (too_many_) {
    sink_
        .report<DiagnosticKind::import_too_many>(keyword_.span, limits_.shapes,
                                                 "shapes, lights and changes of fill")
        .hint("a scene has no place for more; import it in parts");
    return;
  }
  if (keyword_.is_end() && sink_.error_count() == 0) {
    sink_.report<DiagnosticKind::import_no_entities>(beginning);
  } else if (!view_at_ && !keyword_.is_end()) {
    sink_.report<DiagnosticKind::import_missing>(beginning, "the file", "v")
        .hint("write `v` with from, at, up, angle, hither and resolution");
  }
}

void NffReader::report_left_out() {
  const auto more = [](Diagnostic& warning, const Noted& noted) {
    if (noted.count > 1) warning.hint(fmt::format("the same holds for {} more", noted.count - 1));
  };
  if (no_area_.count > 0) {
    more(sink_.report<DiagnosticKind::import_no_area>(no_area_.first), no_area_);
  }
  if (inside_out_.count > 0) {
    more(sink_.report<DiagnosticKind::import_inside_out>(inside_out_.first), inside_out_);
  }
}

//   b  red green blue
bool NffReader::background() {
  if (background_at_) {
    sink_.report<DiagnosticKind::import_repeated>(keyword_.span, "b")
        .label(*background_at_, "the first is here");
    return false;
  }
  background_at_ = keyword_.span;
  return color({"the colour"}, scene_.background);
}

//   l  x y z  [red green blue]
bool NffReader::light() {
  NffLight light;
  if (!vector({"the position"}, light.position)) return false;
  if (read_nff_number(tokens_.peek().text).state != NffNumberState::not_a_number) {
    if (!color({"the colour"}, light.color.emplace())) return false;
  }
  scene_.lights.push_back(light);
  too_many_ = shape_count_ + scene_.runs.size() + scene_.lights.size() > limits_.shapes;
  return true;
}

//   f  red green blue  Kd Ks Shine T index_of_refraction
bool NffReader::fill() {
  NffFill fill;
  fill.line = sources_.locate(file_, keyword_.span.begin).line;
  fill_ = fill;  // also a wrong one: what wears it is not another mistake
  fill_index_.reset();
  if (!color({"the colour"}, fill.color) || !at_least_zero({"Kd"}, fill.diffuse) ||
      !at_least_zero({"Ks"}, fill.specular) || !at_least_zero({"Shine"}, fill.shine) ||
      !at_least_zero({"T"}, fill.transmittance)) {
    return false;
  }
  if (fill.transmittance > 1) return out_of_range({"T"}, "from 0 to 1");
  if (!at_least_zero({"the index of refraction"}, fill.ior)) return false;
  fill_ = fill;
  return true;
}

}  // namespace alhazen
