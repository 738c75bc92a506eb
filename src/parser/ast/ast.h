// parser/ast: what the author wrote, as a tree. Nothing is evaluated and nothing is lost: every
// node knows its span, names know theirs, and comments hang on the items they belong to. Nodes live
// in the arena of their tree, and most of their texts in the SourceManager's, which outlives it.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "core/diag/source.h"
#include "parser/ast/arena.h"

namespace alhazen::ast {

struct Expr;
struct Item;
using ExprPtr = const Expr*;  // never null in a finished tree unless a field says so
using ItemPtr = const Item*;
template <class T>
using List = std::span<const T>;

struct Name {
  std::string_view text;
  SourceSpan span;
};

// `text` with its delimiters: "// like this" or "/* so */".
struct Comment {
  std::string_view text;
  SourceSpan span;
  bool blank_line_before = false;
};

// "{" items "}". `dangling` are the comments after the last item.
struct Body {
  SourceSpan span;
  List<ItemPtr> items;
  List<Comment> dangling;
};

// ---- expressions ------------------------------------------------------------------------------

struct NumberLiteral {
  double value;
};
enum class AngleUnit { deg, rad };
struct AngleLiteral {
  double value;  // in `unit`, as written
  AngleUnit unit;
};
struct StringLiteral {
  std::string_view value;  // escapes resolved
};
struct HexColor {
  int red, green, blue;  // 0 to 255, sRGB
};
struct BoolLiteral {
  bool value;
};
struct NameRef {
  std::string_view name;
};
struct VectorLiteral {
  List<ExprPtr> components;  // two or three
};
struct ListLiteral {
  List<ExprPtr> elements;
};
struct Parenthesized {
  ExprPtr inner = nullptr;
};

enum class UnaryOperator { negate, logical_not };
struct Unary {
  UnaryOperator op;
  SourceSpan op_span;
  ExprPtr operand = nullptr;
};

enum class BinaryOperator {
  add,
  subtract,
  multiply,
  divide,
  remainder,
  power,
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  not_equal,
  logical_and,
  logical_or,
};
struct Binary {
  BinaryOperator op;
  SourceSpan op_span;
  ExprPtr left = nullptr, right = nullptr;
};

struct Range {
  ExprPtr first = nullptr, last = nullptr;
  bool inclusive = false;  // ..= rather than ..
  ExprPtr step = nullptr;  // null without `by`
};
struct Conditional {
  ExprPtr condition = nullptr, then_value = nullptr, else_value = nullptr;
};
struct Member {
  ExprPtr object = nullptr;
  Name member;
};
struct Index {
  ExprPtr object = nullptr, index = nullptr;
};
struct Argument {
  std::optional<Name> name;
  ExprPtr value = nullptr;
};
struct Call {
  ExprPtr callee = nullptr;
  List<Argument> arguments;
  SourceSpan arguments_span;  // with the parentheses
};
// `head { ... }`: head is a NameRef or a Call. Whether it makes a new glass or varies a value of
// that name is for eval to say.
struct Block {
  ExprPtr head = nullptr;
  Body body;
};
// Stands where something could not be parsed; the diagnostic has been reported.
struct ErrorExpr {};

struct Expr {
  SourceSpan span;
  std::variant<NumberLiteral, AngleLiteral, StringLiteral, HexColor, BoolLiteral, NameRef,
               VectorLiteral, ListLiteral, Parenthesized, Unary, Binary, Range, Conditional, Member,
               Index, Call, Block, ErrorExpr>
      node;
  int height = 1;  // levels of the tree from here down; ParseLimits bounds it
};

// ---- items ------------------------------------------------------------------------------------

struct Let {
  Name name;
  ExprPtr value = nullptr;
};
struct Param {
  Name name;
  ExprPtr value = nullptr;
  ExprPtr range = nullptr;  // null without `in`
  ExprPtr text = nullptr;   // null if there is none
};
struct Parameter {
  Name name;
  ExprPtr default_value = nullptr;  // null if there is none
};
struct Function {
  Name name;
  List<Parameter> parameters;
  std::variant<ExprPtr, Body> body;  // `= expression`, or items that place shapes or return a value
};
struct For {
  Name variable;
  ExprPtr sequence = nullptr;
  Body body;
};
struct If {
  ExprPtr condition = nullptr;
  Body then_body;
  std::variant<std::monostate, ItemPtr, Body> else_branch;  // the item is an If
};
struct Include {
  std::string_view path;
  SourceSpan path_span;
};
struct Assert {
  ExprPtr condition = nullptr;
  ExprPtr message = nullptr;  // null if there is none
};
struct Print {
  List<ExprPtr> values;
};
struct Return {
  ExprPtr value = nullptr;
};
// `radius 2`, `material glass { ... }`, `sphere { ... }`, `camera perspective { ... }`.
struct Property {
  Name name;
  std::variant<ExprPtr, Body> value;
};
// `tower(3)`, `tower(3) { translate x }` where an item stands: the object, a Call or a Block whose
// head is a Call, takes its place in the scene.
struct Placement {
  ExprPtr object = nullptr;
};
struct ErrorItem {};

struct Item {
  SourceSpan span;
  List<Comment> leading;           // on the lines before
  List<Comment> interior;          // between its tokens, outside of its bodies
  List<Comment> trailing;          // on the same line, after
  bool blank_line_before = false;  // one blank line of the author's is kept by the formatter
  std::variant<Let, Param, Function, For, If, Include, Assert, Print, Return, Placement, Property,
               ErrorItem>
      node;
};

struct File {
  Arena arena;
  FileId id = kNoFile;
  int version = 1;
  SourceSpan header;
  List<Comment> header_trailing;  // on the header's line
  List<ItemPtr> items;
  List<Comment> dangling;  // after the last item
};

// An expression that is a text of its own.
struct WholeExpr {
  Arena arena;
  ExprPtr root = nullptr;
};

}  // namespace alhazen::ast
