#include "parser/ast/dump.h"

#include <fmt/format.h>
#include <iterator>
#include <string_view>

#include "parser/ast/operators.h"

namespace alhazen::ast {
namespace {

// Lines are written before the parts of a node, which stand one level deeper.
class Dumper {
 public:
  explicit Dumper(DumpStyle style) : style_(style) {}

  void file(const File& file);
  std::string take() { return std::move(out_); }

 private:
  template <class... Args>
  void line(SourceSpan span, fmt::format_string<Args...> format, Args&&... args) {
    const auto out = std::back_inserter(out_);
    fmt::format_to(out, "{:{}}", "", 2 * depth_);
    fmt::format_to(out, format, std::forward<Args>(args)...);
    if (style_.spans) fmt::format_to(out, " @{}-{}", span.begin, span.end);
    out_ += '\n';
  }
  template <class... Parts>
  void deeper(const Parts&... parts) {
    ++depth_;
    (part(parts), ...);
    --depth_;
  }

  void part(const ExprPtr& expr) {
    if (expr) expression(*expr);
  }
  void part(const Body& body) { this->body(body); }
  void part(List<ExprPtr> list) {
    for (const ExprPtr& expr : list)
      part(expr);
  }
  void part(List<ItemPtr> list) {
    for (const ItemPtr& item : list)
      this->item(*item);
  }
  void part(List<Argument> arguments);
  void part(List<Parameter> parameters);

  void comments(std::string_view where, List<Comment> comments);
  void body(const Body& body);
  void item(const Item& item);
  void expression(const Expr& expr);

  void node(SourceSpan at, const Let& let);
  void node(SourceSpan at, const Param& param);
  void node(SourceSpan at, const Function& function);
  void node(SourceSpan at, const For& loop);
  void node(SourceSpan at, const If& branch);
  void node(SourceSpan at, const Include& include) { line(at, "include {:?}", include.path); }
  void node(SourceSpan at, const Assert& assertion);
  void node(SourceSpan at, const Print& print);
  void node(SourceSpan at, const Return& statement);
  void node(SourceSpan at, const Placement& placement);
  void node(SourceSpan at, const Property& property);
  void node(SourceSpan at, const ErrorItem&) { line(at, "error"); }

  void node(SourceSpan at, const NumberLiteral& number) { line(at, "number {}", number.value); }
  void node(SourceSpan at, const AngleLiteral& angle);
  void node(SourceSpan at, const StringLiteral& string) { line(at, "string {:?}", string.value); }
  void node(SourceSpan at, const HexColor& color);
  void node(SourceSpan at, const BoolLiteral& boolean) { line(at, "{}", boolean.value); }
  void node(SourceSpan at, const NameRef& reference) { line(at, "name {}", reference.name); }
  void node(SourceSpan at, const VectorLiteral& vector);
  void node(SourceSpan at, const ListLiteral& list);
  void node(SourceSpan at, const Parenthesized& parenthesized);
  void node(SourceSpan at, const Unary& unary);
  void node(SourceSpan at, const Binary& binary);
  void node(SourceSpan at, const Range& range);
  void node(SourceSpan at, const Conditional& conditional);
  void node(SourceSpan at, const Member& member);
  void node(SourceSpan at, const Index& index);
  void node(SourceSpan at, const Call& call);
  void node(SourceSpan at, const Block& block);
  void node(SourceSpan at, const ErrorExpr&) { line(at, "error"); }

  DumpStyle style_;
  int depth_ = 0;
  std::string out_;
};

void Dumper::file(const File& file) {
  line(file.header, "file, version {}", file.version);
  comments("header", file.header_trailing);
  deeper(file.items);
  comments("dangling", file.dangling);
}

void Dumper::comments(std::string_view where, List<Comment> comments) {
  if (!style_.comments) return;
  ++depth_;
  for (const Comment& comment : comments)
    line(comment.span, "{} comment {:?}", where, comment.text);
  --depth_;
}

void Dumper::body(const Body& body) {
  line(body.span, "body");
  deeper(body.items);
  comments("dangling", body.dangling);
}

void Dumper::item(const Item& item) {
  std::visit([&](const auto& what) { node(item.span, what); }, item.node);
  comments("leading", item.leading);
  comments("interior", item.interior);
  comments("trailing", item.trailing);
}

void Dumper::expression(const Expr& expr) {
  std::visit([&](const auto& what) { node(expr.span, what); }, expr.node);
}

void Dumper::part(List<Argument> arguments) {
  for (const Argument& argument : arguments) {
    if (argument.name) {
      line(argument.name->span, "argument {}", argument.name->text);
      deeper(argument.value);
    } else {
      part(argument.value);
    }
  }
}

void Dumper::part(List<Parameter> parameters) {
  for (const Parameter& parameter : parameters) {
    line(parameter.name.span, "parameter {}", parameter.name.text);
    deeper(parameter.default_value);
  }
}

void Dumper::node(SourceSpan at, const Let& let) {
  line(at, "let {}", let.name.text);
  deeper(let.value);
}

void Dumper::node(SourceSpan at, const Param& param) {
  line(at, "param {}", param.name.text);
  deeper(param.value, param.range, param.text);
}

void Dumper::node(SourceSpan at, const Function& function) {
  line(at, "fn {}", function.name.text);
  deeper(function.parameters);
  std::visit([&](const auto& what) { deeper(what); }, function.body);
}

void Dumper::node(SourceSpan at, const For& loop) {
  line(at, "for {}", loop.variable.text);
  deeper(loop.sequence, loop.body);
}

void Dumper::node(SourceSpan at, const If& branch) {
  line(at, "if");
  deeper(branch.condition, branch.then_body);
  if (const auto* item = std::get_if<ItemPtr>(&branch.else_branch)) {
    line(at, "else");
    ++depth_;
    this->item(**item);
    --depth_;
  } else if (const auto* body = std::get_if<Body>(&branch.else_branch)) {
    line(at, "else");
    deeper(*body);
  }
}

void Dumper::node(SourceSpan at, const Assert& assertion) {
  line(at, "assert");
  deeper(assertion.condition, assertion.message);
}

void Dumper::node(SourceSpan at, const Print& print) {
  line(at, "print");
  deeper(print.values);
}

void Dumper::node(SourceSpan at, const Return& statement) {
  line(at, "return");
  deeper(statement.value);
}

void Dumper::node(SourceSpan at, const Placement& placement) {
  line(at, "placement");
  deeper(placement.object);
}

void Dumper::node(SourceSpan at, const Property& property) {
  line(at, "property {}", property.name.text);
  std::visit([&](const auto& what) { deeper(what); }, property.value);
}

void Dumper::node(SourceSpan at, const AngleLiteral& angle) {
  line(at, "angle {} {}", angle.value, angle.unit == AngleUnit::deg ? "deg" : "rad");
}

void Dumper::node(SourceSpan at, const HexColor& color) {
  line(at, "colour {} {} {}", color.red, color.green, color.blue);
}

void Dumper::node(SourceSpan at, const VectorLiteral& vector) {
  line(at, "vector");
  deeper(vector.components);
}

void Dumper::node(SourceSpan at, const ListLiteral& list) {
  line(at, "list");
  deeper(list.elements);
}

void Dumper::node(SourceSpan at, const Parenthesized& parenthesized) {
  line(at, "parentheses");
  deeper(parenthesized.inner);
}

void Dumper::node(SourceSpan at, const Unary& unary) {
  line(at, "{}", spelling(unary.op));
  deeper(unary.operand);
}

void Dumper::node(SourceSpan at, const Binary& binary) {
  line(at, "{}", spelling(binary.op));
  deeper(binary.left, binary.right);
}

void Dumper::node(SourceSpan at, const Range& range) {
  line(at, "range {}", range.inclusive ? "..=" : "..");
  deeper(range.first, range.last, range.step);
}

void Dumper::node(SourceSpan at, const Conditional& conditional) {
  line(at, "if then else");
  deeper(conditional.condition, conditional.then_value, conditional.else_value);
}

void Dumper::node(SourceSpan at, const Member& member) {
  line(at, "member {}", member.member.text);
  deeper(member.object);
}

void Dumper::node(SourceSpan at, const Index& index) {
  line(at, "index");
  deeper(index.object, index.index);
}

void Dumper::node(SourceSpan at, const Call& call) {
  line(at, "call");
  deeper(call.callee, call.arguments);
}

void Dumper::node(SourceSpan at, const Block& block) {
  line(at, "object");
  deeper(block.head, block.body);
}

}  // namespace

std::string dump(const File& file, DumpStyle style) {
  Dumper dumper(style);
  dumper.file(file);
  return dumper.take();
}

}  // namespace alhazen::ast
