// parser/eval: names, texts and equality of values.
#include "parser/eval/value.h"

#include <array>
#include <charconv>
#include <fmt/format.h>

#include "core/base/overloaded.h"
#include "parser/eval/builtin/builtin.h"

namespace alhazen::parser {
namespace {

struct TypeWords {
  std::string_view name, with_article;
};
constexpr std::array<TypeWords, kTypeCount> kTypeWords = {{
    {"error", "an error"},
    {"number", "a number"},
    {"angle", "an angle"},
    {"bool", "a bool"},
    {"string", "a string"},
    {"vector of two", "a vector of two"},
    {"vector", "a vector"},
    {"vector of angles", "a vector of angles"},
    {"colour", "a colour"},
    {"list", "a list"},
    {"range", "a range"},
    {"function", "a function"},
    {"function", "a function"},
    {"texture", "a texture"},
    {"highlight", "a highlight"},
    {"material", "a material"},
    {"object", "an object"},
    {"transform", "a transform"},
}};

class Printer {
 public:
  explicit Printer(std::size_t max_length) : max_length_(max_length) {}

  void print(const Value& value, bool quoted) {
    if (out_.size() > max_length_) return;
    value.storage.visit(Overloaded{
        [&](Poison) { out_ += "<error>"; }, [&](double n) { out_ += number_text(n); },
        [&](Angle a) { out_ += number_text(a.deg) + "deg"; },
        [&](bool b) { out_ += b ? "true" : "false"; },
        [&](const Text& t) { out_ += quoted ? quote(*t.bytes) : *t.bytes; },
        [&](Vec2d v) { out_ += fmt::format("<{}, {}>", number_text(v.x), number_text(v.y)); },
        [&](Vec3d v) { triple("<", v.x, v.y, v.z, "", ">"); },
        [&](AngleVector v) { triple("<", v.deg.x, v.deg.y, v.deg.z, "deg", ">"); },
        [&](Rgbd c) { triple("rgb(", c.r, c.g, c.b, "", ")"); },
        [&](const ListPtr& list) { print(list->elements); },
        [&](const IntervalPtr& range) { print(*range); },
        [&](const Function&) { out_ += "<function>"; },
        [&](const BuiltinFunction* f) { out_ += fmt::format("<function {}>", f->name); },
        [&](TextureRef) { out_ += "<texture>"; },
        [&](const HighlightPtr&) { out_ += "<highlight>"; },
        [&](MaterialRef) { out_ += "<material>"; }, [&](const Object&) { out_ += "<object>"; },
        [&](const TransformPtr&) { out_ += "<transform>"; }});
  }

  std::string take() {
    if (out_.size() > max_length_) {
      out_.resize(max_length_);
      out_ += "...";
    }
    return std::move(out_);
  }

 private:
  void triple(std::string_view open, double a, double b, double c, std::string_view unit,
              std::string_view close) {
    out_ += fmt::format("{}{}{}, {}{}, {}{}{}", open, number_text(a), unit, number_text(b), unit,
                        number_text(c), unit, close);
  }
  void print(const std::vector<Value>& elements) {
    out_ += "[";
    for (std::size_t i = 0; i < elements.size() && out_.size() <= max_length_; ++i) {
      if (i > 0) out_ += ", ";
      print(elements[i], true);
    }
    out_ += "]";
  }
  void print(const Interval& range) {
    const char* unit = range.of_angles ? "deg" : "";
    out_ += fmt::format("{}{} {} {}{}", number_text(range.first), unit,
                        range.inclusive ? "..=" : "..", number_text(range.last), unit);
    if (range.has_step) out_ += fmt::format(" by {}{}", number_text(range.step), unit);
  }
  static std::string quote(std::string_view text) {
    std::string out = "\"";
    for (const char byte : text) {
      if (byte == '"' || byte == '\\') out += '\\';
      if (byte == '\n') {
        out += "\\n";
      } else if (byte == '\t') {
        out += "\\t";
      } else {
        out += byte;
      }
    }
    return out + '"';
  }

  std::size_t max_length_;
  std::string out_;
};

}  // namespace

double Interval::count() const {
  constexpr double kMost = 0x1p53;
  const double span = (last - first) / step;
  if (!(span >= 0)) return 0;
  if (!(span < kMost)) return kMost;
  // The quotient is rounded; whether the last candidate belongs is asked of the value itself, the
  // one that the loop will see.
  double n = round_down(span);
  const auto before_end = [&](double k) {
    const double value = first + k * step;
    if (inclusive) return step > 0 ? value <= last : value >= last;
    return step > 0 ? value < last : value > last;
  };
  if (before_end(n)) ++n;
  while (n > 0 && !before_end(n - 1))
    --n;
  return n;
}

std::string_view type_name(Type type) {
  return kTypeWords[static_cast<std::size_t>(type)].name;
}
std::string_view a_type_name(Type type) {
  return kTypeWords[static_cast<std::size_t>(type)].with_article;
}

std::string describe(TypeSet types) {
  std::vector<std::string_view> words;
  for (int i = 1; i < kTypeCount; ++i) {
    const auto type = static_cast<Type>(i);
    if ((types & set_of(type)) == 0) continue;
    if (words.empty() || words.back() != a_type_name(type)) words.push_back(a_type_name(type));
  }
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? " or " : ", ";
    out += words[i];
  }
  return out;
}

std::string number_text(double value) {
  char buffer[32];
  // Whole numbers that people count with are written out: 1000000000 rather than 1e+09.
  const bool counts = value == round_down(value) && absolute(value) < 1e15;
  const auto end =
      counts ? std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed).ptr
             : std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

std::string to_text(const Value& value, std::size_t max_length) {
  Printer printer(max_length);
  printer.print(value, false);
  return printer.take();
}

bool equal(const Value& a, const Value& b) {
  if (a.type() != b.type()) return false;
  return a.storage.visit(
      Overloaded{[](Poison) { return true; }, [&](double n) { return n == b.number(); },
                 [&](Angle x) { return x.deg == b.as<Angle>().deg; },
                 [&](bool x) { return x == b.as<bool>(); },
                 [&](const Text& t) { return *t.bytes == b.text(); },
                 [&](Vec2d v) { return v.x == b.as<Vec2d>().x && v.y == b.as<Vec2d>().y; },
                 [&](Vec3d v) { return v == b.as<Vec3d>(); },
                 [&](AngleVector v) { return v.deg == b.as<AngleVector>().deg; },
                 [&](Rgbd c) { return c == b.as<Rgbd>(); },
                 [&](const ListPtr& list) {
                   const List& other = *b.as<ListPtr>();
                   return list.get() == &other ||
                          std::equal(list->elements.begin(), list->elements.end(),
                                     other.elements.begin(), other.elements.end(), equal);
                 },
                 [&](const IntervalPtr& r) {
                   const Interval& s = *b.as<IntervalPtr>();
                   return r->first == s.first && r->last == s.last && r->step == s.step &&
                          r->inclusive == s.inclusive && r->of_angles == s.of_angles;
                 },
                 [&](const Function& f) {
                   const auto& g = b.as<Function>();
                   return f.definition == g.definition && f.scope == g.scope;
                 },
                 [&](const BuiltinFunction* f) { return f == b.as<const BuiltinFunction*>(); },
                 [&](TextureRef t) { return t.id == b.as<TextureRef>().id; },
                 [&](const HighlightPtr& h) {
                   const Highlight& g = *b.as<HighlightPtr>().highlight;
                   return h.highlight->model == g.model && h.highlight->strength == g.strength &&
                          h.highlight->exponent == g.exponent;
                 },
                 [&](MaterialRef m) { return m.id == b.as<MaterialRef>().id; },
                 [&](const Object& o) { return o.group == b.as<Object>().group; },
                 [&](const TransformPtr& t) { return *t.matrix == *b.as<TransformPtr>().matrix; }});
}

bool is_finite(const Value& value) {
  switch (value.type()) {
    case Type::number:
      return alhazen::is_finite(value.number());
    case Type::angle:
      return alhazen::is_finite(value.as<Angle>().deg);
    case Type::vec2:
      return alhazen::is_finite(value.as<Vec2d>().x) && alhazen::is_finite(value.as<Vec2d>().y);
    case Type::vec3:
      return alhazen::is_finite(value.as<Vec3d>());
    case Type::angles:
      return alhazen::is_finite(value.as<AngleVector>().deg);
    case Type::color: {
      const auto c = value.as<Rgbd>();
      return alhazen::is_finite(Vec3d{c.r, c.g, c.b});
    }
    default:
      return true;
  }
}

}  // namespace alhazen::parser
